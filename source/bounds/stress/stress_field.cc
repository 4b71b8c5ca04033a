// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/tensors.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  SymmetricTensor<2, 3>
  StressField::coefficient(const unsigned int triangle,
                           const unsigned int subtriangle,
                           const unsigned int i) const
  {
    return in_space<2>(
      JohnsonMercier::coefficient(in_plane[triangle], subtriangle, i),
      out_of_plane[triangle][Bernstein::n_functions(degree) * subtriangle + i]);
  }



  SymmetricTensor<2, 3>
  StressField::at(const unsigned int            triangle,
                  const unsigned int            subtriangle,
                  const Bernstein::Barycentric &point) const
  {
    const auto            functions = Bernstein::functions(degree, point);
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < functions.size(); ++i)
      stress += functions[i] * coefficient(triangle, subtriangle, i);
    return stress;
  }



  // On the axis, it is the quotient of the derivatives of weighted stress and
  // weight, to which the coefficients beside those of the corner contribute.
  SymmetricTensor<2, 3>
  StressField::without_weight(const PlaneBody   &body,
                              const unsigned int triangle,
                              const unsigned int subtriangle,
                              const unsigned int corner) const
  {
    const auto corners = JohnsonMercier::subtriangle_of(
      body.mesh.corners(body.mesh.triangles[triangle]), subtriangle);
    const auto pressure =
      body.pressure_of_body_force(corners[corner], load_factor) *
      unit_symmetric_tensor<3>();
    if (!body.is_on_axis(corners[corner]))
      return coefficient(triangle, subtriangle, corner) /
               body.weight(corners[corner]) -
             pressure;
    SymmetricTensor<2, 3> derivative;
    double                of_weight = 0;
    for (const unsigned int other : {(corner + 1) % 3, (corner + 2) % 3})
      {
        derivative +=
          1. * degree *
          coefficient(triangle,
                      subtriangle,
                      JohnsonMercier::number_on_line(degree, corner, other, 1));
        of_weight += body.weight(corners[other]);
      }
    return derivative / of_weight - pressure;
  }



  double
  StressField::max_pressure() const
  {
    double largest = 0;
    for (const auto &of_side : pressure)
      for (const double coefficient : of_side)
        largest = std::max(largest, coefficient);
    return largest;
  }



  // An interior point leaves a little pressure everywhere. From the end that is
  // pressed to one that is not, the pressure falls to zero; so the part of such
  // a side counts whose coefficients do not vanish.
  double
  StressField::contact_area(const PlaneBody &body) const
  {
    const double threshold = 1e-4 * max_pressure();
    double       area      = 0;
    for (unsigned int s = 0; s < pressure.size(); ++s)
      for (unsigned int i = 0; i <= degree; ++i)
        if (pressure[s][i] > threshold)
          {
            const SplitMesh::Side &side = body.mesh.sides[s];
            const Point<2>         a    = body.mesh.vertices[side.vertices[0]],
                           b            = body.mesh.vertices[side.vertices[1]];
            const double   part         = 1. / (degree + 1.);
            const Point<2> middle       = a + part * (i + 0.5) * (b - a);
            area += body.angle() * body.weight(middle) * part *
                    body.mesh.length(side);
          }
    return area;
  }
} // namespace ElastoPlastic
