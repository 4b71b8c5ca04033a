// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_solid_operator_h
#define mechanics_solid_operator_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "base/kinematics.h"
#include "material/radial_return.h"

namespace ElastoPlastic
{
  using namespace dealii;

  using VectorType = LinearAlgebra::distributed::Vector<double>;

  /// The committed states of all points, for transfer between meshes and for
  /// checkpoints: for each active cell of this rank (in the order of
  /// active_cell_index()) the numbers that describe the states at its points,
  /// one point after the other; empty for cells of other ranks.
  using CellStates = std::vector<std::vector<double>>;



  /// What is known at one quadrature point of a displacement field.
  struct PointResult
  {
    SymmetricTensor<2, 3> stress;
    SymmetricTensor<2, 3> plastic_strain;
    double                equivalent_plastic_strain;
    /// Whether the point has ever yielded.
    bool plastic;
    /// The volume (in plane strain: the area) that the point stands for.
    double volume;
    /// Per unit of volume: the elastic energy, what hardening has stored, and
    /// the plastic work and the dissipation of the step under way.
    double elastic_energy, hardening_energy, plastic_work, dissipation;
  };



  /// The mean of the tangent over a cell: what a preconditioner needs to know.
  template <int dim>
  struct CellTangent
  {
    static constexpr unsigned int n_symmetric = dim * (dim + 1) / 2;
    static constexpr unsigned int n_values    = 2 + 2 * n_symmetric;

    double                         bulk_modulus;
    DeviatoricTangent<dim, double> deviatoric;

    /// All numbers in a row, for storage.
    std::array<double, n_values>
    values() const
    {
      std::array<double, n_values> result = {{bulk_modulus, deviatoric.shear}};
      for (unsigned int i = 0; i < n_symmetric; ++i)
        {
          result[2 + i]               = deviatoric.normal.access_raw_entry(i);
          result[2 + n_symmetric + i] = deviatoric.flow.access_raw_entry(i);
        }
      return result;
    }
  };



  /// The deformable body: everything that follows from one cell kernel, strain
  /// -> stress -> nodal forces, for a displacement field u. No boundary
  /// condition and no contact is known here: all unknowns are free, but for
  /// those that the AffineConstraints passed to reinit() (hanging nodes,
  /// skew rollers) express by others.
  ///
  /// All stresses and energies are those at the end of a load step that begins
  /// with the material states of the last commit().
  ///
  /// Vectors passed in need no ghost values; displacements must satisfy the
  /// constraints (AffineConstraints::distribute()). Forces come out condensed:
  /// a hanging node's force is handed to its masters.
  template <int dim>
  class SolidOperator
  {
  public:
    virtual ~SolidOperator() = default;

    /// Whether the forces are the derivative of energy(). If not, because back
    /// stresses recover, then tangents are unsymmetric.
    virtual bool
    has_energy() const = 0;

    /// Prepares everything that depends on the mesh; all points are virgin.
    /// @p dof_handler and @p constraints must outlive this object or the next
    /// call.
    virtual void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints) = 0;

    /// Ends a load step with the displacement @p u: what the points then
    /// remember is what the next step begins with.
    virtual void
    commit(const VectorType &u) = 0;

    /// What the points remember of the last commit().
    virtual CellStates
    states() const = 0;

    /// Lets the points remember @p states, or where interpolation has made of
    /// them what no history leads to, the next that one does
    /// (make_admissible()).
    virtual void
    set_states(const CellStates &states) = 0;

    virtual void
    initialize_vector(VectorType &vector) const = 0;

    /// int W(strain(u)) dx, the incremental energy (doc/theory.md, "Material").
    /// If there is none: the elastic energy and the plastic work of the step,
    /// to look at.
    virtual double
    energy(const VectorType &u) const = 0;

    /// The internal forces int stress(u) : strain(phi_i) dx.
    virtual void
    internal_forces(VectorType &forces, const VectorType &u) const = 0;

    /// int stress(u) : strain(w) dx, the same integral for one field @p w
    /// instead of the shape functions, summed over all ranks.
    virtual double
    virtual_work(const VectorType &u, const VectorType &w) const = 0;

    /// Computes and stores a tangent at u, for vmult(), diagonal() and
    /// add_matrix(): the consistent one, but with the predicted flow directions
    /// (doc/theory.md, "Newton's method for plasticity") where those exist.
    virtual void
    linearize(const VectorType &u) = 0;

    /// Predicts the flow directions at @p new_u from those at @p old_u; if both
    /// are the same, takes the exact ones there. After reinit() they are zero.
    /// The stored tangent is void until linearize() is called again.
    virtual void
    predict_flow(const VectorType &old_u, const VectorType &new_u) = 0;

    /// The product of the stored tangent with @p increment.
    virtual void
    vmult(VectorType &forces, const VectorType &increment) const = 0;

    /// The diagonal of the stored tangent.
    virtual void
    diagonal(VectorType &values) const = 0;

    /// Adds the stored tangent to @p matrix, condensed with
    /// @p all_constraints, which contain at least those of reinit().
    virtual void
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints) const = 0;

    /// Calls @p receive for all locally owned cells with the mean of the stored
    /// tangent, or of a definite approximation. (The means of the two factors
    /// of the soft direction make the mean stiffer than the tangent, and so
    /// positive definite.)
    virtual void
    for_each_cell_tangent(
      const std::function<
        void(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const CellTangent<dim> &tangent)> &receive) const = 0;

    /// Calls @p receive for all locally owned cells, in no particular order,
    /// with what is known at their quadrature points, which are in the order of
    /// QGauss<dim>(degree + 1). All ranks must call this; all communication
    /// comes before the first cell.
    virtual void
    for_each_cell(
      const VectorType &u,
      const std::function<
        void(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const std::vector<PointResult> &points)> &receive) const = 0;
  };



  /// The solid operator for FE_Q(@p degree)^dim, with the material that belongs
  /// to each cell's material id (or the only one).
  /// @throws InputError if a cell's material id has no material.
  template <int dim>
  std::unique_ptr<SolidOperator<dim>>
  make_solid_operator(const unsigned int                   degree,
                      const StrainModel                   &strain_model,
                      const std::vector<Material<double>> &materials);
} // namespace ElastoPlastic

#endif
