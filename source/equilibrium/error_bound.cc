// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "equilibrium/error_bound.h"
#include "equilibrium/hencky_material.h"
#include "equilibrium/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Whether a side penetrates is looked at in so many points.
    constexpr unsigned int n_samples = 32;



    double
    sum(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.);
    }



    /// The sides that the indenter reaches, with their ends.
    template <typename Action>
    void
    for_each_reached_side(const PlaneBody &body, const Action &action)
    {
      for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
        if (body.conditions[s].is_reached)
          action(s, body.mesh.sides[s].vertices);
    }



    /// A point of a side, 0 <= t <= 1.
    Point<2>
    point_on(const SplitMesh                   &mesh,
             const std::array<unsigned int, 2> &ends,
             const double                       t)
    {
      const Point<2> &a = mesh.vertices[ends[0]], &b = mesh.vertices[ends[1]];
      return a + t * (b - a);
    }



    /// What is left between the indenter and a point of a side.
    double
    clearance(const PlaneBody      &body,
              const QuadraticField &displacement,
              const double          depth,
              const unsigned int    s,
              const double          t)
    {
      const auto  &ends = body.mesh.sides[s].vertices;
      const double v =
        (1. - t) * (1. - 2. * t) * displacement.at_vertices[ends[0]][1] +
        t * (2. * t - 1.) * displacement.at_vertices[ends[1]][1] +
        4. * t * (1. - t) * displacement.at_sides[s][1];
      return body.gap(point_on(body.mesh, ends, t)) - depth - v;
    }



    /// The integral of the product of two linear functions on a triangle of
    /// the size 1, given by their values at the corners.
    template <typename Product>
    double
    integrate(const Product &product)
    {
      double result = 0;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result += (i == j ? 1. / 6. : 1. / 12.) * product(i, j);
      return result;
    }



    /// A triangle's third, on which strain and stress are linear.
    class Third
    {
    public:
      Third(const PlaneBody                            &body,
            const unsigned int                          t,
            const std::array<SymmetricTensor<2, 2>, 3> &strain,
            const std::array<SymmetricTensor<2, 3>, 3> &stress)
        : material(body.materials[t])
        , stress(stress)
      {
        for (unsigned int i = 0; i < 3; ++i)
          {
            const auto [elastic, plastic] =
              HenckyMaterial::split_strain(material,
                                           strain[i],
                                           body.plane_stress);
            elastic_difference[i] =
              elastic - HenckyMaterial::compliance(material, stress[i]);
            plastic_strain[i] = plastic;
          }
      }

      // 1/2 d : C d with the difference d of the elastic strains
      double
      elastic_part() const
      {
        return integrate([this](const unsigned int i, const unsigned int j) {
          const auto &a = elastic_difference[i], &b = elastic_difference[j];
          return 0.5 * material.bulk_modulus * trace(a) * trace(b) +
                 material.shear_modulus * (deviator(a) * deviator(b));
        });
      }

      // R |e_p| + h/2 |e_p|^2 + zeta^2 / (2 h) - tau : e_p. The first term is
      // convex: the mean of its values at the corners bounds it from above.
      double
      plastic_part() const
      {
        const double          hardening = HenckyMaterial::hardening(material);
        double                result    = 0;
        std::array<double, 3> zeta;
        for (unsigned int i = 0; i < 3; ++i)
          {
            result += material.yield_radius * plastic_strain[i].norm() / 3.;
            zeta[i] =
              std::max(0., deviator(stress[i]).norm() - material.yield_radius);
          }
        return result +
               integrate([&](const unsigned int i, const unsigned int j) {
                 double density =
                   0.5 * hardening * (plastic_strain[i] * plastic_strain[j]) -
                   stress[i] * plastic_strain[j];
                 if (hardening > 0)
                   density += 0.5 * zeta[i] * zeta[j] / hardening;
                 return density;
               });
      }

    private:
      const Material<double>                     &material;
      const std::array<SymmetricTensor<2, 3>, 3> &stress;
      std::array<SymmetricTensor<2, 3>, 3>        elastic_difference;
      std::array<SymmetricTensor<2, 3>, 3>        plastic_strain;
    };



    double
    bound_on_triangle(const PlaneBody      &body,
                      const QuadraticField &displacement,
                      const StressField    &stress,
                      const unsigned int    t)
    {
      const auto strain = strains(body.mesh, displacement, t);
      double     result = 0;
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Third third(
            body,
            t,
            JohnsonMercier::on_third(strain, k),
            {{stress.at(t, k, 0), stress.at(t, k, 1), stress.at(t, k, 2)}});
          result += third.elastic_part();
          if (HenckyMaterial::yields(body.materials[t]))
            result += third.plastic_part();
        }
      return area(body.mesh.corners(body.mesh.triangles[t])) / 3. * result;
    }



    /// int p (g - V - v_2) ds, p being linear.
    double
    bound_on_side(const PlaneBody             &body,
                  const QuadraticField        &displacement,
                  const double                 depth,
                  const std::array<double, 2> &pressure,
                  const unsigned int           s)
    {
      static const QGauss<1> quadrature(5);

      double result = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double t = quadrature.point(q)[0];
          result += quadrature.weight(q) *
                    ((1. - t) * pressure[0] + t * pressure[1]) *
                    clearance(body, displacement, depth, s, t);
        }
      return body.mesh.length(body.mesh.sides[s]) * result;
    }
  } // namespace



  double
  ErrorBound::of_body() const
  {
    return sum(of_triangles);
  }



  double
  ErrorBound::of_contact() const
  {
    return sum(of_sides);
  }



  double
  ErrorBound::total() const
  {
    return of_body() + of_contact();
  }



  std::vector<double>
  ErrorBound::indicators(const SplitMesh &mesh) const
  {
    std::vector<double> result = of_triangles;
    for (unsigned int t = 0; t < result.size(); ++t)
      for (const unsigned int side : mesh.triangles[t].sides)
        result[t] += of_sides[side];
    return result;
  }



  // First the ends of the sides, then their middles: the quadratic function of
  // the middle, 4 t (1 - t), is zero at the ends.
  void
  remove_penetration(QuadraticField  &displacement,
                     const PlaneBody &body,
                     const double     depth)
  {
    const auto penetration = [&](const unsigned int s, const double t) {
      return std::max(0., -clearance(body, displacement, depth, s, t));
    };
    for_each_reached_side(body, [&](const unsigned int s, const auto &ends) {
      displacement.at_vertices[ends[0]][1] -= penetration(s, 0.);
      displacement.at_vertices[ends[1]][1] -= penetration(s, 1.);
    });
    for_each_reached_side(body, [&](const unsigned int s, const auto &) {
      double excess = 0;
      for (unsigned int i = 1; i < n_samples; ++i)
        {
          const double t = static_cast<double>(i) / n_samples;
          excess = std::max(excess, penetration(s, t) / (4. * t * (1. - t)));
        }
      displacement.at_sides[s][1] -= excess;
    });
  }



  ErrorBound
  bound_error(const PlaneBody      &body,
              const QuadraticField &displacement,
              const double          depth,
              const StressField    &stress)
  {
    ErrorBound bound;
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      bound.of_triangles.push_back(
        bound_on_triangle(body, displacement, stress, t));

    bound.of_sides.resize(body.mesh.sides.size());
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      if (body.conditions[s].components[1].type == SideConditionType::contact)
        bound.of_sides[s] =
          bound_on_side(body, displacement, depth, stress.pressure[s], s);
    return bound;
  }
} // namespace ElastoPlastic
