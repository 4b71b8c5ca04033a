// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_cell_kernel_h
#define mechanics_cell_kernel_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <memory>
#include <vector>

#include "base/kinematics.h"
#include "mechanics/eliminated_unknowns.h"
#include "mechanics/nodal_access.h"
#include "mechanics/tangents.h"
#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What the finite element method does with the tangent of a body, on the
  /// cells of one mesh, with one class of tangents (tangents.h,
  /// point_tangents.h). The weak form is
  ///   int s(u) : strain(v) + p(u) tr(v) dx,
  /// with the volumetric strain tr, point by point or, for B-bar, its mean.
  ///
  /// There is one implementation, for all strain models and degrees of the
  /// elements, which are fixed when it is made: what depends on them is
  /// virtual here, but nothing is within a loop.
  ///
  /// Vectors passed in need no ghost values, and have none afterwards;
  /// displacements must satisfy the constraints. Forces come out condensed, and
  /// zero at eliminated unknowns.
  template <int dim, typename TangentsType>
  class CellKernel
  {
  public:
    using Tangents = TangentsType;
    using Number   = typename Tangents::Number;
    using Vector =
      LinearAlgebra::distributed::Vector<typename Tangents::value_type>;
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    explicit CellKernel(const StrainModel &strain_model)
      : strain_model(strain_model)
    {}

    virtual ~CellKernel() = default;

    /// Prepares everything that depends on the mesh. The first two arguments
    /// must outlive this object or the next call.
    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints);

    void
    initialize_vector(Vector &vector) const
    {
      matrix_free.initialize_dof_vector(vector);
    }

    /// The number of the mesh's active cells, those of other ranks included.
    unsigned int
    n_active_cells() const
    {
      return matrix_free.get_dof_handler().get_triangulation().n_active_cells();
    }

    unsigned int
    n_batches() const
    {
      return matrix_free.n_cell_batches();
    }

    /// The number of cells in a batch.
    unsigned int
    n_cells(const unsigned int batch) const
    {
      return matrix_free.n_active_entries_per_cell_batch(batch);
    }

    CellIterator
    cell(const unsigned int batch, const unsigned int lane) const
    {
      return matrix_free.get_cell_iterator(batch, lane);
    }

    /// The local indices of the eliminated unknowns.
    const std::vector<unsigned int> &
    eliminated_entries() const
    {
      return matrix_free.get_constrained_dofs();
    }

    /// The product of the tangent with @p increment; with ReferenceTangents, an
    /// approximation on cells that are no parallelepipeds.
    virtual void
    vmult(Vector         &forces,
          const Vector   &increment,
          const Tangents &tangents) const = 0;

    /// The diagonal of the tangent. For the masters of eliminated unknowns it
    /// is an approximation: each gets its share of their entries with the
    /// square of its weight; the coupling between the two is left out.
    virtual void
    diagonal(Vector &values, const Tangents &tangents) const = 0;

    /// Adds the tangent to @p matrix, condensed with @p all_constraints, which
    /// contain at least those of reinit().
    virtual void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints,
               const Tangents                  &tangents) const = 0;

    /// To be called when the @p tangents are complete, before products with
    /// them. Where that pays, it computes the matrices of the cells or,
    /// on levels in space, the ReferenceTangents of those that are no boxes.
    virtual void
    prepare_products(Tangents &tangents) const = 0;

  protected:
    /// Adds the masters' shares in the entries of eliminated unknowns to a
    /// diagonal, and makes these entries zero.
    void
    hand_to_masters(Vector &values) const;

    const StrainModel                                      strain_model;
    MatrixFree<dim, typename Tangents::value_type, Number> matrix_free;
    NodalAccess<dim, Number>                               nodal_access;
    EliminatedUnknowns<dim, typename Tangents::value_type> eliminated;
    const AffineConstraints<double> *constraints = nullptr;
  };



  /// The kernel of a level of multigrid, for FE_Q(@p degree)^dim.
  template <int dim>
  std::unique_ptr<CellKernel<dim, CellTangents<dim>>>
  make_level_kernel(const unsigned int degree, const StrainModel &strain_model);
} // namespace ElastoPlastic

#endif
