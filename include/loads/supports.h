// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_supports_h
#define loads_supports_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <map>
#include <memory>
#include <optional>

#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The axis that all faces of a boundary are normal to, or dim. Collective.
  template <int dim>
  unsigned int
  common_normal_axis(const DoFHandler<dim>   &dof_handler,
                     const types::boundary_id boundary);

  /// The components of normals that do not vanish on all faces of a boundary.
  /// Collective.
  template <int dim>
  ComponentMask
  components_of_normals(const DoFHandler<dim>   &dof_handler,
                        const types::boundary_id boundary);

  /// Adds the condition that @p line states to @p constraints, solved for the
  /// degree of freedom with the largest coefficient of those that neither
  /// another support nor @p hanging_nodes hold. Where there is none, the
  /// other supports decide.
  void
  add_sliding_condition(
    const AffineConstraints<double>::ConstraintLine &line,
    const std::map<types::global_dof_index, double> &fixed_values,
    const AffineConstraints<double>                 &hanging_nodes,
    AffineConstraints<double>                       &constraints);



  /// The displacement boundary conditions of the body on one mesh, in two
  /// parts:
  ///
  /// - constraints(): degrees of freedom that are combinations of others,
  ///   homogeneous: hanging nodes, and rollers on surfaces that are not
  ///   parallel to a coordinate plane. They are eliminated once per mesh.
  /// - fixed(): degrees of freedom with a given value: fixed and prescribed
  ///   displacements, all other rollers, and the radial displacement on the
  ///   axis of an axisymmetric body. Together with the active contact
  ///   nodes they are "constrained", which is the business of the nonlinear
  ///   solver.
  template <int dim>
  class Supports
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// @p body must outlive this object.
    explicit Supports(const LoadedBody<dim> &body)
      : body(body)
    {}


    /// Finds out what is held where, for @p dof_handler, which must outlive
    /// this object or the next call. Prescribed displacements are those at
    /// @p time, or zero without one. Collective.
    void
    reinit(const DoFHandler<dim>      &dof_handler,
           const std::optional<double> time = {});

    /// Changes the prescribed displacements to those at @p time. Collective.
    void
    set_time(const double time);

    /// Valid until the next reinit().
    const AffineConstraints<double> &
    constraints() const
    {
      return with_skew_rollers ? *with_skew_rollers : hanging;
    }

    /// The hanging nodes alone: what a field must satisfy to be continuous.
    const AffineConstraints<double> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// The indices in @p layout of the fixed entries that this rank owns.
    std::vector<unsigned int>
    fixed_entries(const Vector &layout) const;

    /// The fixed, locally relevant degrees of freedom.
    IndexSet
    fixed_dofs() const;

    /// The components of the displacement that @p boundary holds, alone or (on
    /// skew rollers) together.
    ComponentMask
    held_components(const types::boundary_id boundary) const;

    /// Sets the fixed entries that this rank owns to their values.
    void
    move_fixed(Vector &u) const;

    /// Sets the fixed entries that this rank owns to @p value.
    void
    set_fixed_entries(Vector &vector, const double value) const;

  private:
    using Values = std::map<types::global_dof_index, double>;

    /// Finds those that are normal to an axis, and the others. Collective.
    void
    sort_rollers();

    /// The prescribed displacements at @p time, of nodes that other supports
    /// hold, too; zero without a time.
    Values
    prescribed_values(const std::optional<double> time) const;

    /// Where several conditions meet, the later one counts of these: fixed,
    /// prescribed displacement, roller, axis of revolution. Prescribed
    /// displacements are those at @p time, or zero without one.
    void
    find_fixed_values(const std::optional<double> time);

    /// @throws InputError if the body reaches across its axis of revolution.
    void
    find_axis();

    /// Rollers on surfaces that are not normal to an axis: a constraint of no
    /// normal displacement.
    void
    add_skew_rollers();

    /// Hanging nodes follow their masters, also where those are fixed.
    void
    drop_constrained_values();

    const LoadedBody<dim> &body;
    const DoFHandler<dim> *dof_handler = nullptr;
    std::optional<double>  time_of_values;

    /// The rollers that are normal to an axis, with that axis.
    std::map<types::boundary_id, unsigned int> level_rollers;

    /// The others, with the components of their normals.
    std::map<types::boundary_id, ComponentMask> skew_rollers;

    /// The constraints of hanging nodes; and those of them and skew rollers, if
    /// there are any.
    AffineConstraints<double>                  hanging;
    std::unique_ptr<AffineConstraints<double>> with_skew_rollers;
    Values                                     fixed_values;

    /// Those of rollers and the axis of revolution, which nothing else moves.
    Values fixed_at_zero;
  };
} // namespace ElastoPlastic

#endif
