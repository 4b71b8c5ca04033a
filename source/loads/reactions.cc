// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>

#include "loads/loaded_body.h"
#include "loads/reactions.h"

namespace ElastoPlastic
{
  template <int dim>
  std::vector<typename Reactions<dim>::Component>
  Reactions<dim>::components() const
  {
    const std::string  axes = "xyz";
    const unsigned int first_direction =
      body.strain_model.kinematics == Kinematics::axisymmetric ? 1 : 0;
    std::vector<Component> result;
    for (const auto &[name, id] : body.boundary_conditions.names())
      {
        const ComponentMask held = supports.held_components(id);
        for (unsigned int d = first_direction; d < dim; ++d)
          if (held[d])
            result.push_back({name + "_" + axes[d], id, d});
      }
    return result;
  }



  template <int dim>
  std::vector<std::string>
  Reactions<dim>::names() const
  {
    std::vector<std::string> result;
    for (const Component &component : components())
      result.push_back(component.name);
    return result;
  }



  template <int dim>
  IndexSet
  Reactions<dim>::unknowns(const Component &component) const
  {
    ComponentMask mask(dim, false);
    mask.set(component.direction, true);
    return DoFTools::extract_boundary_dofs(dof_handler,
                                           mask,
                                           {component.boundary}) &
           dof_handler.locally_owned_dofs();
  }



  template <int dim>
  std::vector<double>
  Reactions<dim>::compute(const SolidOperator<dim> &solid,
                          const VectorType         &displacement,
                          const VectorType         &contact_forces,
                          const double              time) const
  {
    const auto            loads = loads_on_body(contact_forces, time);
    std::vector<IndexSet> unknowns_of_components;
    VectorType            n_boundaries;
    solid.initialize_vector(n_boundaries);
    for (const Component &component : components())
      {
        unknowns_of_components.push_back(unknowns(component));
        for (const auto dof : unknowns_of_components.back())
          n_boundaries(dof) += 1.;
      }

    std::vector<double> forces;
    VectorType          translation;
    for (const IndexSet &held : unknowns_of_components)
      {
        solid.initialize_vector(translation);
        for (const auto dof : held)
          translation(dof) = 1. / n_boundaries(dof);
        forces.push_back(work(solid, displacement, loads, translation));
      }
    return forces;
  }



  template <int dim>
  double
  Reactions<dim>::vertical_force(const SolidOperator<dim> &solid,
                                 const VectorType         &displacement,
                                 const VectorType         &contact_forces,
                                 const double              time) const
  {
    VectorType translation;
    solid.initialize_vector(translation);
    for (const Component &component : components())
      if (component.direction == dim - 1)
        for (const auto dof : unknowns(component))
          translation(dof) = 1.;
    return work(solid,
                displacement,
                loads_on_body(contact_forces, time),
                translation);
  }



  template <int dim>
  VectorType
  Reactions<dim>::loads_on_body(const VectorType &contact_forces,
                                const double      time) const
  {
    VectorType loads(contact_forces.get_partitioner());
    compute_external_forces(
      loads, dof_handler, supports.hanging_nodes(), body, time);
    loads += contact_forces;
    return loads;
  }



  template <int dim>
  double
  Reactions<dim>::work(const SolidOperator<dim> &solid,
                       const VectorType         &displacement,
                       const VectorType         &loads,
                       VectorType               &motion) const
  {
    supports.hanging_nodes().distribute(motion);
    return solid.virtual_work(displacement, motion) - loads * motion;
  }



  template class Reactions<2>;
  template class Reactions<3>;
} // namespace ElastoPlastic
