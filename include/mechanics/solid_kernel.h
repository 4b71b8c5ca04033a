// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_solid_kernel_h
#define mechanics_solid_kernel_h

#include <array>
#include <functional>

#include "base/single_precision_storage.h"
#include "mechanics/cell_kernel.h"
#include "mechanics/point_tangents.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// The strain, small or logarithmic, and what belongs to it, at the
  /// quadrature points of a batch of cells, which are in the order of
  /// QGauss<dim>(degree + 1).
  template <int dim>
  struct CellStrains
  {
    using Number = Simd<double>;

    static constexpr unsigned int max_points = PointTangents<dim>::max_points;

    unsigned int batch, n_points;
    /// A sheet's has no strain out of plane: the material says what it is.
    std::array<SymmetricTensor<2, 3, Number>, max_points> strain;
    /// Point values or, for B-bar, the cell mean.
    std::array<Number, max_points> volumetric;
    /// The volume (in plane strain: the area) that the point stands for, before
    /// the deformation.
    std::array<Number, max_points> volume;
  };



  /// What the finite element method does with a body: displacements -> strains,
  /// and stresses -> nodal forces; and with its tangent. Nothing is known here
  /// of materials.
  ///
  /// For B-bar, the mean of tr(v) in the weak form may be replaced by the trace
  /// of strain(v) itself, because the pressure p = K tr(u) is constant on the
  /// cell. If strains are finite, strain(v) and tr(v) stand for their
  /// derivatives at u in the direction v.
  template <int dim>
  class SolidKernel : public CellKernel<dim, PointTangents<dim>>
  {
  public:
    using typename CellKernel<dim, PointTangents<dim>>::Number;
    using typename CellKernel<dim, PointTangents<dim>>::Vector;
    using Strains = CellStrains<dim>;
    using Stresses =
      std::array<SymmetricTensor<2, 3, Number>, Strains::max_points>;
    /// Makes stresses, the conjugates of the strains, of these.
    using Law = std::function<void(const Strains &, Stresses &)>;

    using CellKernel<dim, PointTangents<dim>>::CellKernel;

    /// Calls @p receive for all cell batches with the strains of the
    /// displacement fields @p fields.
    virtual void
    for_each_batch(const std::vector<const Vector *> &fields,
                   const std::function<void(const std::vector<Strains> &)>
                     &receive) const = 0;

    /// The nodal forces int stress : strain(phi_i) dx, where @p law makes
    /// stresses of the strains of @p u.
    virtual void
    integrate(Vector &forces, const Vector &u, const Law &law) const = 0;

    /// int stress : strain(w) dx for one field @p w instead of the shape
    /// functions, of the cells of this rank.
    virtual double
    work(const Vector &u, const Vector &w, const Law &law) const = 0;

    /// Calls @p law, which besides the stresses sets the @p tangents with
    /// respect to strains, and makes of them what products need.
    virtual void
    linearize(PointTangents<dim> &tangents,
              const Vector       &u,
              const Law          &law) const = 0;

    /// The number of pressures of a cell in the mixed form: one for each
    /// volumetric strain, with B-bar a single one.
    virtual unsigned int
    n_pressures() const = 0;

    /// Makes a vector of all pressures. These belong to this rank's cell
    /// batches, one pressure after the other, each for all lanes.
    virtual void
    initialize_pressures(Vector &pressures) const = 0;

    /// The product of the mixed form of the tangent (TangentOperator) with a
    /// vector of displacements and pressures.
    virtual void
    mixed_vmult(BlockVectorType          &result,
                const BlockVectorType    &vector,
                const PointTangents<dim> &tangents) const = 0;

    /// The number of unknowns of a cell.
    virtual unsigned int
    n_cell_dofs() const = 0;

    /// For each cell a vector of so many entries, batch by batch.
    using CellRows = SinglePrecisionStorage<Number>;

    /// With B-bar, the changes of the mean volumetric strain with the unknowns
    /// of each cell, times the root of its volume.
    virtual void
    volumetric_rows(CellRows                 &rows,
                    const PointTangents<dim> &tangents) const = 0;

    /// The products of the cells' @p rows with @p u, one for each cell; and the
    /// transpose, the @p forces of such @p pressures.
    virtual void
    multiply_rows(Vector         &pressures,
                  const CellRows &rows,
                  const Vector   &u) const = 0;

    virtual void
    multiply_transposed_rows(Vector         &forces,
                             const CellRows &rows,
                             const Vector   &pressures) const = 0;

    /// The diagonal of a tangent that is a multiple of the identity on each
    /// cell, see diagonal(). @p factors has one entry for each cell.
    virtual void
    diagonal_of_multiples(Vector &values, const Vector &factors) const = 0;

    /// Calls @p receive for all cell batches with the strains of @p u and the
    /// true stresses that belong to those of @p law.
    virtual void
    for_each_true_stress(
      const Vector                                                 &u,
      const Law                                                    &law,
      const std::function<void(const Strains &, const Stresses &)> &receive)
      const = 0;
  };



  /// The kernel for FE_Q(@p degree)^dim. (Each dimension has a file of its own:
  /// they take long to compile.)
  template <int dim>
  std::unique_ptr<SolidKernel<dim>>
  make_solid_kernel(const unsigned int degree, const StrainModel &strain_model);

  template <>
  std::unique_ptr<SolidKernel<2>>
  make_solid_kernel(const unsigned int degree, const StrainModel &strain_model);

  template <>
  std::unique_ptr<SolidKernel<3>>
  make_solid_kernel(const unsigned int degree, const StrainModel &strain_model);
} // namespace ElastoPlastic

#endif
