// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_yield_conditions_h
#define bounds_conic_yield_conditions_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "bounds/conic/conic_program.h"

// With the mean stress m, tension being positive, a strength that grows with
// the pressure is
//   |dev s| <= R - sqrt(2) f m,
// with the yield radius R of the material and a slope 0 <= f < 1. In plane
// strain, with s_33 = m = (s_11 + s_22) / 2, that is Mohr and Coulomb's yield
// condition if f is the sine of the angle of internal friction and, with the
// cohesion c, R = sqrt(2) c cos(phi):
//   |((s_11 - s_22) / 2, s_12)| <= c cos(phi) - sin(phi) (s_11 + s_22) / 2.
// In other bodies it is a cone of Drucker and Prager, see SoilParameters.

namespace ElastoPlastic
{
  using namespace dealii;



  /// The components of a stress: in the plane 11, 22, 12 and 33, in space those
  /// of SymmetricTensor, 11, 22, 33, 12, 13, 23.
  template <int dim>
  constexpr unsigned int n_stress_components = dim == 2 ? 4 : 6;

  /// Where the component 33 is among them.
  template <int dim>
  constexpr unsigned int across = dim == 2 ? 3 : 2;

  /// The stress with these @p components.
  template <int dim>
  SymmetricTensor<2, 3>
  stress_from(const double *components);

  /// The deviator of a stress, in an orthonormal basis.
  template <int dim>
  FullMatrix<double>
  deviator_matrix();

  /// Adds the cones |@p deviator tau| <= @p radius times a weight to a @p block
  /// without any, for the stresses tau = @p point_stresses x: all components at
  /// each of several points, of which those with the weight zero have no
  /// condition. @p deviator is deviator_matrix(), or what else turns components
  /// into as many numbers.
  void
  add_yield_conditions(ConicBlock                &block,
                       const FullMatrix<double>  &deviator,
                       const FullMatrix<double>  &point_stresses,
                       const std::vector<double> &weights,
                       const double               radius);



  /// Lets the yield conditions with which the cones of a @p block begin depend
  /// on the pressure.
  /// @param point_stresses what add_yield_conditions() was given
  /// @param weights the same
  /// @param pressures what the stresses lack, by cones: a pressure that has
  ///   been taken out of them
  /// @param slope f
  template <int dim>
  void
  add_friction(ConicBlock                &block,
               const FullMatrix<double>  &point_stresses,
               const std::vector<double> &weights,
               const std::vector<double> &pressures,
               const double               slope);
} // namespace ElastoPlastic

#endif
