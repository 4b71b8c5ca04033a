// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_divided_edge_h
#define contact_divided_edge_h

#include <memory>

#include "base/shared_rows.h"
#include "contact/contact_edge.h"

namespace ElastoPlastic
{
  /// The edge of a contact that ends within faces (doc/theory.md, "The edge of
  /// the contact"): where it is in the load step under way, the rows that nodes
  /// share for that reason, and what is remembered of the steps before, from
  /// which its place is expected.
  ///
  /// Nodes are entries of vectors with the partition of the one passed to
  /// reinit(); their kinds are those of ContactEdge, their distances from the
  /// indenter count for candidates only. All functions that change something
  /// are collective.
  template <int dim>
  class DividedEdge
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// Finds the faces, see ContactEdge; nothing is remembered.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &boundaries,
           const Kinematics                    kinematics,
           const Vector                       &layout);

    const ContactEdge<dim> &
    faces() const
    {
      return all_faces;
    }

    /// What note() has noted on this mesh, and how the edge is divided.
    EdgeMemory &
    edge_memory()
    {
      return memory;
    }

    /// Whether the edge is divided for an indenter at least as deep as that.
    bool
    reaches(const double depth) const
    {
      return memory.is_divided && depth <= memory.divided_at;
    }

    /// The levels of the neighbours of a contact with these nodes.
    Vector
    levels(const Vector &kinds, const Vector &distances) const;

    /// Divides the edge of a contact with nodes of these @p kinds and lumped
    /// @p areas where it is expected when the indenter will be at
    /// @p expected_depth; not if it is not known how the edge has moved, or if
    /// it retreats.
    void
    divide(const Vector &kinds,
           const Vector &areas,
           const double  expected_depth);

    /// Divides it as the memory says, after a checkpoint.
    void
    restore(const Vector &areas);

    /// Lets the contact end at nodes.
    void
    unite();

    /// Makes the shared rows for a contact with ones in @p active at its nodes.
    void
    share_rows(const Vector &active);

    /// Null if the contact ends at nodes.
    const std::shared_ptr<const SharedRows> &
    rows() const
    {
      return shared_rows;
    }

    /// The area on which a node presses, of which @p whole belongs to it where
    /// the contact ends at nodes; if it @p shares its row, that of its own part
    /// of the touched faces.
    double
    own_area(const unsigned int node,
             const bool         shares,
             const double       whole) const
    {
      return shares ? 1. / scale->local_element(node) : whole;
    }

    /// A load step has ended with these nodes, and the indenter at @p depth:
    /// notes how far away they are.
    void
    note(const Vector &kinds, const Vector &distances, const double depth);

  private:
    /// Those expected at a depth, from the last ones noted.
    Vector
    expected_distances(const double depth) const;

    ContactEdge<dim> all_faces;
    EdgeMemory       memory;

    // The weights of shared rows, null without; and the rows.
    std::shared_ptr<const SharedRows::Weights> weights;
    std::shared_ptr<const Vector>              scale;
    std::shared_ptr<const SharedRows>          shared_rows;
  };
} // namespace ElastoPlastic

#endif
