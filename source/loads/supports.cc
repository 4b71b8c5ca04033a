// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/vector_tools.h>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "loads/supports.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Components = typename BoundaryConditions<dim>::Components;



    /// A prescribed displacement at a time, for interpolate_boundary_values();
    /// zero without one. Components that are free have no values.
    template <int dim>
    class DisplacementFunction : public Function<dim>
    {
    public:
      DisplacementFunction(const Components<dim>      &components,
                           const std::optional<double> time)
        : Function<dim>(dim)
        , components(components)
        , time(time)
      {}

      double
      value(const Point<dim> &point, const unsigned int c) const override
      {
        return time && components[c] ? components[c]->value(point, *time) : 0.;
      }

    private:
      const Components<dim>      &components;
      const std::optional<double> time;
    };



    /// The components that are not free.
    template <std::size_t dim, typename Component>
    ComponentMask
    mask_of_given(const std::array<Component, dim> &components)
    {
      ComponentMask mask(dim, false);
      for (unsigned int d = 0; d < dim; ++d)
        mask.set(d, components[d] != nullptr);
      return mask;
    }



    template <int dim>
    ComponentMask
    mask_of_component(const unsigned int component)
    {
      ComponentMask mask(dim, false);
      mask.set(component, true);
      return mask;
    }
  } // namespace



  template <int dim>
  void
  Supports<dim>::reinit(const DoFHandler<dim>      &new_dof_handler,
                        const std::optional<double> time)
  {
    time_of_values.reset();
    dof_handler = &new_dof_handler;
    hanging     = empty_constraints(*dof_handler);
    DoFTools::make_hanging_node_constraints(*dof_handler, hanging);
    hanging.close();
    with_skew_rollers.reset();

    sort_rollers();
    find_fixed_values(time);
    if (!skew_rollers.empty())
      add_skew_rollers();
    drop_constrained_values();
    time_of_values = time;
  }



  template <int dim>
  void
  Supports<dim>::set_time(const double time)
  {
    if (time == time_of_values)
      return;
    for (const auto &[dof, value] : prescribed_values(time))
      if (const auto fixed = fixed_values.find(dof);
          fixed != fixed_values.end() && fixed_at_zero.count(dof) == 0)
        fixed->second = value;
    time_of_values = time;
  }



  template <int dim>
  void
  Supports<dim>::sort_rollers()
  {
    level_rollers.clear();
    skew_rollers.clear();
    for (const auto id :
         body.boundary_conditions.ids(BoundaryConditionType::roller))
      if (const unsigned int axis = common_normal_axis(*dof_handler, id);
          axis < dim)
        level_rollers[id] = axis;
      else
        skew_rollers[id] = components_of_normals(*dof_handler, id);
  }



  template <int dim>
  typename Supports<dim>::Values
  Supports<dim>::prescribed_values(const std::optional<double> time) const
  {
    Values values;
    rethrow_collectively(communicator_of(*dof_handler), [&]() {
      for (const auto &[id, displacement] :
           body.boundary_conditions.prescribed_displacements())
        VectorTools::interpolate_boundary_values(
          MappingQ1<dim>(),
          *dof_handler,
          id,
          DisplacementFunction<dim>(displacement, time),
          values,
          mask_of_given(displacement));
    });
    return values;
  }



  template <int dim>
  void
  Supports<dim>::find_fixed_values(const std::optional<double> time)
  {
    const Functions::ZeroFunction<dim> zero(dim);
    fixed_values.clear();
    for (const auto id :
         body.boundary_conditions.ids(BoundaryConditionType::fixed))
      VectorTools::interpolate_boundary_values(
        MappingQ1<dim>(), *dof_handler, id, zero, fixed_values);

    fixed_at_zero.clear();
    for (const auto &[id, axis] : level_rollers)
      VectorTools::interpolate_boundary_values(MappingQ1<dim>(),
                                               *dof_handler,
                                               id,
                                               zero,
                                               fixed_at_zero,
                                               mask_of_component<dim>(axis));
    if (body.strain_model.kinematics == Kinematics::axisymmetric)
      rethrow_collectively(communicator_of(*dof_handler),
                           [&]() { find_axis(); });

    for (const Values &values : {prescribed_values(time), fixed_at_zero})
      for (const auto &[dof, value] : values)
        fixed_values[dof] = value;
  }



  template <int dim>
  void
  Supports<dim>::find_axis()
  {
    const auto                          &fe = dof_handler->get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
    for (const auto &cell : dof_handler->active_cell_iterators())
      if (!cell->is_artificial())
        for (const auto &face : cell->face_iterators())
          {
            const double rounding = 1e-10 * face->diameter();
            bool         on_axis  = face->at_boundary();
            for (const unsigned int v : face->vertex_indices())
              {
                if (face->vertex(v)[0] < -rounding)
                  throw InputError("Kinematics",
                                   "axisymmetric",
                                   "the body reaches to negative x. It must be "
                                   "the half section x >= 0; x = 0 is the axis "
                                   "of revolution.");
                on_axis = on_axis && face->vertex(v)[0] <= rounding;
              }
            if (!on_axis)
              continue;
            face->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (fe.face_system_to_component_index(i).first == 0)
                fixed_at_zero[dofs[i]] = 0.;
          }
  }



  template <int dim>
  void
  Supports<dim>::drop_constrained_values()
  {
    for (auto dof = fixed_values.begin(); dof != fixed_values.end();)
      dof = constraints().is_constrained(dof->first) ? fixed_values.erase(dof) :
                                                       std::next(dof);
  }



  // The rank that owns a node sees all faces that meet there, and so the
  // normals and the other supports. What it decides, the others take over.
  template <int dim>
  void
  Supports<dim>::add_skew_rollers()
  {
    std::set<types::boundary_id> rollers;
    for (const auto &roller : skew_rollers)
      rollers.insert(roller.first);
    const IndexSet &owned      = dof_handler->locally_owned_dofs();
    auto            sliding    = empty_constraints(*dof_handler);
    auto            conditions = empty_constraints(*dof_handler);
    VectorTools::compute_no_normal_flux_constraints(
      *dof_handler, 0, rollers, sliding, MappingQ1<dim>());
    sliding.close();
    for (const auto &line : sliding.get_lines())
      if (owned.is_element(line.index))
        add_sliding_condition(line, fixed_values, hanging, conditions);
    conditions.make_consistent_in_parallel(owned,
                                           hanging.get_local_lines(),
                                           communicator_of(*dof_handler));
    with_skew_rollers = std::make_unique<AffineConstraints<double>>(
      empty_constraints(*dof_handler));
    with_skew_rollers->merge(hanging);
    with_skew_rollers->merge(conditions);
    with_skew_rollers->close();
  }



  template <int dim>
  std::vector<unsigned int>
  Supports<dim>::fixed_entries(const Vector &layout) const
  {
    std::vector<unsigned int> entries;
    const auto               &partitioner = *layout.get_partitioner();
    for (const auto &dof_and_value : fixed_values)
      if (partitioner.in_local_range(dof_and_value.first))
        entries.push_back(partitioner.global_to_local(dof_and_value.first));
    return entries;
  }



  template <int dim>
  IndexSet
  Supports<dim>::fixed_dofs() const
  {
    IndexSet dofs(constraints().get_local_lines().size());
    for (const auto &dof_and_value : fixed_values)
      dofs.add_index(dof_and_value.first);
    return dofs;
  }



  template <int dim>
  ComponentMask
  Supports<dim>::held_components(const types::boundary_id boundary) const
  {
    using Type            = BoundaryConditionType;
    const auto is_of_type = [&](const Type type) {
      return body.boundary_conditions.ids(type).count(boundary) > 0;
    };
    if (is_of_type(Type::fixed))
      return ComponentMask(dim, true);
    if (is_of_type(Type::roller))
      {
        const auto level_roller = level_rollers.find(boundary);
        return level_roller != level_rollers.end() ?
                 mask_of_component<dim>(level_roller->second) :
                 skew_rollers.at(boundary);
      }
    if (is_of_type(Type::prescribed_displacement))
      return mask_of_given(
        body.boundary_conditions.prescribed_displacements().at(boundary));
    return ComponentMask(dim, false);
  }



  template <int dim>
  void
  Supports<dim>::move_fixed(Vector &u) const
  {
    for (const auto &[dof, value] : fixed_values)
      if (u.in_local_range(dof))
        u(dof) = value;
  }



  template <int dim>
  void
  Supports<dim>::set_fixed_entries(Vector &vector, const double value) const
  {
    for (const auto &dof_and_value : fixed_values)
      if (vector.in_local_range(dof_and_value.first))
        vector(dof_and_value.first) = value;
  }



  template class Supports<2>;
  template class Supports<3>;
} // namespace ElastoPlastic
