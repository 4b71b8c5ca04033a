// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Across a contact that ends within faces, at least: the edge of fewer is
    /// no smooth line.
    constexpr unsigned int n_elements_across = 4;
  } // namespace



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::kinds() const
  {
    Vector result(edge.faces().layout());
    for (const Node &node : candidates)
      result.local_element(node.index) =
        node.active ? ContactEdge<dim>::touching : ContactEdge<dim>::open;
    return result;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::distances(const Vector &u, const double depth) const
  {
    Vector result(u.get_partitioner());
    for (const Node &node : candidates)
      result.local_element(node.index) =
        bounds.value(node, u) - depth - u.local_element(node.index);
    return result;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::areas() const
  {
    Vector result(edge.faces().layout());
    for (const Node &node : candidates)
      result.local_element(node.index) = node.area;
    return result;
  }



  template <int dim>
  void
  ContactSet<dim>::divide_edge(const double expected_depth)
  {
    if (edge.reaches(expected_depth))
      return;
    edge.unite();
    if (rule == EdgeRule::at_nodes ||
        n_active() < Utilities::fixed_power<dim - 1>(n_elements_across))
      return;
    edge.divide(kinds(), areas(), expected_depth);
    share_rows();
  }



  template <int dim>
  void
  ContactSet<dim>::restore_edge()
  {
    if (rule == EdgeRule::at_nodes)
      return;
    edge.restore(areas());
    share_rows();
  }



  template <int dim>
  void
  ContactSet<dim>::unite_edge()
  {
    edge.unite();
  }



  template <int dim>
  void
  ContactSet<dim>::note_edge(const Vector &u)
  {
    if (rule == EdgeRule::within_faces)
      edge.note(kinds(), distances(u, present_depth), present_depth);
  }



  template <int dim>
  void
  ContactSet<dim>::share_rows()
  {
    if (rule == EdgeRule::at_nodes)
      return;
    Vector active(edge.faces().layout());
    for (const unsigned int i : active_entries())
      active.local_element(i) = 1.;
    edge.share_rows(active);
    if (!edge.rows() || !friction.exists())
      return;
    Vector ones(active.get_partitioner());
    set_candidate_entries(ones, 1.);
    shared_parts = edge.rows()->sums(ones);
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::shared_gaps(const Vector &u, const double depth) const
  {
    return edge.rows() ? edge.rows()->sums(distances(u, depth)) : Vector();
  }



  template <int dim>
  double
  ContactSet<dim>::share(const Node &node) const
  {
    return edge.rows() ? 1. + shared_parts.local_element(node.index) : 1.;
  }



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
