// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_nodes_h
#define contact_contact_nodes_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <functional>
#include <set>
#include <vector>

#include "base/kinematics.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The vertical degree of freedom of a node of the contact surface.
  struct ContactNode
  {
    /// Local to this rank.
    unsigned int index;
    /// The vertical distance up to the undisplaced indenter.
    double gap;
    /// The integral of the node's shape function; hanging nodes hand theirs to
    /// their masters.
    double area;
    /// Whether it has no pressure of its own: hanging nodes, those that are
    /// constrained otherwise, and a node without area (that of quadratic
    /// elements on the axis of an axisymmetric body).
    bool hanging;
  };



  /// Finds the nodes on @p boundaries that this rank owns and that have a
  /// finite gap, in the order of their indices. @p layout gives the partition
  /// of vectors.
  template <int dim>
  std::vector<ContactNode>
  find_contact_nodes(const DoFHandler<dim>              &dof_handler,
                     const AffineConstraints<double>    &constraints,
                     const std::set<types::boundary_id> &boundaries,
                     const std::function<double(const Point<dim> &)> &gap,
                     const Kinematics kinematics,
                     const LinearAlgebra::distributed::Vector<double> &layout);
} // namespace ElastoPlastic

#endif
