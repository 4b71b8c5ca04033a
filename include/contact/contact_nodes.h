// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_nodes_h
#define contact_contact_nodes_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <functional>
#include <set>
#include <vector>

#include "base/kinematics.h"
#include "contact/coulomb_friction.h"
#include "contact/edge_law.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// For each node of a face of the element FE_Q(p)^dim, the places of its
  /// components among the degrees of freedom of the face.
  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  nodes_of_face(const FiniteElement<dim> &fe)
  {
    std::vector<std::array<unsigned int, dim>> nodes(fe.n_dofs_per_face() /
                                                     dim);
    for (unsigned int i = 0; i < fe.n_dofs_per_face(); ++i)
      {
        const auto [component, node] = fe.face_system_to_component_index(i);
        nodes[node][component]       = i;
      }
    return nodes;
  }



  /// The same by their place in the lattice of (p + 1)^(dim-1) nodes.
  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  lattice_of_face(const FiniteElement<dim> &fe)
  {
    const std::vector<unsigned int> to_lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim - 1>(fe.degree);
    const auto                                 nodes = nodes_of_face(fe);
    std::vector<std::array<unsigned int, dim>> lattice(nodes.size());
    for (unsigned int node = 0; node < nodes.size(); ++node)
      lattice[to_lexicographic[node]] = nodes[node];
    return lattice;
  }



  /// A node of the contact surface. Indices are local to this rank.
  template <int dim>
  struct ContactNode
  {
    /// Of its vertical unknown, and of the horizontal ones.
    unsigned int                      index;
    std::array<unsigned int, dim - 1> horizontal;
    /// How its horizontal displacements follow from the free ones among them,
    /// u_d = sum_e ties[d][e] u_e: not the identity on a skew plane of
    /// symmetry.
    Tensor<2, dim - 1> ties;
    /// In the undeformed body.
    Point<dim> position;
    /// The vertical distance up to the undisplaced indenter, infinite where
    /// that does not reach, and how it changes.
    IndenterSurface<dim> gap;
    /// The integral of the node's shape function; hanging nodes hand theirs to
    /// their masters.
    double area;
    /// Whether it has no pressure of its own: hanging nodes, those that are
    /// constrained otherwise, and a node without area (that of quadratic
    /// elements on the axis of an axisymmetric body).
    bool hanging;
    /// Whether that is so only because it has no area.
    bool without_area;
  };



  /// A node with what it does in contact.
  template <int dim>
  struct ContactCandidate : ContactNode<dim>
  {
    ContactStatus status = ContactStatus::open;

    /// Whether it bears force.
    bool
    is_active() const
    {
      return status != ContactStatus::open;
    }

    /// Which of its horizontal displacements no support holds.
    std::array<bool, dim - 1> free = {};
    /// The horizontal displacement with which it sticks.
    TangentVector<dim> anchor;
    /// How far it was below the indenter when the load step began.
    double             first_distance = 0.;
    FrictionState<dim> friction;
  };



  /// The horizontal components of a vector at @p node.
  template <int dim>
  Tensor<1, dim - 1>
  horizontal_part(const ContactNode<dim>                           &node,
                  const LinearAlgebra::distributed::Vector<double> &vector)
  {
    Tensor<1, dim - 1> part;
    for (unsigned int d = 0; d < dim - 1; ++d)
      part[d] = vector.local_element(node.horizontal[d]);
    return part;
  }



  /// Finds the nodes on @p boundaries that this rank owns, in the order of
  /// their indices. @p gap gives that of a point of the undeformed surface,
  /// @p layout the partition of vectors.
  template <int dim>
  std::vector<ContactNode<dim>>
  find_contact_nodes(
    const DoFHandler<dim>                                         &dof_handler,
    const AffineConstraints<double>                               &constraints,
    const std::set<types::boundary_id>                            &boundaries,
    const std::function<IndenterSurface<dim>(const Point<dim> &)> &gap,
    const Kinematics                                               kinematics,
    const LinearAlgebra::distributed::Vector<double>              &layout);
} // namespace ElastoPlastic

#endif
