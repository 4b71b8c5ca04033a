// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_faces_h
#define contact_contact_faces_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "base/kinematics.h"
#include "contact/edge_law.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The faces of the contact surface, and the part of them that the indenter
  /// touches: the edge of the contact need not go through nodes (doc/theory,
  /// "The edge of the contact").
  ///
  /// Between nodes a level is interpolated that vanishes at the edge. It is
  /// given at the nodes that are not closed, from 0 (the edge is there) to 1
  /// (it is still at the closed neighbours). Of a face with nodes of both
  /// kinds, the touched part belongs to the closed ones. The faces of quadratic
  /// elements count as 2^(dim-1) linear ones.
  ///
  /// All vectors have the partition of the one passed to reinit(), which knows
  /// the unknowns of this rank's cells, and what hanging ones are interpolated
  /// from.
  template <int dim>
  class ContactFaces
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// Which nodes a vector of kinds tells apart.
    static constexpr double no_candidate = 0., not_closed = 1., closed = 2.;

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

    /// The same faces, where the displacement @p u has brought them, seen from
    /// above. Collective.
    ContactFaces
    moved(const Vector &u) const;

    /// The pairs of nodes of the faces of this rank, face by face; hanging
    /// nodes are replaced by their masters.
    std::vector<EdgeLaw::Pair>
    neighbors() const;

    /// The levels of nodes that are not closed, of the @p gaps of these and of
    /// the next ones behind them; 1 at those that are no neighbours of closed
    /// ones. Collective.
    Vector
    levels(const Vector &kinds, const Vector &gaps) const;

    /// What each closed node has of the touched part: the integral of its own
    /// shape function over it, and of those of the nodes of a face that are not
    /// closed the part that is in proportion to its own. @p kinds has the kind
    /// of each node, @p levels the level of the others. A face with a node that
    /// is no candidate is touched as a whole. A node none of
    /// whose faces has closed nodes only counts as a whole, too: there is no
    /// edge that could be followed. Collective.
    Vector
    touched_areas(const Vector &kinds, const Vector &levels) const;

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

    const AffineConstraints<double> *constraints = nullptr;
    Kinematics                       kinematics  = Kinematics::cartesian;
    std::vector<Face>                faces;
    std::shared_ptr<const Utilities::MPI::Partitioner> vector_layout;
  };
} // namespace ElastoPlastic

#endif
