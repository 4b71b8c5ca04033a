// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "bounds/mesh/integration.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The points of a quadrature of the unit simplex.
    template <int dim>
    std::vector<WeightedPoint<dim>>
    weighted_points(const Quadrature<dim> &quadrature)
    {
      double factorial = 1.;
      for (unsigned int d = 2; d <= dim; ++d)
        factorial *= d;
      std::vector<WeightedPoint<dim>> result;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          WeightedPoint<dim> point = {{}, factorial * quadrature.weight(q)};
          point.position[0]        = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              point.position[d + 1] = quadrature.point(q)[d];
              point.position[0] -= quadrature.point(q)[d];
            }
          result.push_back(point);
        }
      return result;
    }


    template <int dim>
    Quadrature<dim>
    gauss_quadrature()
    {
      if constexpr (dim == 1)
        return QGauss<1>(2);
      else
        return QGaussSimplex<dim>(dim == 2 ? 3 : 2);
    }
  } // namespace



  template <int dim>
  const std::vector<WeightedPoint<dim>> &
  simplex_quadrature()
  {
    static const auto points = weighted_points<dim>(gauss_quadrature<dim>());
    return points;
  }



  template <int dim>
  const std::vector<WeightedPoint<dim - 1>> &
  face_quadrature()
  {
    static const auto points = []() {
      if constexpr (dim == 2)
        return weighted_points<1>(QGauss<1>(5));
      else
        return weighted_points<2>(QWitherdenVincentSimplex<2>(4));
    }();
    return points;
  }



  template <int dim>
  const std::vector<WeightedPoint<dim - 1>> &
  points_over_face()
  {
    if constexpr (dim == 2)
      {
        static const auto points = weighted_points<1>(QGauss<1>(16));
        return points;
      }
    else
      return face_quadrature<dim>();
  }



  // Lines from the corner nearest to the axis to the opposite side: with a
  // position s on the line and t of its end on the side, dx = 2 |K| s ds dt.
  // On a line, s f / r is a polynomial and, from the root of r on the other
  // side of the corner, a multiple of 1 / r that is not positive: Gauss'
  // formula makes that too large. For each s, f / r as a function of t is a
  // polynomial and a multiple of 1 / r that is not negative: Lobatto's formula
  // does.
  std::vector<WeightedPoint<2>>
  quadrature_over(const std::array<double, 3> &r)
  {
    static const QGauss<1>        along_lines(4);
    static const QGaussLobatto<1> across(4);

    const unsigned int tip = std::min_element(r.begin(), r.end()) - r.begin();
    std::vector<WeightedPoint<2>> points;
    for (unsigned int i = 0; i < along_lines.size(); ++i)
      for (unsigned int j = 0; j < across.size(); ++j)
        {
          const double     s = along_lines.point(i)[0], t = across.point(j)[0];
          WeightedPoint<2> point;
          point.position[tip]           = 1. - s;
          point.position[(tip + 1) % 3] = s * (1. - t);
          point.position[(tip + 2) % 3] = s * t;
          const double r_here           = interpolate(point.position, r);
          if (r_here == 0.)
            continue;
          point.weight =
            2. * s * along_lines.weight(i) * across.weight(j) / r_here;
          points.push_back(point);
        }
    return points;
  }



  template const std::vector<WeightedPoint<1>> &
  simplex_quadrature();
  template const std::vector<WeightedPoint<2>> &
  simplex_quadrature();
  template const std::vector<WeightedPoint<3>> &
  simplex_quadrature();
  template const std::vector<WeightedPoint<1>> &
  face_quadrature<2>();
  template const std::vector<WeightedPoint<2>> &
  face_quadrature<3>();
  template const std::vector<WeightedPoint<1>> &
  points_over_face<2>();
  template const std::vector<WeightedPoint<2>> &
  points_over_face<3>();
} // namespace ElastoPlastic
