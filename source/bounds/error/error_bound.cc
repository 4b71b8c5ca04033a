// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/tensors.h"
#include "bounds/body/hencky_material.h"
#include "bounds/error/error_bound.h"
#include "bounds/error/side_gap.h"
#include "bounds/error/support_check.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    sum(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.);
    }



    /// A component of the displacement of a side, at its ends and in its
    /// middle.
    struct OnSide
    {
      double a, b, middle;

      double
      linear(const double t) const
      {
        return (1. - t) * a + t * b;
      }

      double
      bubble() const
      {
        return middle - 0.5 * (a + b);
      }

      double
      operator()(const double t) const
      {
        return linear(t) + 4. * t * (1. - t) * bubble();
      }
    };



    OnSide
    vertical(const QuadraticField  &displacement,
             const SplitMesh::Side &side,
             const unsigned int     s)
    {
      return {displacement.at_vertices[side.vertices[0]][1],
              displacement.at_vertices[side.vertices[1]][1],
              displacement.at_sides[s][1]};
    }



    SideGap
    gap_of(const PlaneBody &body, const SplitMesh::Side &side)
    {
      return {body.gap,
              body.mesh.vertices[side.vertices[0]],
              body.mesh.vertices[side.vertices[1]]};
    }



    /// The largest factor c for which the indenter, moved down by @p depth, is
    /// not penetrated by linear(t) + 4 t (1 - t) c; the ends do not penetrate.
    /// In an interval of SideGap, what is left above the linear part is linear.
    /// If at both ends that is r times 4 t (1 - t), it is not less than r times
    /// the chord of this function, which is above (1 - 2 / n_intervals) times
    /// the function itself, and below the function.
    double
    largest_bubble(const SideGap &gap, const OnSide &v, const double depth)
    {
      double ratio = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i <= SideGap::n_intervals; ++i)
        if (const double t = gap.position(i); t > 0. && t < 1.)
          ratio = std::min(ratio,
                           (gap.values[i] - gap.below - depth - v.linear(t)) /
                             (4. * t * (1. - t)));
      return ratio * (ratio > 0. ? 1. - 2. / SideGap::n_intervals : 1.);
    }



    /// A triangle's subtriangle. Fields are weighted, see LocalStresses:
    /// stress, plastic strain and growth of the yield surface are linear then.
    class Subtriangle
    {
    public:
      Subtriangle(const PlaneBody      &body,
                  const QuadraticField &displacement,
                  const StressField    &stress,
                  const unsigned int    t,
                  const unsigned int    k)
        : body(body)
        , material(body.materials[t])
        , displacement(displacement)
        , triangle(body.mesh.triangles[t])
        , k(k)
        , strain(
            JohnsonMercier::on_subtriangle(strains(body.mesh, displacement, t),
                                           k))
        , stress({{stress.coefficient(t, k, 0),
                   stress.coefficient(t, k, 1),
                   stress.coefficient(t, k, 2)}})
      {
        const auto corners =
          JohnsonMercier::subtriangle_of(body.mesh.corners(triangle), k);
        for (unsigned int i = 0; i < 3; ++i)
          {
            r[i] = body.is_on_axis(corners[i]) ? 0. : body.weight(corners[i]);
            split(i);
          }
      }

      // R |e_p| is convex: the mean of its values at the corners bounds it from
      // above.
      double
      bound() const
      {
        double result = 0;
        if (HenckyMaterial::yields(material))
          for (const auto &plastic : plastic_strain)
            result += material.yield_radius * plastic.norm() / 3.;
        for (const WeightedPoint &point : quadrature_over(r))
          result +=
            point.weight *
            HenckyMaterial::quadratic_gap(material,
                                          strain_at(point),
                                          point.interpolate(plastic_strain),
                                          point.interpolate(stress),
                                          point.interpolate(zeta));
        return result;
      }

    private:
      /// Sets what follows from strain and stress at a corner. Next to the
      /// axis, where the strain may depend on the direction, plastic strains go
      /// to zero when weighted.
      void
      split(const unsigned int i)
      {
        if (HenckyMaterial::yields(material))
          zeta[i] =
            std::max(0.,
                     deviator(stress[i]).norm() - r[i] * material.yield_radius);
        if (!body.is_axisymmetric())
          {
            const auto [elastic, plastic] =
              HenckyMaterial::split_strain(material,
                                           strain[i],
                                           body.kinematics);
            plastic_strain[i] = plastic;
            out_of_plane[i]   = elastic[2][2] + plastic[2][2];
          }
        else if (r[i] > 0)
          {
            std::array<double, 3> corner = {};
            corner[i]                    = 1.;
            const auto [elastic, plastic] =
              HenckyMaterial::split_strain(material,
                                           strain_at({corner, 0.}) / r[i]);
            plastic_strain[i] = r[i] * plastic;
          }
      }

      /// The weighted strain, whose circumferential component is the radial
      /// displacement.
      SymmetricTensor<2, 3>
      strain_at(const WeightedPoint &point) const
      {
        const double weight = point.interpolate(r);
        return in_space<2>(weight * point.interpolate(strain),
                           body.is_axisymmetric() ?
                             radial_displacement(point) :
                             weight * point.interpolate(out_of_plane));
      }

      double
      radial_displacement(const WeightedPoint &point) const
      {
        std::array<double, 3> position;
        position.fill(point.position[2] / 3.);
        position[k] += point.position[0];
        position[(k + 1) % 3] += point.position[1];
        return value(displacement, triangle, position)[0];
      }

      const PlaneBody                           &body;
      const Material<double>                    &material;
      const QuadraticField                      &displacement;
      const SplitMesh::Triangle                 &triangle;
      const unsigned int                         k;
      const std::array<SymmetricTensor<2, 2>, 3> strain; ///< not weighted
      const std::array<SymmetricTensor<2, 3>, 3> stress;
      std::array<double, 3>                      r            = {};
      std::array<double, 3>                      out_of_plane = {};
      std::array<double, 3>                      zeta         = {};
      std::array<SymmetricTensor<2, 3>, 3>       plastic_strain;
    };



    double
    bound_on_triangle(const PlaneBody      &body,
                      const QuadraticField &displacement,
                      const StressField    &stress,
                      const unsigned int    t)
    {
      double result = 0;
      for (unsigned int k = 0; k < 3; ++k)
        result += Subtriangle(body, displacement, stress, t, k).bound();
      return body.angle() * area(body.mesh.corners(body.mesh.triangles[t])) /
             3. * result;
    }



    /// int p (g - V - v_2) ds, the weighted p being linear. With the upper
    /// bound of g, this is a cubic function on each interval, which Simpson's
    /// rule integrates.
    double
    bound_on_side(const PlaneBody           &body,
                  const QuadraticField      &displacement,
                  const double               depth,
                  const std::vector<double> &pressure,
                  const unsigned int         s)
    {
      const SplitMesh::Side &side = body.mesh.sides[s];
      const SideGap          gap  = gap_of(body, side);
      const OnSide           v    = vertical(displacement, side, s);
      const auto             end  = [&](const unsigned int e) {
        return body.weight(body.mesh.vertices[side.vertices[e]]) * pressure[e];
      };
      const auto density = [&](const double t, const double gap_at_t) {
        return ((1. - t) * end(0) + t * end(1)) *
               (gap_at_t + gap.above - depth - v(t));
      };
      double sum = 0;
      for (unsigned int i = 0; i + 1 < gap.values.size(); ++i)
        {
          const double t0 = gap.position(i), t1 = gap.position(i + 1),
                       g0 = gap.values[i], g1 = gap.values[i + 1];
          sum +=
            (t1 - t0) / 6. *
            (density(t0, g0) + 4. * density(0.5 * (t0 + t1), 0.5 * (g0 + g1)) +
             density(t1, g1));
        }
      return body.angle() * body.mesh.length(side) * sum;
    }
  } // namespace



  double
  ErrorBound::of_body() const
  {
    return sum(of_simplices);
  }



  double
  ErrorBound::of_contact() const
  {
    return sum(of_faces);
  }



  double
  ErrorBound::total() const
  {
    return of_body() + of_contact();
  }



  std::vector<double>
  ErrorBound::indicators(const SplitMesh &mesh) const
  {
    std::vector<double> result = of_simplices;
    for (unsigned int t = 0; t < result.size(); ++t)
      for (const unsigned int side : mesh.triangles[t].sides)
        result[t] += of_faces[side];
    return result;
  }



  std::vector<double>
  ErrorBound::indicators(const TetrahedralMesh &mesh) const
  {
    std::vector<double> result = of_simplices;
    for (unsigned int t = 0; t < result.size(); ++t)
      for (const unsigned int face : mesh.tetrahedra[t].faces)
        result[t] += of_faces[face];
    return result;
  }



  // First the ends of the sides, if the indenter reaches them but for rounding,
  // then their middles: the quadratic function of the middle, 4 t (1 - t), is
  // zero at the ends.
  void
  remove_penetration(QuadraticField  &displacement,
                     const PlaneBody &body,
                     const double     depth)
  {
    std::vector<std::pair<unsigned int, SideGap>> gaps;
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      if (body.conditions[s].is_reached)
        if (SideGap gap = gap_of(body, body.mesh.sides[s]); !gap.values.empty())
          gaps.emplace_back(s, std::move(gap));

    for (const auto &[s, gap] : gaps)
      {
        const auto &ends  = body.mesh.sides[s].vertices;
        const auto  lower = [&](const unsigned int vertex, const double value) {
          double &v = displacement.at_vertices[vertex][1];
          v         = std::min(v, value - gap.below - depth);
        };
        if (gap.begin < 1. / SideGap::n_intervals)
          lower(ends[0], gap.values.front());
        if (gap.end > 1. - 1. / SideGap::n_intervals)
          lower(ends[1], gap.values.back());
      }
    for (const auto &[s, gap] : gaps)
      {
        const OnSide v = vertical(displacement, body.mesh.sides[s], s);
        displacement.at_sides[s][1] -=
          std::max(0., v.bubble() - largest_bubble(gap, v, depth));
      }
  }



  ErrorBound
  bound_error(const PlaneBody      &body,
              const QuadraticField &displacement,
              const double          depth,
              const StressField    &stress)
  {
    AssertDimension(stress.degree, 1);
    require_supported(body, displacement);
    ErrorBound bound;
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      bound.of_simplices.push_back(
        bound_on_triangle(body, displacement, stress, t));

    bound.of_faces.resize(body.mesh.sides.size());
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      if (body.conditions[s].components[1].type == SideConditionType::contact)
        bound.of_faces[s] =
          bound_on_side(body, displacement, depth, stress.pressure[s], s);
    return bound;
  }
} // namespace ElastoPlastic
