// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_element_quality_h
#define evaluation_element_quality_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// How good the worst corner of a deformed mesh is, and where it is now.
  template <int dim>
  struct ElementQuality
  {
    double     scaled_jacobian;
    Point<dim> place;
  };

  /// The smallest scaled Jacobian of all corners of all cells
  /// @cite knupp_2000, of a body whose points have moved by @p displacement:
  /// the determinant of the edges that meet in a corner over the product of
  /// their lengths. 1 for right angles, 0 where a corner has collapsed,
  /// negative where it is turned inside out. Collective.
  template <int dim>
  ElementQuality<dim>
  worst_element(const DoFHandler<dim>                            &dof_handler,
                const LinearAlgebra::distributed::Vector<double> &displacement);
} // namespace ElastoPlastic

#endif
