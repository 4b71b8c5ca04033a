// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_interpolated_stress_h
#define tests_interpolated_stress_h

#include <deal.II/base/quadrature_lib.h>

#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "element_tractions.h"

/// The interpolation pi_h of J (4.5) in @cite johnson_1978: the values of the
/// Johnson-Mercier stress of the first degree with the same mean values as a
/// @p stress, J (4.4), and on each side the tractions that have the same
/// resultant and moment, J (4.3). Polynomials of degree 5 or less are
/// integrated exactly.
template <typename Stress>
dealii::Vector<double>
interpolate(const ElastoPlastic::Corners<2> &triangle, const Stress &stress)
{
  using namespace dealii;
  using namespace ElastoPlastic;
  using Element = JohnsonMercier<2>;

  Vector<double> freedoms(15);
  for (unsigned int side = 0; side < 3; ++side)
    {
      const Point<2>     a = triangle[side], b = triangle[(side + 1) % 3];
      const Tensor<1, 2> normal = cross_product_2d(b - a) / (b - a).norm();
      integrate_on_face<2>(
        {{a, b}}, [&](const FacePoint<2> &point, const double weight) {
          const double       t        = point.position[1];
          const Tensor<1, 2> traction = weight * (stress(point.x) * normal);
          for (unsigned int c = 0; c < 2; ++c)
            {
              freedoms[ElementTractions<2>::index(1, side, 0, c)] +=
                (4. - 6. * t) * traction[c];
              freedoms[ElementTractions<2>::index(1, side, 1, c)] +=
                (6. * t - 2.) * traction[c];
            }
        });
    }
  const QGaussSimplex<2> inside(3);
  for (unsigned int q = 0; q < inside.size(); ++q)
    {
      const auto &x = inside.point(q);
      const auto  value =
        stress(Point<2>(triangle[0] + x[0] * (triangle[1] - triangle[0]) +
                        x[1] * (triangle[2] - triangle[0])));
      const double weight = 2. * inside.weight(q);
      freedoms[12] += weight * value[0][0];
      freedoms[13] += weight * value[1][1];
      freedoms[14] += weight * value[0][1];
    }

  FullMatrix<double> functionals(15, Element::n_values(1));
  functionals.fill(ElementTractions<2>::matrix(triangle, 1));
  for (unsigned int i = 0; i < Element::n_values(1); ++i)
    functionals(12 + i % 3, i) = 1. / Element::n_points(1);
  const FullMatrix<double> shapes = Element::basis(triangle, 1);
  FullMatrix<double>       of_shapes(15, 15);
  functionals.mmult(of_shapes, shapes);
  of_shapes.gauss_jordan();
  Vector<double> coefficients(15), values(Element::n_values(1));
  of_shapes.vmult(coefficients, freedoms);
  shapes.vmult(values, coefficients);
  return values;
}

#endif
