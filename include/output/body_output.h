// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_body_output_h
#define output_body_output_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <string>
#include <vector>

#include "mechanics/solid_operator.h"
#include "output/appended_vtu.h"
#include "output/output_parameters.h"

namespace ElastoPlastic
{
  /// A field that is known at the quadrature points: a number, or a tensor of
  /// three dimensions.
  struct PointField
  {
    std::string  name;
    std::string  quantity;     ///< as in Units::of(), such as "stress"
    unsigned int n_components; ///< 1, or those of the tensor, row by row
    /// Whether it must not become negative where it is extrapolated.
    bool is_positive;
    /// Writes the components.
    std::function<void(const PointResult &point, float *values)> evaluate;
  };



  /// Those that are always written, with the rate of the equivalent plastic
  /// strain if the body @p is_rate_dependent, and then the @p additional ones,
  /// each once.
  std::vector<PointField>
  point_fields(const std::vector<AdditionalField> &additional,
               const bool                          is_rate_dependent);



  /// The fields of the body for ParaView: for each cell a grid of as many
  /// points as a displacement component has nodes there.
  ///
  /// Stresses and strains live at the quadrature points. Their L2 projection
  /// onto discontinuous polynomials of the element's degree is the
  /// interpolation of the point values, here evaluated at the points of the
  /// grid: nothing is averaged, and neighbouring cells need not agree. What
  /// cannot be negative, von Mises' stress, the equivalent plastic strain and
  /// its rate, is cut off at zero where the polynomial overshoots. Tensors have
  /// all three dimensions; in an axisymmetric body, the third is that around
  /// the axis.
  ///
  /// The cells are written in pieces of a file as they come from the solid, so
  /// that memory for only a few of them is needed. (deal.II's DataOut holds the
  /// patches of all cells at once.)
  template <int dim>
  class BodyOutput
  {
  public:
    /// The first arguments must outlive this object; @p error_indicators has an
    /// entry for each active cell. @p parameters say which fields are written
    /// and what their units are called.
    BodyOutput(const DoFHandler<dim>    &dof_handler,
               const VectorType         &displacement,
               const SolidOperator<dim> &solid,
               const Vector<float>      &error_indicators,
               const OutputParameters   &parameters);

    /// Whether there are no locally owned cells.
    bool
    empty() const
    {
      return n_cells() == 0;
    }

    /// Writes the locally owned cells. All ranks that have some must call this.
    /// @throws StandardExceptions::ExcIO
    void
    write_vtu(std::ostream &out) const;

    /// Writes the index of the files of all ranks.
    void
    write_pvtu_record(std::ostream                   &out,
                      const std::vector<std::string> &file_names) const;

  private:
    /// The number of cells of this rank.
    unsigned int
    n_cells() const;

    /// The fields in the order of the file: the displacement, those of points,
    /// and those of cells.
    std::vector<AppendedVtu::Field>
    vtu_fields() const;

    /// Room for so many cells, with the connections of their points.
    AppendedVtu::Piece
    make_piece(const unsigned int n_cells) const;

    /// Adds a cell to those whose numbers @p piece has already.
    void
    add_cell(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const std::vector<PointResult>                       &points,
             AppendedVtu::Piece                                   &piece) const;

    /// The points of its grid.
    void
    add_points(const typename DoFHandler<dim>::active_cell_iterator &cell,
               std::vector<float> &numbers) const;

    /// The displacement there.
    void
    add_displacement(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     std::vector<float> &numbers) const;

    /// The fields that are known at its quadrature points @p points there, each
    /// to an entry of @p numbers.
    void
    add_extrapolated(const std::vector<PointResult> &points,
                     std::vector<float>             *numbers) const;

    const DoFHandler<dim>    &dof_handler;
    const VectorType         &displacement;
    const SolidOperator<dim> &solid;
    const Vector<float>      &error_indicators;
    const Units              &units;

    const std::vector<PointField>   fields;
    const unsigned int              degree;
    const VectorType                ghosted_displacement;
    const std::vector<unsigned int> to_lexicographic;

    /// The points of a cell of the reference mesh, in lexicographic order; and
    /// entry (q, i) of the matrix: the weight of quadrature point q at point i.
    const std::vector<Point<dim>> reference_points;
    const FullMatrix<float>       extrapolation;
  };
} // namespace ElastoPlastic

#endif
