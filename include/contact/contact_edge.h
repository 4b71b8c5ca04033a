// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_edge_h
#define contact_contact_edge_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "base/enum_names.h"
#include "base/kinematics.h"
#include "base/shared_rows.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Where the contact may end.
  enum class EdgeRule
  {
    within_faces,
    at_nodes
  };

  template <>
  inline const EnumNames<EdgeRule> enum_names<EdgeRule> = {
    {"within faces", EdgeRule::within_faces}, {"at nodes", EdgeRule::at_nodes}};



  /// What is remembered of the edge of the contact at the ends of the last load
  /// steps on a mesh, by nodes. The vectors are empty until allocate(): the
  /// first step has nothing to remember.
  struct EdgeMemory
  {
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// How far away a neighbour of the contact is as long as the edge is at the
    /// last node in contact; 0 where that is not known.
    Vector gaps_at_edge;
    /// The same for the next nodes, in case they become neighbours.
    Vector gaps_beyond;

    /// The distances of all candidates from the indenter, and its depth: the
    /// last one first.
    std::array<Vector, 3> distances;
    std::array<double, 3> depths  = {{0., 0., 0.}};
    unsigned int          n_steps = 0;

    /// What the present rows have been made of: the Kind of each node in
    /// ContactEdge, and its level; and for which depth. No rows if not @p
    /// is_divided.
    Vector kinds, levels;
    bool   is_divided = false;
    double divided_at = 0;

    std::vector<Vector *>
    vectors()
    {
      return {&gaps_at_edge,
              &gaps_beyond,
              &kinds,
              &levels,
              &distances[0],
              &distances[1],
              &distances[2]};
    }

    /// Forgets everything.
    void
    clear()
    {
      // (an assignment would keep the partition on ranks without unknowns)
      for (Vector *vector : vectors())
        {
          Vector empty;
          vector->swap(empty);
        }
      n_steps    = 0;
      is_divided = false;
    }

    /// Makes the vectors that are empty zero, with the partition of @p layout.
    void
    allocate(const Vector &layout)
    {
      for (Vector *vector : vectors())
        if (vector->size() == 0)
          vector->reinit(layout);
    }

    /// Goes on with the distances @p noted on another mesh, interpolated.
    void
    take_over(EdgeMemory &&noted)
    {
      for (unsigned int i = 0; i < distances.size(); ++i)
        distances[i].swap(noted.distances[i]);
      depths  = noted.depths;
      n_steps = noted.n_steps;
      allocate(distances[0]);
    }

    /// What is not a vector, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      for (double &depth : depths)
        archive &depth;
      archive &n_steps &is_divided &divided_at;
    }
  };



  /// The faces of the contact surface, and the part of them that the indenter
  /// touches: the edge of the contact need not go through nodes (doc/theory.md,
  /// "The edge of the contact").
  ///
  /// Between nodes a level is interpolated that vanishes at the edge. It is
  /// given at the nodes that do not touch, from 0 (just about to) to 1 (the
  /// edge is still at the neighbours that do touch). Where a face has nodes of
  /// both kinds, the integral of the shape function of a node that does not
  /// touch, over the part that is touched, belongs to the nodes of the face
  /// that do. The faces of quadratic elements count as 2^(dim-1) linear ones.
  ///
  /// All vectors have the partition of the one passed to reinit(), which knows
  /// the unknowns of this rank's cells, and what hanging ones are interpolated
  /// from.
  template <int dim>
  class ContactEdge
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// Which nodes a vector of kinds tells apart.
    enum Kind
    {
      no_candidate = 0,
      open         = 1,
      touching     = 2
    };

    /// Finds the faces on @p boundaries; @p constraints are those of hanging
    /// nodes, and must outlive this object or the next call. Collective.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &boundaries,
           const Kinematics                    kinematics,
           const Vector                       &layout);

    /// The integrals of the shape functions of the nodes over whole faces,
    /// those of hanging nodes handed to their masters. Collective.
    Vector
    areas() const;

    /// The partition of all vectors.
    const std::shared_ptr<const Utilities::MPI::Partitioner> &
    layout() const
    {
      return vector_layout;
    }

    /// The same faces, where the displacement @p u has brought them, seen from
    /// above. Collective.
    ContactEdge
    moved(const Vector &u) const;

    /// What the nodes have of the touched part.
    struct TouchedPart
    {
      /// By touching nodes: what the integrals of their own shape functions
      /// over the part fall short of those over the whole faces.
      Vector missing;
      /// Row by row, for touching nodes: what they take over of the open nodes
      /// (columns).
      std::shared_ptr<const SharedRows::Weights> taken_over;
    };

    /// With the Kind of each node in @p kinds, and the @p levels of the open
    /// ones. Faces with a node that is no candidate are touched as a whole.
    /// Collective.
    TouchedPart
    touched_part(const Vector &kinds, const Vector &levels) const;

    /// Ones at the open nodes that share a face with a touching one.
    /// Collective.
    Vector
    neighbors(const Vector &kinds) const;

    /// Ones at the nodes of the faces all of whose nodes touch. Collective.
    Vector
    inside(const Vector &kinds) const;

    /// How much @p values grow from these @p neighbors to the next open nodes:
    /// the largest difference on a common face, for both of them; 0 elsewhere.
    /// Collective.
    Vector
    growth_beyond(const Vector &kinds,
                  const Vector &neighbors,
                  const Vector &values) const;

  private:
    static constexpr unsigned int n_nodes = 1 << (dim - 1);

    /// A linear or bilinear face between neighbouring nodes.
    struct Face
    {
      std::array<types::global_dof_index, n_nodes> dofs;
      /// The horizontal unknowns and positions of the nodes.
      std::array<std::array<types::global_dof_index, dim - 1>, n_nodes>
                                      horizontal;
      std::array<Point<dim>, n_nodes> positions;
      /// Density of the area at the nodes, axisymmetric: of whole rings.
      std::array<double, n_nodes> density;
      /// The integrals of the shape functions over the whole face.
      std::array<double, n_nodes> areas;
    };

    /// The integrals of the shape functions over the part of @p face with
    /// negative @p levels.
    static std::array<double, n_nodes>
    integrate(const Face &face, const std::array<double, n_nodes> &levels);

    /// The density of the area of a face whose nodes are at @p positions, seen
    /// from above.
    std::array<double, n_nodes>
    projected_density(const std::array<Point<dim>, n_nodes> &positions) const;

    void
    find_areas();

    const AffineConstraints<double>                   *constraints = nullptr;
    Kinematics                                         kinematics;
    std::vector<Face>                                  faces;
    std::shared_ptr<const Utilities::MPI::Partitioner> vector_layout;
  };
} // namespace ElastoPlastic

#endif
