// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_kinematics_h
#define base_kinematics_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// What the coordinates of a mesh mean.
  enum class Kinematics
  {
    cartesian,    ///< a body in space; in two dimensions, its section in plane
                  ///< strain, of unit thickness
    plane_stress, ///< in two dimensions, a sheet of unit thickness that bears
                  ///< no stress across
    axisymmetric  ///< in two dimensions, the half section x = r >= 0 of a body
                  ///< of revolution about the axis x = 0
  };



  /// How much of the body a point of the mesh stands for, per unit of the
  /// mesh's area or length: 2 pi r for a ring.
  template <int dim, typename Number>
  Number
  extent(const Point<dim, Number> &point, const Kinematics kinematics)
  {
    return kinematics == Kinematics::axisymmetric ?
             2. * numbers::PI * point[0] :
             Number(1.);
  }
} // namespace ElastoPlastic

#endif
