// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_rigid_body_modes_h
#define mechanics_rigid_body_modes_h

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

  /// Names a rigid body motion that the supports do not prevent, such as
  /// "rotation about z"; empty if there is none. @p held has ones at the held
  /// degrees of freedom, zeros elsewhere; @p constraints hold the rest.
  template <int dim>
  std::string
  find_free_motion(
    const std::vector<LinearAlgebra::distributed::Vector<double>> &modes,
    const LinearAlgebra::distributed::Vector<double>              &held,
    const AffineConstraints<double>                               &constraints);
} // namespace ElastoPlastic

#endif
