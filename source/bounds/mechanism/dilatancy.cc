// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/largest_error.h"
#include "base/tensors.h"
#include "bounds/mechanism/velocity_check.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the strain rate as a polynomial; in a body of revolution, where that
    /// of v_r is r times another one.
    template <int dim>
    constexpr unsigned int rate_degree = velocity_degree<dim> - 1;



    /// The strain rates of a simplex.
    template <int dim>
    class SoilMotion
    {
    public:
      SoilMotion(const SplitBody<dim>       &body,
                 const SimplexVelocity<dim> &velocity,
                 const unsigned int          t)
        : body(body)
        , velocity(velocity)
        , t(t)
        , corners(body.corners_of(t))
        , slope(body.friction_slopes[t])
        , rates(Bernstein<dim>::interpolate(rate_degree<dim>,
                                            [this](const auto &point) {
                                              return rate_at(point);
                                            }))
      {}

      double
      missing_dilatation() const
      {
        double missing = 0.;
        for (const auto &rate : rates)
          keep_largest(missing,
                       slope > 0. ? slope * rate_of_shear(rate) - trace(rate) :
                                    std::abs(trace(rate)));
        missing *= std::pow(volume(corners), 1. / dim);
        if (body.is_axisymmetric())
          keep_largest(missing, departure_from_quadratic());
        return missing;
      }

      double
      plastic_work() const
      {
        const auto weights =
          Bernstein<dim>::moments(rate_degree<dim>, body.weights(corners));
        double sum = 0.;
        for (unsigned int i = 0; i < rates.size(); ++i)
          {
            const double shear = rate_of_shear(rates[i]);
            sum +=
              weights[i] *
              (slope > 0. ? std::max(shear, trace(rates[i]) / slope) : shear);
          }
        return body.angle() * std::sqrt(0.5) * body.materials[t].yield_radius *
               volume(corners) * sum;
      }

    private:
      /// The change of the velocity at a point for each unit of the way from
      /// the first corner to corner @p k, by differences of points, some
      /// outside of the simplex: exact for polynomials of degree 4.
      Tensor<1, dim>
      change_towards(const Barycentric<dim> &point, const unsigned int k) const
      {
        constexpr double step = 0.25;
        const auto       at   = [&](const double way) {
          Barycentric<dim> beside = point;
          beside[0] -= way;
          beside[k] += way;
          return velocity_at(body, velocity, t, beside);
        };
        return (8. * (at(step) - at(-step)) -
                (at(2. * step) - at(-2. * step))) /
               (12. * step);
      }

      /// The strain rate at a point.
      SymmetricTensor<2, 3>
      rate_at(const Barycentric<dim> &point) const
      {
        Tensor<2, dim> ways, changes;
        for (unsigned int k = 0; k < dim; ++k)
          {
            ways[k]    = corners[k + 1] - corners[0];
            changes[k] = change_towards(point, k + 1);
          }
        const auto   rate = symmetrize(invert(ways) * changes);
        const auto   x    = interpolate(point, corners);
        const double across =
          !body.is_axisymmetric() ? 0. :
          body.is_on_axis(x)      ? rate[0][0] :
                               velocity_at(body, velocity, t, point)[0] / x[0];
        return in_space<dim>(rate, across);
      }

      double
      rate_of_shear(const SymmetricTensor<2, 3> &rate) const
      {
        return dim == 3 || body.is_axisymmetric() ?
                 std::sqrt(2.) * deviator(rate).norm() :
                 std::hypot(rate[0][0] - rate[1][1], 2. * rate[0][1]);
      }

      /// By how much v_r is not r times the polynomial e_tt with the
      /// coefficients: all rates are quadratic only if it is. As a rate off the
      /// axis, times the size of the triangle.
      double
      departure_from_quadratic() const
      {
        double largest = 0.;
        for (const auto &point : Bernstein<dim>::points(velocity_degree<dim>))
          {
            const double rate = Bernstein<dim>::value(rate_degree<dim>,
                                                      rates.begin(),
                                                      point)[2][2];
            const double v_r  = velocity_at(body, velocity, t, point)[0];
            const auto   x    = interpolate(point, corners);
            keep_largest(largest,
                         body.is_on_axis(x) ? std::abs(v_r) :
                                              std::sqrt(volume(corners)) *
                                                std::abs(v_r / x[0] - rate));
          }
        return largest;
      }

      const SplitBody<dim>                    &body;
      const SimplexVelocity<dim>              &velocity;
      const unsigned int                       t;
      const Corners<dim>                       corners;
      const double                             slope; ///< f
      const std::vector<SymmetricTensor<2, 3>> rates; ///< coefficients
    };
  } // namespace



  template <int dim>
  double
  missing_dilatation(const SplitBody<dim>       &body,
                     const SimplexVelocity<dim> &velocity,
                     const unsigned int          t)
  {
    return SoilMotion<dim>(body, velocity, t).missing_dilatation();
  }



  template <int dim>
  double
  work_of_soil(const SplitBody<dim>       &body,
               const SimplexVelocity<dim> &velocity,
               const unsigned int          t)
  {
    return SoilMotion<dim>(body, velocity, t).plastic_work();
  }



  template double
  missing_dilatation(const SplitBody<2> &,
                     const SimplexVelocity<2> &,
                     const unsigned int);
  template double
  missing_dilatation(const SplitBody<3> &,
                     const SimplexVelocity<3> &,
                     const unsigned int);
  template double
  work_of_soil(const SplitBody<2> &,
               const SimplexVelocity<2> &,
               const unsigned int);
  template double
  work_of_soil(const SplitBody<3> &,
               const SimplexVelocity<3> &,
               const unsigned int);
} // namespace ElastoPlastic
