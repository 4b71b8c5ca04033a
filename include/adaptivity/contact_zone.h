// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef adaptivity_contact_zone_h
#define adaptivity_contact_zone_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/numerics/rtree.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A part of the contact surface that the indenter touches, and that is
  /// connected. Where it meets planes of symmetry, the numbers are those of the
  /// whole spot.
  template <int dim>
  struct ContactSpot
  {
    /// The mean of its nodes, of the modelled part.
    Point<dim> center;
    /// See contact_radius(): that of a circle with the same area; in two
    /// dimensions, half the width.
    double radius = 0;
    /// The number of elements on a diameter, and their mean size.
    double elements_across = 0;
    double element_size    = 0;
    /// Of the modelled part.
    double force = 0;
  };



  /// Where the indenter touches the body, known to all ranks: spots, their
  /// edges, and how small the elements around them should be.
  template <int dim>
  class ContactZone
  {
  public:
    /// The active nodes of @p contact on @p boundaries or, before there are
    /// any, those without area that the indenter has entered
    /// (entries_entered()). On planes of symmetry and on the axis of
    /// revolution, horizontal components are among @p fixed_dofs, the locally
    /// relevant ones. Collective.
    ContactZone(const DoFHandler<dim>                  &dof_handler,
                const AffineConstraints<double>        &hanging_nodes,
                const IndexSet                         &fixed_dofs,
                const std::set<types::boundary_id>     &boundaries,
                const ContactSet<dim>                  &contact,
                const typename ContactSet<dim>::Vector &displacement,
                const typename ContactSet<dim>::Vector &residual);

    const std::vector<ContactSpot<dim>> &
    spots() const
    {
      return all_spots;
    }

    /// How large elements within @p reach of @p x may be, so that @p
    /// n_over_radius of them fit into the radius of the next spot, and more at
    /// its edge, where the pressure falls steeply; away from the spots they
    /// grow. @p growth is how far the spots are expected to grow, as a part of
    /// their radius. Infinite without contact.
    double
    element_size(const Point<dim>  &x,
                 const double       reach,
                 const unsigned int n_over_radius,
                 const double       growth) const;

    /// What to say where there are too few elements to trust force and area:
    /// fewer than 8 across most of the contact, or 4 across many small spots,
    /// or elements that are larger than a @p detail of the indenter. Empty
    /// otherwise.
    std::string
    warning(const double detail) const;

  private:
    struct Node
    {
      Point<dim>   position;
      double       area       = 0; ///< its share of the faces
      double       force      = 0;
      unsigned int held_axes  = 0; // bit by bit
      bool         is_at_edge = false;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &position &area &force &held_axes &is_at_edge;
      }
    };

    using Nodes = std::map<types::global_dof_index, Node>;
    using Links =
      std::vector<std::pair<types::global_dof_index, types::global_dof_index>>;
    using Tree = RTree<std::pair<Point<dim>, unsigned int>>;

    /// The touched nodes of one rank, or of all, and which of them share a
    /// face.
    struct Graph
    {
      Nodes nodes;
      Links links;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &nodes &links;
      }
    };

    /// What the faces of this rank know.
    static Graph
    find_nodes(const DoFHandler<dim>                  &dof_handler,
               const AffineConstraints<double>        &hanging_nodes,
               const IndexSet                         &fixed_dofs,
               const std::set<types::boundary_id>     &boundaries,
               const ContactSet<dim>                  &contact,
               const typename ContactSet<dim>::Vector &displacement,
               const typename ContactSet<dim>::Vector &residual);

    static Graph
    join(const std::vector<Graph> &parts);

    void
    find_spots(const Graph &graph, const unsigned int degree);

    std::vector<ContactSpot<dim>> all_spots;

    // Nodes with the number of their spot: all of them, and those at an edge.
    Tree touched, edges;
  };
} // namespace ElastoPlastic

#endif
