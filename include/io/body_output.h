// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_body_output_h
#define io_body_output_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "io/point_field.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The fields of the body for ParaView: for each cell a patch with as many
  /// points as a displacement component has nodes there.
  ///
  /// Stresses and strains live at the quadrature points. Their L2 projection
  /// onto discontinuous polynomials of the element's degree is the
  /// interpolation of the point values, here evaluated at the points of the
  /// patch: nothing is averaged, and neighbouring cells need not agree. What
  /// cannot be negative, von Mises' stress and the equivalent plastic strain,
  /// is cut off at zero where the polynomial overshoots. Tensors have all three
  /// dimensions; in an axisymmetric body, the third is that around the axis.
  ///
  /// The cells are written in pieces of a file as they come from the solid, so
  /// that memory for only a few of them is needed.
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
    empty() const;

    /// Writes the locally owned cells. All ranks that have some must call this.
    /// @throws StandardExceptions::ExcIO
    void
    write_vtu(std::ostream &out) const;

    /// Writes the index of the files of all ranks.
    void
    write_pvtu_record(std::ostream                   &out,
                      const std::vector<std::string> &file_names) const;

  private:
    using Patch = DataOutBase::Patch<dim, dim>;
    using Range =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    /// A name for each row of a patch's data: the displacement, the fields of
    /// points, and those of cells.
    std::vector<std::string>
    row_names() const;

    /// Which rows are vectors and tensors.
    std::vector<Range>
    vectors_and_tensors() const;

    Patch
    make_patch(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const std::vector<PointResult> &points) const;

    /// The fields of @p points at the points of the patch, from @p first_row
    /// of its @p data on.
    void
    extrapolate(const std::vector<PointResult> &points,
                const unsigned int              first_row,
                dealii::Table<2, float>        &data) const;

    const DoFHandler<dim>    &dof_handler;
    const VectorType         &displacement;
    const SolidOperator<dim> &solid;
    const Vector<float>      &error_indicators;

    const std::vector<PointField>   fields;
    const unsigned int              degree;
    const VectorType                ghosted_displacement;
    const std::vector<unsigned int> to_lexicographic;

    /// Entry (q, i): the weight of quadrature point q at point i of a patch.
    const FullMatrix<float>     extrapolation;
    const DataOutBase::VtkFlags flags;
  };
} // namespace ElastoPlastic

#endif
