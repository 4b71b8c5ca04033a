// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_rigid_body_modes_h
#define mechanics_rigid_body_modes_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The rigid body motions of a body as nodal displacement fields: dim
  /// translations, then the rotations (1 in 2D, 3 in 3D) about the midpoint of
  /// the body's bounding box, scaled to displacements of order one.
  /// @p layout gives the partition of the vectors.
  template <int dim>
  std::vector<LinearAlgebra::distributed::Vector<double>>
  rigid_body_modes(const DoFHandler<dim> &dof_handler,
                   const LinearAlgebra::distributed::Vector<double> &layout);

  /// A rigid body motion that nothing prevents.
  template <int dim>
  struct FreeMotion
  {
    std::string      name; ///< such as "rotation about z"
    BoundingBox<dim> part; ///< around what moves
    bool             whole_body;
    /// The motion as a nodal field of order one; zero in other parts.
    LinearAlgebra::distributed::Vector<double> displacement;
  };



  /// A basis of the rigid body motions that the supports do not prevent, of
  /// each of the ConnectedParts of the body, which must be held by itself:
  /// first those that are a translation or a rotation alone. @p held has ones
  /// at the held degrees of freedom, zeros elsewhere; @p constraints hold the
  /// rest. Collective.
  template <int dim>
  std::vector<FreeMotion<dim>>
  free_motions(const DoFHandler<dim>                            &dof_handler,
               const LinearAlgebra::distributed::Vector<double> &held,
               const AffineConstraints<double>                  &constraints);
} // namespace ElastoPlastic

#endif
