// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_edge_law_h
#define contact_edge_law_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "base/shared_rows.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// Where the contact may end.
  enum class EdgeRule
  {
    within_faces,
    at_nodes,
    /// Nodes bear force as at_nodes; the area that is touched ends within
    /// faces.
    measured_within_faces
  };

  template <>
  inline const EnumNames<EdgeRule> enum_names<EdgeRule> = {
    {"within faces", EdgeRule::within_faces}, {"at nodes", EdgeRule::at_nodes}};



  /// What a node does in contact.
  enum class ContactStatus : unsigned char
  {
    open,     ///< it bears no force
    entering, ///< the edge of the contact is on its way to it: it bears a part
              ///< of what its inner neighbours bear
    closed    ///< it is on the indenter
  };



  /// The edge of a contact that ends within faces: a closed convex set of
  /// displacements, given by the mesh and the gap function alone
  /// (doc/theory, "The edge of the contact").
  ///
  /// A node b that is not a local minimum of the gap function g has inner
  /// neighbours j, where g is lower, and a rise R_b: what g rises by from them
  /// to b. The opening y_b falls from 1 to 0 while the edge moves from them to
  /// b. With the distances gap_j from the indenter, the set is
  ///
  ///   gap_j + allowance_j >= R_j y_j,   0 <= y_j <= 1,
  ///   allowance_j = sum_b c_jb R_b P(y_b)   over the outer neighbours b of j,
  ///
  /// with a concave P. A node that is entering gets the force
  /// P'(y_b) sum_j c_jb lambda_j, where the lambda_j are those of its inner
  /// neighbours.
  ///
  /// Nodes are the contact candidates of this rank, in the order passed to
  /// reinit(). An object made by default has no nodes: contact ends at nodes.
  class EdgeLaw
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// A candidate: its vertical unknown, the place of that in vectors of all
    /// unknowns of this rank, the gap in the undeformed body, and the lumped
    /// area.
    struct Node
    {
      types::global_dof_index dof;
      unsigned int            entry;
      double                  gap;
      double                  area;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &dof &entry &gap &area;
      }
    };

    /// Two unknowns of nodes that share a face.
    using Pair = std::pair<types::global_dof_index, types::global_dof_index>;

    /// Takes the @p nodes of this rank, in ascending order, and the pairs of
    /// its faces, once for each face that has both; what is no node on any rank
    /// is passed over. Collective.
    void
    reinit(const std::vector<Node> &nodes,
           const std::vector<Pair> &pairs,
           const MPI_Comm           communicator);

    /// Where the edge is.
    struct Place
    {
      /// y_j, with ghosts.
      Vector openings;
      /// By nodes.
      std::vector<double> allowances;
    };

    /// With these @p gaps of the nodes: y is 0 at closed nodes, and follows
    /// from the gaps at others; where these are beyond their bound it is
    /// negative, as if P were continued linearly. Collective.
    Place
    place(const std::vector<double>        &gaps,
          const std::vector<ContactStatus> &statuses) const;

    /// The largest y that the gaps allow, at all nodes: displacements are in
    /// the set if and only if no gap + allowance is negative. Collective.
    Place
    largest_openings(const std::vector<double> &gaps) const;

    /// What a node that is not closed is whose gap and allowance add up to
    /// @p distance.
    ContactStatus
    status_at(const unsigned int node, const double distance) const
    {
      return has_part(node) && distance < rise(node) ? ContactStatus::entering :
                                                       ContactStatus::open;
    }

    /// Whether the node can bear a part of what others bear.
    bool
    has_part(const unsigned int node) const
    {
      return exists() && parts[node];
    }

    /// R_b; 0 at local minima of the gap.
    double
    rise(const unsigned int node) const
    {
      return exists() ? rises.local_element(node) : 0.;
    }

    /// sum_j c_jb lambda_j, for all nodes b of this rank, of the forces of the
    /// nodes. Collective.
    std::vector<double>
    forces_inside(const std::vector<double> &forces) const;

    /// Which nodes the edge has passed: the closed ones, and those that are
    /// entering and inside (with gaps below zero) or have outer neighbours only
    /// that it has passed. Collective.
    std::vector<bool>
    passed(const std::vector<double>        &gaps,
           const std::vector<ContactStatus> &statuses) const;

    /// Hands the @p values of nodes that do not @p keep them to their inner
    /// neighbours, and on until all are kept; to each in proportion to its part
    /// c_jb lambda_j of forces_inside(). Nodes without such neighbours keep
    /// theirs. Collective.
    std::vector<double>
    handed_inside(const std::vector<double> &values,
                  const std::vector<bool>   &keep,
                  const std::vector<double> &forces) const;

    /// The share P'(y) of these that a node with the opening y has.
    static double
    share(const double opening);

    /// The same for the edge at the node itself: a closed node that has less
    /// is entering.
    static double
    full_share()
    {
      return share(0.);
    }

    /// How fast the share falls with the distance: the stiffness of an
    /// entering node is so many times its force_inside.
    double
    stiffness(const unsigned int node, const double opening) const;

    /// The rows t_jb = c_jb P'(y_b) of closed and entering nodes j with the
    /// entering nodes b, as unknowns of vectors; null if the law does not
    /// exist. Collective.
    std::shared_ptr<const SharedRows>
    rows(const Place &place, const std::vector<ContactStatus> &statuses) const;

    /// Whether the contact may end within faces.
    bool
    exists() const
    {
      return layout != nullptr;
    }

  private:
    /// Goes from high to low until all openings agree with what
    /// opening(node, distance) makes of gap + allowance.
    template <typename Opening>
    Place
    sweep(const std::vector<double> &gaps, const Opening &opening) const;

    double
    allowance(const unsigned int node, const Vector &openings) const;

    /// The coefficients c_jb of the outer neighbours b of node j.
    struct Entry
    {
      unsigned int node; ///< local to this rank, perhaps a ghost
      double       coefficient;
    };

    /// Whether a node has outer neighbours, and none of them is @p outside,
    /// where that is not zero.
    bool
    is_within(const unsigned int node, const Vector &outside) const;

    std::shared_ptr<const Utilities::MPI::Partitioner> layout;
    std::vector<std::vector<Entry>>                    outer_neighbors;
    /// R, with ghosts.
    Vector                    rises;
    std::vector<bool>         parts;
    std::vector<unsigned int> from_high_to_low;
    std::vector<unsigned int> entries;
  };



  /// How the gap function rises from node to node, of all nodes of all ranks:
  /// the coefficients of EdgeLaw. The rises, and the products of coefficients
  /// and rises, change continuously with the gaps.
  struct RiseOfGap
  {
    /// Of @p nodes in ascending order, the same on all ranks, and the pairs of
    /// the faces of this rank. Collective.
    RiseOfGap(const std::vector<EdgeLaw::Node> &nodes,
              const std::vector<EdgeLaw::Pair> &pairs,
              const MPI_Comm                    communicator);

    struct Neighbor
    {
      unsigned int node;
      double       coefficient;
    };

    /// By node j: its outer neighbours b and c_jb.
    std::vector<std::vector<Neighbor>> outer_neighbors;

    /// R_b; and whether any c_jb is larger than 0.
    std::vector<double> rises;
    std::vector<bool>   have_part;
  };
} // namespace ElastoPlastic

#endif
