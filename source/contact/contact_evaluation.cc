// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "contact/contact_evaluation.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Sets a vector of the tangent plane of a node with this slope.
    template <int dim>
    void
    set_tangent_vector(LinearAlgebra::distributed::Vector<double> &vector,
                       const ContactNode<dim>                     &node,
                       const TangentVector<dim>                   &value,
                       const TangentVector<dim>                   &slope)
    {
      for (unsigned int d = 0; d < dim - 1; ++d)
        vector.local_element(node.horizontal[d]) = value[d];
      vector.local_element(node.index) = slope * value;
    }
  } // namespace



  template <int dim>
  ContactEvaluation<dim>::ContactEvaluation(const ContactSet<dim> &contact,
                                            const Vector          &u,
                                            const Vector          &residual)
    : contact(contact)
    , u(u)
    , residual(residual)
    , gaps(contact.gaps(u, contact.depth()))
    , passed(contact.law().passed(gaps, contact.statuses()))
    , reached(find_reached())
    , moved_faces(contact.bounds.follow_deformation() ?
                    std::make_optional(contact.faces.moved(u)) :
                    std::nullopt)
    , areas(lumped_areas())
    , touched_areas(find_touched_areas())
    , bearing_areas(find_bearing_areas())
  {}



  template <int dim>
  std::vector<bool>
  ContactEvaluation<dim>::find_reached() const
  {
    std::vector<bool> result;
    for (unsigned int k = 0; k < gaps.size(); ++k)
      {
        const Node &node = contact.candidates[k];
        result.push_back(
          node.status == ContactStatus::closed ||
          (passed[k] &&
           (gaps[k] <= 0. || contact.pressing_force(node, u, residual) > 0.)));
      }
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::lumped_areas() const
  {
    Vector       result(u.get_partitioner());
    const bool   moves = contact.bounds.follow_deformation();
    const Vector whole = moves ? contact.faces.areas() : Vector();
    const Vector moved = moves ? faces().areas() : Vector();
    for (const Node &node : contact.candidates)
      {
        const unsigned int i = node.index;
        result.local_element(i) =
          moves ? node.area * moved.local_element(i) / whole.local_element(i) :
                  node.area;
      }
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::find_touched_areas() const
  {
    if (contact.rule == EdgeRule::at_nodes)
      return areas;
    Vector distances(u.get_partitioner()), kinds(u.get_partitioner());
    for (unsigned int k = 0; k < gaps.size(); ++k)
      {
        const unsigned int i       = contact.candidates[k].index;
        distances.local_element(i) = gaps[k];
        kinds.local_element(i)     = reached[k] ? ContactFaces<dim>::closed :
                                                  ContactFaces<dim>::not_closed;
      }
    return faces().touched_areas(kinds, faces().levels(kinds, distances));
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::find_bearing_areas() const
  {
    if (!contact.law().exists())
      return areas;
    const Vector        whole = faces().areas();
    std::vector<double> of_active;
    for (const Node &node : contact.candidates)
      of_active.push_back(node.is_active() ? areas.local_element(node.index) :
                                             0.);
    const std::vector<double> own    = normal_forces();
    const std::vector<double> inside = contact.law().forces_inside(own);
    const std::vector<double> areas_inside =
      contact.law().forces_inside(of_active);
    const std::vector<double> handed = handed_inside(own);

    Vector result = areas;
    for (unsigned int k = 0; k < own.size(); ++k)
      if (reached[k] && inside[k] > 0.)
        {
          const unsigned int i      = contact.candidates[k].index;
          const double       lumped = areas.local_element(i);
          const double       touched =
            lumped * touched_areas.local_element(i) / whole.local_element(i);
          const auto [smaller, larger] = std::minmax(lumped, touched);
          result.local_element(i) =
            std::clamp(handed[k] * areas_inside[k] / inside[k],
                       smaller,
                       larger);
        }
    return result;
  }



  // (Vertical forces and projected areas have the same quotient as normal
  // forces and inclined areas.)
  template <int dim>
  std::vector<double>
  ContactEvaluation<dim>::normal_forces() const
  {
    std::vector<double> result;
    for (const Node &node : contact.candidates)
      result.push_back(node.is_active() ?
                         contact.pressing_force(node, u, residual) *
                           contact.bounds.inclination(node) :
                         0.);
    return result;
  }



  template <int dim>
  std::vector<double>
  ContactEvaluation<dim>::handed_inside(const std::vector<double> &values) const
  {
    std::vector<double> forces;
    for (const Node &node : contact.candidates)
      forces.push_back(node.is_active() ? residual.local_element(node.index) :
                                          0.);
    return contact.law().handed_inside(values, passed, forces);
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::touched() const
  {
    Vector result(u.get_partitioner());
    for (unsigned int k = 0; k < passed.size(); ++k)
      result.local_element(contact.candidates[k].index) = passed[k] ? 1. : 0.;
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::pressures() const
  {
    Vector                    result(residual.get_partitioner());
    const std::vector<double> forces = handed_inside(normal_forces());
    for (unsigned int k = 0; k < forces.size(); ++k)
      if (passed[k])
        {
          const unsigned int i    = contact.candidates[k].index;
          result.local_element(i) = forces[k] / bearing_areas.local_element(i);
        }
    contact.filter.apply(result, touched());
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::forces_on_body() const
  {
    Vector forces = contact.vertical_forces_on_body(residual);
    if (contact.has_sloped_bounds())
      rethrow_collectively(contact.communicator, [&]() {
        for (const Node &node : contact.candidates)
          if (node.is_active())
            {
              const auto slope =
                contact.force_law(node, contact.bounds.surface(node, u), u)
                  .value;
              for (unsigned int d = 0; d < dim - 1; ++d)
                forces.local_element(node.horizontal[d]) =
                  slope[d] * residual.local_element(node.index);
            }
      });
    for (const unsigned int i : contact.stuck_entries())
      forces.local_element(i) = -residual.local_element(i);
    return forces;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::slip() const
  {
    Vector result(u.get_partitioner());
    for (const Node &node : contact.candidates)
      if (node.is_active())
        set_tangent_vector<dim>(result,
                                node,
                                contact.slip(node, u),
                                contact.bounds.surface(node, u).slope);
    return result;
  }



  template <int dim>
  void
  ContactEvaluation<dim>::surface_fields(Vector &gap,
                                         Vector &pressure,
                                         Vector &active) const
  {
    for (const auto *const nodes :
         {&contact.candidates, &contact.hanging_nodes})
      for (const Node &node : *nodes)
        gap.local_element(node.index) =
          contact.bound(node, u) - u.local_element(node.index);
    pressure = pressures();
    active   = touched();
    // (one without area is pressed where its neighbours are)
    for (const Node &node : contact.hanging_nodes)
      if (node.without_area && pressure.local_element(node.index) > 0.)
        active.local_element(node.index) = 1.;
  }



  template <int dim>
  void
  ContactEvaluation<dim>::friction_fields(Vector &shear, Vector &stick) const
  {
    std::vector<TangentVector<dim>> forces;
    for (const Node &node : contact.candidates)
      forces.push_back(
        node.is_active() ?
          contact.contact_force(node, contact.bounds.surface(node, u), residual)
            .tangential :
          TangentVector<dim>());
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        std::vector<double> components;
        for (const auto &force : forces)
          components.push_back(force[d]);
        components = handed_inside(components);
        for (unsigned int k = 0; k < forces.size(); ++k)
          forces[k][d] = components[k];
      }
    for (unsigned int k = 0; k < forces.size(); ++k)
      if (passed[k])
        {
          const Node &node = contact.candidates[k];
          stick.local_element(node.index) =
            contact.friction.sticks(node.friction) ? 1. : 0.;
          const auto   slope = contact.bounds.surface(node, u).slope;
          const double area  = bearing_areas.local_element(node.index) *
                              std::sqrt(1. + slope * slope) /
                              contact.bounds.inclination(node);
          set_tangent_vector<dim>(shear, node, forces[k] / -area, slope);
        }
    contact.filter.apply(shear, touched());
  }



  template class ContactEvaluation<2>;
  template class ContactEvaluation<3>;
} // namespace ElastoPlastic
