// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bounds/body/hencky_material.h"
#include "bounds/error/error_bound.h"
#include "bounds/error/face_gap.h"
#include "bounds/error/support_check.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    FaceGap
    gap_of(const SpaceBody &body, const unsigned int f)
    {
      return {body.gap, body.mesh.corners(body.mesh.faces[f])};
    }



    template <typename Value, std::size_t n>
    Value
    interpolate(const std::array<double, n> &position,
                const std::array<Value, n>  &values)
    {
      Value result = position[0] * values[0];
      for (unsigned int i = 1; i < n; ++i)
        result += position[i] * values[i];
      return result;
    }



    /// int W + W* - tau : eps dx on a part of a tetrahedron, relative to its
    /// volume, from strain and stress at its corners. Plastic strain and zeta
    /// are linear between these; R |e_p| is convex, so that the mean of its
    /// values at the corners bounds it from above.
    double
    bound_on_part(const Material<double>                     &material,
                  const std::array<SymmetricTensor<2, 3>, 4> &strain,
                  const std::array<SymmetricTensor<2, 3>, 4> &stress)
    {
      static const QGaussSimplex<3>        quadrature(2);
      std::array<SymmetricTensor<2, 3>, 4> plastic_strain;
      std::array<double, 4>                zeta   = {};
      double                               result = 0;
      if (HenckyMaterial::yields(material))
        for (unsigned int i = 0; i < 4; ++i)
          {
            plastic_strain[i] =
              HenckyMaterial::split_strain(material, strain[i]).plastic;
            zeta[i] =
              std::max(0., deviator(stress[i]).norm() - material.yield_radius);
            result += 0.25 * material.yield_radius * plastic_strain[i].norm();
          }
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Point<3>             &x        = quadrature.point(q);
          const std::array<double, 4> position = {
            {1. - x[0] - x[1] - x[2], x[0], x[1], x[2]}};
          // (the weights add up to 1/6)
          result +=
            6. * quadrature.weight(q) *
            HenckyMaterial::quadratic_gap(material,
                                          interpolate(position, strain),
                                          interpolate(position, plastic_strain),
                                          interpolate(position, stress),
                                          interpolate(position, zeta));
        }
      return result;
    }



    double
    bound_on_tetrahedron(const SpaceBody           &body,
                         const SpaceQuadraticField &displacement,
                         const SpaceStressField    &stress,
                         const unsigned int         t)
    {
      const auto   strain = strains(body.mesh, displacement, t);
      const double part =
        0.25 * volume(body.mesh.corners(body.mesh.tetrahedra[t]));
      double result = 0;
      for (unsigned int k = 0; k < TetrahedronStress::n_parts; ++k)
        {
          auto of_part = strain;
          of_part[k]   = 0.25 * (strain[0] + strain[1] + strain[2] + strain[3]);
          std::array<SymmetricTensor<2, 3>, 4> tau;
          for (unsigned int i = 0; i < 4; ++i)
            tau[i] = stress.at(t, k, i);
          result += part * bound_on_part(body.materials[t], of_part, tau);
        }
      return result;
    }



    /// int p (g - V - v_3) ds with the upper bound of g; p is linear. All is at
    /// most cubic on the small triangles.
    double
    bound_on_face(const SpaceBody             &body,
                  const SpaceQuadraticField   &displacement,
                  const double                 depth,
                  const std::array<double, 3> &pressure,
                  const unsigned int           f)
    {
      static const QWitherdenVincentSimplex<2> quadrature(2);
      const FaceValues v   = values_on_face(body.mesh, displacement, f);
      double           sum = 0;
      for (const auto &triangle : gap_of(body, f).small_triangles())
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const Point<2>             &x      = quadrature.point(q);
            const std::array<double, 3> inside = {
              {1. - x[0] - x[1], x[0], x[1]}};
            const auto position = triangle.position(inside);
            // (the weights add up to 1/2)
            sum += 2. * quadrature.weight(q) * interpolate(position, pressure) *
                   (interpolate(inside, triangle.upper) - depth -
                    v.value(position)[2]);
          }
      return area(body.mesh.corners(body.mesh.faces[f])) * sum /
             (FaceGap::n_intervals * FaceGap::n_intervals);
    }



    /// By how much the middles of the edges of a face must go down until no
    /// point of it penetrates; the corners do not. In terms of the barycentric
    /// coordinates l_i of the face, the displacement is linear plus the sum of
    /// 4 l_i l_j b over its edges. On a small triangle this sum, less the
    /// distance that is left, less t times that with b = 1, is a quadratic
    /// function; it is not positive if its coefficients in Bernstein's basis,
    /// the values at the corners and 2 f(middle) less the mean of f at its ends
    /// for each edge, are not.
    double
    necessary_lowering(const FaceGap    &gap,
                       const FaceValues &v,
                       const double      depth)
    {
      std::array<double, 3> vertical, bubbles;
      for (unsigned int i = 0; i < 3; ++i)
        {
          vertical[i] = v.at_corners[i][2];
          bubbles[i]  = v.at_edges[i][2] - 0.5 * (v.at_corners[i][2] +
                                                 v.at_corners[(i + 1) % 3][2]);
        }
      const auto bubble = [](const std::array<double, 3> &l,
                             const std::array<double, 3> &b) {
        return 4. *
               (l[0] * l[1] * b[0] + l[1] * l[2] * b[1] + l[2] * l[0] * b[2]);
      };
      double result = 0;
      for (const auto &triangle : gap.small_triangles())
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            {
              const auto &a = triangle.corners[i], &b = triangle.corners[j];
              const auto  bernstein = [&](const std::array<double, 3> &size) {
                std::array<double, 3> middle;
                for (unsigned int k = 0; k < 3; ++k)
                  middle[k] = 0.5 * (a[k] + b[k]);
                return 2. * bubble(middle, size) -
                       0.5 * (bubble(a, size) + bubble(b, size));
              };
              const double left =
                0.5 * (triangle.lower[i] + triangle.lower[j]) - depth -
                0.5 * (interpolate(a, vertical) + interpolate(b, vertical));
              const double unit = bernstein({{1., 1., 1.}});
              if (unit > 0.) // else it is a corner of the face
                result = std::max(result, (bernstein(bubbles) - left) / unit);
            }
      return result;
    }
  } // namespace



  // First the corners of the faces, then the middles of their edges, where the
  // quadratic functions of the middles are zero at the corners.
  void
  remove_penetration(SpaceQuadraticField &displacement,
                     const SpaceBody     &body,
                     const double         depth)
  {
    std::vector<std::pair<unsigned int, FaceGap>> gaps;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_reached)
        gaps.emplace_back(f, gap_of(body, f));

    for (const auto &[f, gap] : gaps)
      for (unsigned int i = 0; i < 3; ++i)
        {
          double &v =
            displacement.at_vertices[body.mesh.faces[f].vertices[i]][2];
          v = std::min(v, gap.lower_at_corner(i) - depth);
        }

    std::vector<double> lowering(body.mesh.n_edges);
    for (const auto &[f, gap] : gaps)
      {
        const FaceValues v         = values_on_face(body.mesh, displacement, f);
        const double     necessary = necessary_lowering(gap, v, depth);
        for (const unsigned int edge : v.edges)
          lowering[edge] = std::max(lowering[edge], necessary);
      }
    for (unsigned int edge = 0; edge < lowering.size(); ++edge)
      displacement.at_edges[edge][2] -= lowering[edge];
  }



  ErrorBound
  bound_error(const SpaceBody           &body,
              const SpaceQuadraticField &displacement,
              const double               depth,
              const SpaceStressField    &stress)
  {
    require_supported(body, displacement);
    ErrorBound bound;
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      bound.of_simplices.push_back(
        bound_on_tetrahedron(body, displacement, stress, t));

    bound.of_faces.resize(body.mesh.faces.size());
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].components[2].type == SideConditionType::contact)
        bound.of_faces[f] =
          bound_on_face(body, displacement, depth, stress.pressure[f], f);
    return bound;
  }
} // namespace ElastoPlastic
