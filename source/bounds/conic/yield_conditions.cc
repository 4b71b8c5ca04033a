// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/conic/yield_conditions.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Where the component 12 is; other shear stresses follow.
    template <int dim>
    constexpr unsigned int first_shear = dim == 2 ? 2 : 3;
  } // namespace



  template <int dim>
  SymmetricTensor<2, 3>
  stress_from(const double *components)
  {
    SymmetricTensor<2, 3> stress;
    stress[0][0] = components[0];
    stress[1][1] = components[1];
    stress[2][2] = components[across<dim>];
    stress[0][1] = components[first_shear<dim>];
    if (dim == 3)
      {
        stress[0][2] = components[4];
        stress[1][2] = components[5];
      }
    return stress;
  }



  template <int dim>
  FullMatrix<double>
  deviator_matrix()
  {
    // (after the first row, that of each component but 11 and 22)
    FullMatrix<double> d(n_stress_components<dim> - 1,
                         n_stress_components<dim>);
    d(0, 0) = std::sqrt(0.5);
    d(0, 1) = -std::sqrt(0.5);
    for (unsigned int c = 2; c < n_stress_components<dim>; ++c)
      d(c - 1, c) = std::sqrt(c == across<dim> ? 2. / 3. : 2.);
    d(across<dim> - 1, 0) = d(across<dim> - 1, 1) = -std::sqrt(1. / 6.);
    return d;
  }



  void
  add_yield_conditions(ConicBlock                &block,
                       const FullMatrix<double>  &deviator,
                       const FullMatrix<double>  &point_stresses,
                       const std::vector<double> &weights,
                       const double               radius)
  {
    const unsigned int n_components = deviator.n();
    const unsigned int size         = 1 + deviator.m();
    const unsigned int n            = point_stresses.n();
    const unsigned int n_cones =
      weights.size() - std::count(weights.begin(), weights.end(), 0.);

    block.cone_matrix.reinit(size * n_cones, n);
    block.cone_offset.reinit(size * n_cones);
    block.cone_sizes.assign(n_cones, size);
    block.cone_scales.assign(n_cones, ConeScale());
    unsigned int row = 0;
    for (unsigned int p = 0; p < weights.size(); ++p)
      if (weights[p] > 0)
        {
          block.cone_offset[row] = radius;
          for (unsigned int d = 0; d < deviator.m(); ++d)
            for (unsigned int c = 0; c < n_components; ++c)
              if (deviator(d, c) != 0.)
                for (unsigned int j = 0; j < n; ++j)
                  block.cone_matrix(row + 1 + d, j) -=
                    deviator(d, c) *
                    (1. / weights[p] * point_stresses(n_components * p + c, j));
          row += size;
        }
  }



  template <int dim>
  void
  add_friction(ConicBlock                &block,
               const FullMatrix<double>  &point_stresses,
               const std::vector<double> &weights,
               const std::vector<double> &pressures,
               const double               slope)
  {
    constexpr unsigned int n_components = n_stress_components<dim>;

    const double factor = std::sqrt(2.) * slope;
    unsigned int cone   = 0;
    for (unsigned int p = 0; p < weights.size(); ++p)
      if (weights[p] > 0)
        {
          const unsigned int row = n_components * cone;
          block.cone_offset[row] += factor * pressures[cone++];
          for (const unsigned int c : {0u, 1u, across<dim>})
            for (unsigned int j = 0; j < point_stresses.n(); ++j)
              block.cone_matrix(row, j) +=
                factor / (3. * weights[p]) *
                point_stresses(n_components * p + c, j);
        }
  }



  template SymmetricTensor<2, 3>
  stress_from<2>(const double *);
  template SymmetricTensor<2, 3>
  stress_from<3>(const double *);
  template FullMatrix<double>
  deviator_matrix<2>();
  template FullMatrix<double>
  deviator_matrix<3>();
  template void
  add_friction<2>(ConicBlock &,
                  const FullMatrix<double> &,
                  const std::vector<double> &,
                  const std::vector<double> &,
                  const double);
  template void
  add_friction<3>(ConicBlock &,
                  const FullMatrix<double> &,
                  const std::vector<double> &,
                  const std::vector<double> &,
                  const double);
} // namespace ElastoPlastic
