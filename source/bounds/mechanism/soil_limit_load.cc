// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/largest_error.h"
#include "bounds/mechanism/sheet_program.h"
#include "bounds/mechanism/soil_limit_load.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A strain rate in the plane: the rate of volume, and the shear rate
    /// |(e_11 - e_22, 2 e_12)|.
    struct Rate
    {
      double volume, shear;
    };



    /// Those of the coefficients of the strain rate, a quadratic polynomial.
    std::array<Rate, n_quadratics>
    rates_of(const SplitBody<2>       &body,
             const SimplexVelocity<2> &velocity,
             const unsigned int        t)
    {
      const auto corners = body.corners_of(t);
      std::array<SymmetricTensor<2, 2>, n_quadratics> at_points;
      for (unsigned int p = 0; p < n_quadratics; ++p)
        at_points[p] =
          polynomial_rate<2>(corners, velocity, Bernstein<2>::points(2)[p]);
      std::array<Rate, n_quadratics> rates;
      for (unsigned int i = 0; i < n_quadratics; ++i)
        {
          SymmetricTensor<2, 2> e;
          for (unsigned int p = 0; p < n_quadratics; ++p)
            e += Bernstein<2>::coefficients(2)(i, p) * at_points[p];
          rates[i] = {trace(e), std::hypot(e[0][0] - e[1][1], 2. * e[0][1])};
        }
      return rates;
    }
  } // namespace



  StressErrors
  check_stress_of_soil(const SplitBody<2>   &body,
                       const FrictionSines  &sines,
                       const StressField<2> &field)
  {
    StressErrors errors = check_stress(body, field);
    errors.yield_excess = 0.;
    const auto &points  = Bernstein<2>::points(field.degree);
    for (unsigned int t = 0; t < sines.size(); ++t)
      for (unsigned int k = 0; k < JohnsonMercier<2>::n_parts; ++k)
        {
          const auto part = JohnsonMercier<2>::part_of(body.corners_of(t), k);
          for (unsigned int i = 0; i < points.size(); ++i)
            {
              const auto   s = field.coefficient(t, k, i);
              const double pressure =
                body.pressure_of_body_force(interpolate(points[i], part),
                                            field.load_factor) -
                0.5 * (s[0][0] + s[1][1]);
              const double shear =
                std::hypot(0.5 * (s[0][0] - s[1][1]), s[0][1]);
              enlarge(errors.yield_excess,
                      (shear - sines[t] * pressure -
                       std::sqrt(0.5) * body.materials[t].yield_radius) /
                        body.stress_unit);
            }
        }
    return errors;
  }



  VelocityErrors
  check_velocity_of_soil(const SplitBody<2>                    &body,
                         const FrictionSines                   &sines,
                         const std::vector<SimplexVelocity<2>> &velocity)
  {
    SplitBody<2> without_slip = body;
    without_slip.kinematics   = Kinematics::plane_stress;
    VelocityErrors errors     = check_velocity(without_slip, velocity);
    for (unsigned int t = 0; t < velocity.size(); ++t)
      {
        const double size = std::sqrt(volume(body.corners_of(t)));
        for (const Rate &rate : rates_of(body, velocity[t], t))
          enlarge(errors.divergence,
                  size * (sines[t] > 0. ? sines[t] * rate.shear - rate.volume :
                                          std::abs(rate.volume)));
      }
    return errors;
  }



  // A rate that misses the cone by rounding errors counts as on it.
  std::vector<double>
  plastic_work_of_soil(const SplitBody<2>                    &body,
                       const FrictionSines                   &sines,
                       const std::vector<SimplexVelocity<2>> &velocity)
  {
    std::vector<double> work;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      {
        double sum = 0;
        for (const Rate &rate : rates_of(body, velocity[t], t))
          sum += sines[t] > 0. ? std::max(rate.shear, rate.volume / sines[t]) :
                                 rate.shear;
        work.push_back(std::sqrt(0.5) * body.materials[t].yield_radius *
                       volume(body.corners_of(t)) / n_quadratics * sum);
      }
    return work;
  }



  VelocityField<2>
  minimize_plastic_work_of_soil(const SplitBody<2>  &body,
                                const FrictionSines &sines,
                                const double         tolerance)
  {
    VelocityField<2> field = find_motion_of_soil(body, sines, tolerance);
    scale(field, 1. / lowest_depth(body, field.velocity));
    field.dissipation = plastic_work_of_soil(body, sines, field.velocity);
    field.error = check_velocity_of_soil(body, sines, field.velocity).largest();
    field.bound =
      std::accumulate(field.dissipation.begin(),
                      field.dissipation.end(),
                      -power_of_loads(body, field.velocity).constant);
    return field;
  }
} // namespace ElastoPlastic
