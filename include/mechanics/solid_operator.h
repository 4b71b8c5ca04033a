// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_solid_operator_h
#define mechanics_solid_operator_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "mechanics/batch_materials.h"
#include "mechanics/initial_strains.h"
#include "mechanics/initial_stress.h"
#include "mechanics/point_history.h"
#include "mechanics/point_response.h"
#include "mechanics/solid_kernel.h"
#include "solver/system_matrix.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The committed states of all points, for transfer between meshes and for
  /// checkpoints: for each active cell of this rank (in the order of
  /// active_cell_index()) the numbers that describe the states at its points,
  /// one point after the other; empty for cells of other ranks.
  using CellStates = std::vector<std::vector<double>>;



  /// What is known at one quadrature point of a displacement field.
  struct PointResult
  {
    SymmetricTensor<2, 3> stress; ///< the true one
    SymmetricTensor<2, 3> strain;
    SymmetricTensor<2, 3> plastic_strain;
    SymmetricTensor<2, 3> back_stress; ///< the sum of all
    double                equivalent_plastic_strain;
    /// Its mean rate in the step under way; zero between steps.
    double equivalent_plastic_strain_rate;
    /// Whether the point has ever yielded.
    bool plastic;
    /// The volume (in plane strain: the area) that the point stands for, before
    /// the deformation.
    double volume;
    /// Per unit of volume: the elastic energy beyond that of the initial
    /// stress, what hardening has stored, and the plastic work and the
    /// dissipation of the step under way.
    double elastic_energy, hardening_energy, plastic_work, dissipation;
  };



  /// How large the initial stress of a body is.
  struct InitialStressSize
  {
    /// Its elastic energy.
    double energy = 0;
    /// The integral of its norm over the body.
    double norm = 0;
  };



  /// The deformable body: kinematics and integration (CellKernel), what its
  /// points remember (PointHistory) and what their materials do
  /// (PointResponse), for a displacement field u. No boundary condition and no
  /// contact is known here: all unknowns are free, but for those that the
  /// AffineConstraints passed to reinit() (hanging nodes, skew rollers) express
  /// by others.
  ///
  /// All stresses and energies are those at the end of a load step that begins
  /// with the material states of the last commit().
  ///
  /// Vectors passed in need no ghost values; displacements must satisfy the
  /// constraints (AffineConstraints::distribute()). Forces come out condensed:
  /// a hanging node's force is handed to its masters. All functions with
  /// vectors are collective.
  template <int dim>
  class SolidOperator : public TangentOperator
  {
  public:
    /// For FE_Q(@p degree)^dim, with the material that belongs to each cell's
    /// material id, or the only one.
    SolidOperator(const unsigned int                   degree,
                  const StrainModel                   &strain_model,
                  const std::vector<Material<double>> &materials);

    /// Whether the forces are the derivative of energy(). They are not if back
    /// stresses recover, which makes tangents unsymmetric, and with some laws
    /// of rate dependence.
    bool
    has_energy() const
    {
      return has_potential;
    }

    bool
    is_symmetric() const override
    {
      return !recovers;
    }

    /// Whether a material has a rate law.
    bool
    is_rate_dependent() const
    {
      return materials.are_rate_dependent();
    }

    /// Lets the points also remember by how much each load step changes them,
    /// for go_on(). To be called before reinit().
    void
    keep_increments();

    bool
    keeps_increments() const;

    /// Prepares everything that depends on the mesh; all points are virgin,
    /// and bear no stress.
    /// @p dof_handler and @p constraints must outlive this object or the next
    /// call.
    /// @throws InputError if a cell's material id has no material.
    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints);

    /// Lets the body bear @p stress as long as it is not deformed. Collective.
    /// @throws InputError if it is not finite somewhere, or beyond the yield
    /// stress of a material without a rate law.
    void
    set_initial_stress(const InitialStress<dim> &stress);

    /// Adds to the initial stress that of @p displacement if the body were
    /// elastic and without stress. Collective.
    /// @throws InputError if it is then beyond the yield stress of a material
    /// without a rate law.
    void
    add_to_initial_stress(const VectorType &displacement);

    /// Collective.
    InitialStressSize
    initial_stress_size() const;

    /// Begins a load step of this @p duration, which lasts until commit(). In
    /// between steps, no time passes: what flows at a finite rate only does not
    /// flow.
    void
    begin_step(const double duration);

    /// Begins a load step of this @p duration that goes on after one of the
    /// duration @p last, with the two-step backward differentiation formula
    /// (doc/theory, "Load histories"): a backward Euler step from states
    /// that have been extrapolated, which takes a part of the time. All that is
    /// said of the step under way is said of that one.
    void
    go_on(const double duration, const double last);

    /// By what part of the last step's increments the states have been
    /// extrapolated with which the step under way begins.
    double
    extrapolation_weight() const;

    double
    step_duration() const
    {
      return materials.step_duration();
    }

    /// Ends a load step with the displacement @p u: what the points then
    /// remember is what the next step begins with.
    void
    commit(const VectorType &u);

    /// What the points remember of the last commit().
    CellStates
    states() const;

    /// The same, cell by cell: the numbers that belong to it.
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;
    void
    for_each_state(
      const std::function<void(const CellIterator &, std::vector<double> &&)>
        &visit) const;

    /// Lets the points remember @p states, or where interpolation has made of
    /// them what no history leads to, the next that one does
    /// (make_admissible()).
    void
    set_states(const CellStates &states);

    /// The same, cell by cell, in the order of for_each_state().
    void
    set_states(
      const std::function<std::vector<double>(const CellIterator &)> &state_of);

    void
    initialize_vector(VectorType &vector) const override
    {
      kernel->initialize_vector(vector);
    }

    /// int W(strain(u)) dx, the incremental energy (doc/theory, "Material").
    /// If there is none: the elastic energy and the plastic work of the step,
    /// to look at.
    double
    energy(const VectorType &u) const;

    /// The internal forces int stress(u) : strain(phi_i) dx. @return energy(u),
    /// which the same stresses yield.
    double
    internal_forces(VectorType &forces, const VectorType &u) const;

    /// int stress(u) : strain(w) dx, the same integral for one field @p w
    /// instead of the shape functions, summed over all ranks.
    double
    virtual_work(const VectorType &u, const VectorType &w) const;

    /// Computes and stores a tangent at u, for vmult(), diagonal() and
    /// add_matrix(): the consistent one, but with the predicted flow directions
    /// (doc/theory, "Newton's method for plasticity") where those exist.
    void
    linearize(const VectorType &u);

    /// Predicts the flow directions at @p new_u from those at @p old_u; if both
    /// are the same, takes the exact ones there. After reinit(), and in batches
    /// of cells far from flowing, they are zero.
    void
    predict_flow(const VectorType &old_u, const VectorType &new_u);

    /// The product of the stored tangent with @p increment.
    void
    vmult(VectorType &forces, const VectorType &increment) const override
    {
      kernel->vmult(forces, increment, tangents);
    }

    /// Not a sheet, which may change its thickness.
    bool
    is_nearly_incompressible() const override
    {
      return !is_sheet && materials.are_nearly_incompressible();
    }

    void
    initialize_mixed_vector(BlockVectorType &vector) const override;

    void
    mixed_vmult(BlockVectorType       &result,
                const BlockVectorType &vector) const override
    {
      kernel->mixed_vmult(result, vector, tangents);
    }

    std::unique_ptr<const PressurePreconditioner>
    make_pressure_preconditioner(const VectorType &held) const override;

    /// The diagonal of the stored tangent, see CellKernel.
    void
    diagonal(VectorType &values) const
    {
      kernel->diagonal(values, tangents);
    }

    void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints) const override
    {
      kernel->add_matrix(matrix, all_constraints, tangents);
    }

    /// Calls @p receive for all locally owned cells with the mean of the stored
    /// tangent, or of a definite approximation, as the numbers that
    /// CellTangents wants. If the body is nearly incompressible, the bulk
    /// modulus is the moderate one. (The means of the two factors of the soft
    /// direction make the mean stiffer than the tangent, and so positive
    /// definite.)
    void
    for_each_cell_tangent(
      const std::function<
        void(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const std::vector<double> &values)> &receive) const;

    /// The P-wave modulus of the stored tangent (in a sheet the modulus of a
    /// stretch in one direction) over its smallest shear modulus, which counts
    /// as a fiftieth of that across the flow at least; both are means over the
    /// points of a cell: the geometric mean of all cells. Of a definite
    /// approximation; with finite strains without the parts of the geometry.
    /// Not a number if one of the tangents is not. Collective.
    double
    stiffness_ratio(const MPI_Comm communicator) const;

    /// Calls @p receive for all locally owned cells, in no particular order,
    /// with what is known at their quadrature points, which are in the order of
    /// QGauss<dim>(degree + 1). All ranks must call this; all communication
    /// comes before the first cell.
    void
    for_each_cell(const VectorType                           &u,
                  const std::function<void(
                    const typename DoFHandler<dim>::active_cell_iterator &cell,
                    const std::vector<PointResult> &points)> &receive) const;

  private:
    using Number   = Simd<double>;
    using Strain   = SymmetricTensor<2, 3, Number>;
    using Kernel   = SolidKernel<dim>;
    using Strains  = typename Kernel::Strains;
    using Stresses = typename Kernel::Stresses;
    template <typename T>
    using AtPoints = std::array<T, Strains::max_points>;

    /// The strain at a point that the material feels, that of the initial
    /// stress included. Out of plane, the material of a sheet says it.
    Strain
    strain_at(const Strains &strains, const unsigned int point) const;

    /// The volumetric strain that the material feels.
    Number
    volumetric_strain_at(const Strains &strains, const unsigned int point) const
    {
      return initial_strains.are_present() ?
               strains.volumetric[point] +
                 trace(initial_strains.at(strains.batch, point)) :
               strains.volumetric[point];
    }

    /// What is not counted of the elastic energy of a point: that of the
    /// initial stress, less the work of its pressure on what distinguishes the
    /// volumetric strain from its mean over the cell.
    Number
    initial_energy_at(const Strains &strains, const unsigned int point) const;

    PointResponse<Number>
    response(const Strains &strains, const unsigned int point) const;

    /// The law of all points of a batch of cells. @return the incremental
    /// energy of these cells.
    double
    find_stresses(const Strains &strains, Stresses &stresses) const;

    /// Whether linearize() takes the exact flow directions, which are not
    /// predicted: if a hardening curve becomes steeper, and with general
    /// criteria.
    bool
    is_flow_exact() const
    {
      return becomes_steeper || has_general_criteria;
    }

    /// Sets those of the mixed form.
    void
    moderate_bulk_moduli();

    /// Of the cells in the batch, the shear modulus that bounds the bulk
    /// modulus of A in the mixed form: with B-bar what the stored tangent has
    /// left of it, across the flow, on average; else that of the material.
    Number
    shear_modulus(const unsigned int batch) const;

    /// The mean tangent of a batch of cells, as values of CellTangents.
    std::vector<Number>
    mean_tangent(const unsigned int batch) const;

    /// The ratio of the moduli in the cells of a batch.
    Number
    stiffness_ratio(const unsigned int batch) const;

    BatchMaterials materials;
    const bool     is_sheet;
    const bool     is_finite;
    /// Of the StrainModel.
    const bool         has_general_criteria, has_nominal_tangents;
    const bool         is_b_bar;
    const unsigned int n_points;
    const bool         has_potential;
    /// Whether a back stress recovers.
    const bool recovers;
    /// Whether a hardening curve becomes steeper. Then a point can be stiff in
    /// the flow direction, and only the exact one makes the tangent positive
    /// definite.
    const bool becomes_steeper;

    const std::unique_ptr<Kernel> kernel;

    PointTangents<dim> tangents;
    /// The states before the step.
    PointHistory history;
    /// The elastic strains of the initial stress, if there is one.
    InitialStrains initial_strains;
  };
} // namespace ElastoPlastic

#endif
