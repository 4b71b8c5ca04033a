// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

#include "adaptivity/contact_zone.h"
#include "base/compatibility.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How fast the size of elements may grow with the distance from the
    /// contact. In space, where the edge is a line, fewer have to do.
    template <int dim>
    constexpr double size_growth = dim == 2 ? 0.15 : 0.25;

    /// How much smaller the elements are at the edge.
    template <int dim>
    constexpr double edge_refinement = dim == 2 ? 4. : 2.;



    /// The largest number of spots of which each is looked at by itself.
    constexpr unsigned int few_spots = 3;
  } // namespace



  template <int dim>
  ContactZone<dim>::ContactZone(
    const DoFHandler<dim>                  &dof_handler,
    const AffineConstraints<double>        &hanging_nodes,
    const IndexSet                         &fixed_dofs,
    const std::set<types::boundary_id>     &boundaries,
    const ContactSet<dim>                  &contact,
    const typename ContactSet<dim>::Vector &displacement,
    const typename ContactSet<dim>::Vector &residual)
  {
    find_spots(join(Utilities::MPI::all_gather(communicator_of(dof_handler),
                                               find_nodes(dof_handler,
                                                          hanging_nodes,
                                                          fixed_dofs,
                                                          boundaries,
                                                          contact,
                                                          displacement,
                                                          residual))),
               dof_handler.get_fe().degree);
  }



  // The force on a node is known to its owner, who need not own its faces.
  // Hanging nodes are no nodes of their own.
  template <int dim>
  typename ContactZone<dim>::Graph
  ContactZone<dim>::find_nodes(
    const DoFHandler<dim>                  &dof_handler,
    const AffineConstraints<double>        &hanging_nodes,
    const IndexSet                         &fixed_dofs,
    const std::set<types::boundary_id>     &boundaries,
    const ContactSet<dim>                  &contact,
    const typename ContactSet<dim>::Vector &displacement,
    const typename ContactSet<dim>::Vector &residual)
  {
    using Vector = typename ContactSet<dim>::Vector;
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    Vector       is_active(dof_handler.locally_owned_dofs(),
                     relevant,
                     communicator_of(dof_handler));
    const auto   first_owned = is_active.get_partitioner()->local_range().first;
    const Vector forces      = contact.vertical_forces_on_body(residual);
    Graph        graph;
    for (const unsigned int i : contact.active_entries())
      {
        is_active.local_element(i)         = 1.;
        graph.nodes[first_owned + i].force = -forces.local_element(i);
      }
    for (const unsigned int i : contact.entries_entered(displacement))
      is_active.local_element(i) = 1.;
    is_active.update_ghost_values();

    const auto                          &fe = dof_handler.get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
    const auto                           face_nodes = nodes_of_face(fe);
    FEFaceValues<dim>                    places(fe,
                             fe.get_unit_face_support_points(),
                             update_quadrature_points);
    for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
      {
        const auto face = cell->face(f);
        face->get_dof_indices(dofs);
        places.reinit(cell, f);
        std::vector<types::global_dof_index> active;
        bool                                 ends_here = false;
        for (const auto &components : face_nodes)
          {
            const auto dof = dofs[components[dim - 1]];
            if (hanging_nodes.is_constrained(dof))
              continue;
            if (is_active(dof) == 0.)
              {
                ends_here = true;
                continue;
              }
            active.push_back(dof);
            Node &node    = graph.nodes[dof];
            node.position = places.quadrature_point(components[dim - 1]);
            node.area += face->measure() / face_nodes.size();
            for (unsigned int d = 0; d < dim - 1; ++d)
              if (fixed_dofs.is_element(dofs[components[d]]))
                node.held_axes |= 1U << d;
          }
        for (const auto dof : active)
          {
            graph.nodes[dof].is_at_edge |= ends_here;
            graph.links.emplace_back(active.front(), dof);
          }
      }
    return graph;
  }



  template <int dim>
  typename ContactZone<dim>::Graph
  ContactZone<dim>::join(const std::vector<Graph> &parts)
  {
    Graph all;
    for (const Graph &part : parts)
      {
        for (const auto &[dof, other] : part.nodes)
          {
            Node &node = all.nodes[dof];
            if (other.area > 0.)
              node.position = other.position;
            node.area += other.area;
            node.force += other.force;
            node.held_axes |= other.held_axes;
            node.is_at_edge |= other.is_at_edge;
          }
        all.links.insert(all.links.end(), part.links.begin(), part.links.end());
      }
    return all;
  }



  template <int dim>
  void
  ContactZone<dim>::find_spots(const Graph &graph, const unsigned int degree)
  {
    std::map<types::global_dof_index, unsigned int> places;
    for (const auto &entry : graph.nodes)
      places.emplace(entry.first, places.size());
    boost::disjoint_sets_with_storage<> sets(places.size());
    for (const auto &[one, other] : graph.links)
      sets.union_set(places.at(one), places.at(other));

    struct Sums
    {
      Tensor<1, dim> position;
      double         area = 0, force = 0;
      unsigned int   n_nodes = 0, held_axes = 0;
    };
    std::map<unsigned int, unsigned int>             numbers;
    std::vector<Sums>                                sums;
    std::vector<std::pair<Point<dim>, unsigned int>> all, at_edge;
    for (const auto &[dof, node] : graph.nodes)
      {
        const unsigned int spot =
          numbers.emplace(sets.find_set(places.at(dof)), numbers.size())
            .first->second;
        sums.resize(numbers.size());
        sums[spot].position += node.position;
        sums[spot].area += node.area;
        sums[spot].force += node.force;
        sums[spot].held_axes |= node.held_axes;
        ++sums[spot].n_nodes;
        all.emplace_back(node.position, spot);
        if (node.is_at_edge)
          at_edge.emplace_back(node.position, spot);
      }
    touched = pack_rtree(all);
    edges   = pack_rtree(at_edge);

    for (const Sums &sum : sums)
      {
        const double n_images = 1U << std::bitset<dim>(sum.held_axes).count();
        const double area     = n_images * sum.area;
        const double n_elements =
          n_images * sum.n_nodes / Utilities::fixed_power<dim - 1>(degree);
        ContactSpot<dim> spot;
        spot.center          = Point<dim>(sum.position / sum.n_nodes);
        spot.force           = sum.force;
        spot.radius          = contact_radius(area, 1., dim == 2);
        spot.elements_across = 2. * contact_radius(n_elements, 1., dim == 2);
        spot.element_size    = 2. * spot.radius / spot.elements_across;
        all_spots.push_back(spot);
      }
  }



  template <int dim>
  std::string
  ContactZone<dim>::warning(const double detail) const
  {
    double force = 0, on_coarse_spots = 0, on_coarse_elements = 0;
    double fewest = std::numeric_limits<double>::infinity();
    for (const auto &spot : all_spots)
      {
        const double n_enough = all_spots.size() <= few_spots ? 8. : 4.;
        force += spot.force;
        if (spot.elements_across < n_enough)
          {
            on_coarse_spots += spot.force;
            fewest = std::min(fewest, spot.elements_across);
          }
        if (spot.element_size > 1.001 * detail)
          on_coarse_elements += spot.force;
      }
    const std::string remedy =
      " Set 'Refinement/Elements over contact radius', or make the mesh finer "
      "under the indenter.";
    const auto percent = [force](const double part) {
      return std::to_string(std::lround(100. * part / force)) + " %";
    };
    if (on_coarse_spots > 0.05 * force && all_spots.size() <= few_spots)
      {
        const long n = std::lround(fewest);
        return "The contact is only " + std::to_string(n) +
               (n == 1 ? " element" : " elements") +
               " wide; with fewer than 8, force and contact area are rough." +
               remedy;
      }
    if (on_coarse_spots > 0.05 * force)
      return percent(on_coarse_spots) + " of the force is on spots of " +
             std::to_string(all_spots.size()) +
             " that are fewer than 4 elements wide." + remedy;
    if (detail > 0. && on_coarse_elements > 0.5 * force)
      return "Where the indenter touches, the elements are larger than the "
             "pixels of its height map: it is not resolved." +
             remedy;
    return "";
  }



  template <int dim>
  double
  ContactZone<dim>::element_size(const Point<dim>  &x,
                                 const double       reach,
                                 const unsigned int n_over_radius,
                                 const double       growth) const
  {
    double     size       = std::numeric_limits<double>::infinity();
    const auto admit_near = [&](const Tree &tree, const double refinement) {
      std::vector<std::pair<Point<dim>, unsigned int>> nearest;
      tree.query(boost::geometry::index::nearest(x, 1),
                 std::back_inserter(nearest));
      for (const auto &[node, spot] : nearest)
        {
          const double radius = all_spots[spot].radius;
          const double away =
            std::max(x.distance(node) - reach - growth * radius, 0.);
          size = std::min(size,
                          radius / (n_over_radius * refinement) +
                            size_growth<dim> * away);
        }
    };
    admit_near(touched, 1.);
    admit_near(edges, edge_refinement<dim>);
    return size;
  }



  template class ContactZone<2>;
  template class ContactZone<3>;
} // namespace ElastoPlastic
