// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/tensors.h"
#include "bounds/body/hencky_material.h"
#include "bounds/error/error_bound.h"
#include "bounds/error/face_gap.h"
#include "bounds/error/support_check.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What integrates a positive quadratic form of linear functions over r,
    /// which is linear with these values at the corners of a part, never too
    /// small.
    std::vector<WeightedPoint<2>>
    quadrature_of_part(const std::array<double, 3> &r)
    {
      return quadrature_over(r);
    }

    const std::vector<WeightedPoint<3>> &
    quadrature_of_part(const std::array<double, 4> &)
    {
      return simplex_quadrature<3>();
    }



    /// A part of a simplex. Fields are weighted, see LocalStresses: stress,
    /// plastic strain and growth of the yield surface are linear then.
    template <int dim>
    class PartOfSimplex
    {
    public:
      /// @p norm is that of plastic strains, @p strains are those at the
      /// corners of the simplex.
      PartOfSimplex(const SplitBody<dim>      &body,
                    const RateNorm            &norm,
                    const QuadraticField<dim> &displacement,
                    const StressField<dim>    &stress_field,
                    const std::array<SymmetricTensor<2, dim>, dim + 1> &strains,
                    const unsigned int                                  t,
                    const unsigned int                                  k)
        : body(body)
        , material(body.materials[t])
        , norm(norm)
        , displacement(displacement)
        , simplex(body.mesh.simplices[t])
        , k(k)
      {
        const auto strains_of_part = on_part<dim>(strains, k);
        for (unsigned int i = 0; i <= dim; ++i)
          strain[i] = in_space<dim>(strains_of_part[i], 0.);
        if (!body.initial_strains.empty())
          {
            const auto initial = on_part<dim>(body.initial_strains[t], k);
            for (unsigned int i = 0; i <= dim; ++i)
              strain[i] += initial[i];
          }
        const auto corners =
          JohnsonMercier<dim>::part_of(body.corners_of(t), k);
        for (unsigned int i = 0; i <= dim; ++i)
          {
            stress[i] = stress_field.coefficient(t, k, i);
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
            result += material.yield_radius * norm(plastic) / (dim + 1.);
        for (const auto &[position, weight] : quadrature_of_part(r))
          result +=
            weight *
            HenckyMaterial::quadratic_gap(material,
                                          norm,
                                          strain_at(position),
                                          interpolate(position, plastic_strain),
                                          interpolate(position, stress),
                                          interpolate(position, zeta));
        return result;
      }

    private:
      /// Sets what follows from strain and stress at a corner. Next to the
      /// axis, where the strain may depend on the direction, plastic strains go
      /// to zero when weighted.
      void
      split(const unsigned int i)
      {
        using HenckyMaterial::split_strain;
        if (HenckyMaterial::yields(material))
          zeta[i] = std::max(0.,
                             stress_norm(material, stress[i]) -
                               r[i] * material.yield_radius);
        strain[i] = HenckyMaterial::strain_of_section(material,
                                                      strain[i],
                                                      body.kinematics);
        if (r[i] > 0)
          plastic_strain[i] =
            r[i] *
            split_strain(material, strain_at(corner_position<dim>(i)) / r[i])
              .plastic;
      }

      /// The weighted strain. Around the axis, the displacement makes a strain
      /// that is the radial displacement when weighted.
      SymmetricTensor<2, 3>
      strain_at(const Barycentric<dim> &point) const
      {
        SymmetricTensor<2, 3> result =
          interpolate(point, r) * interpolate(point, strain);
        if (body.is_axisymmetric())
          result[2][2] += radial_displacement(point);
        return result;
      }

      double
      radial_displacement(const Barycentric<dim> &point) const
      {
        return displacement.value(simplex, point_of_part<dim>(k, point))[0];
      }

      using Tensors = std::array<SymmetricTensor<2, 3>, dim + 1>;

      const SplitBody<dim>                   &body;
      const Material<double>                 &material;
      const RateNorm                         &norm; ///< of plastic strains
      const QuadraticField<dim>              &displacement;
      const typename SplitMesh<dim>::Simplex &simplex;
      const unsigned int                      k;
      Tensors strain; ///< not weighted, without what the displacement makes
                      ///< around the axis
      Tensors                     stress;
      std::array<double, dim + 1> r    = {};
      std::array<double, dim + 1> zeta = {};
      Tensors                     plastic_strain;
    };



    template <int dim>
    double
    bound_on_simplex(const SplitBody<dim>      &body,
                     const QuadraticField<dim> &displacement,
                     const StressField<dim>    &stress,
                     const unsigned int         t)
    {
      constexpr unsigned int n_parts = JohnsonMercier<dim>::n_parts;
      const auto             strain  = displacement.strains(body.mesh, t);
      const RateNorm         norm(body.materials[t]);
      double                 result = 0;
      for (unsigned int k = 0; k < n_parts; ++k)
        result +=
          PartOfSimplex<dim>(body, norm, displacement, stress, strain, t, k)
            .bound();
      return body.angle() * volume(body.corners_of(t)) / n_parts * result;
    }



    /// int p (g - V - v_d) ds with the upper bound of g; the weighted p is
    /// linear. All is at most cubic on the small simplices.
    template <int dim>
    double
    bound_on_face(const SplitBody<dim>      &body,
                  const QuadraticField<dim> &displacement,
                  const double               depth,
                  const std::vector<double> &pressure,
                  const unsigned int         f)
    {
      const auto              corners = body.corners_of_face(f);
      const auto              v = displacement.values_on_face(body.mesh, f);
      std::array<double, dim> weighted = body.weights(corners);
      for (unsigned int i = 0; i < dim; ++i)
        weighted[i] *= pressure[i];
      double sum = 0;
      for (const auto &small : FaceGap<dim>(body.gap, corners).small_simplices)
        for (const auto &[inside, weight] : simplex_quadrature<dim - 1>())
          {
            const auto position = interpolate(inside, small.corners);
            sum += small.part * weight * interpolate(position, weighted) *
                   (interpolate(inside, small.upper) - depth -
                    v.value(position)[dim - 1]);
          }
      return body.angle() * area(corners) * sum;
    }
  } // namespace



  template <int dim>
  ErrorBound
  bound_error(const SplitBody<dim>      &body,
              const QuadraticField<dim> &displacement,
              const double               depth,
              const StressField<dim>    &stress)
  {
    AssertDimension(stress.degree, 1);
    require_supported(body, displacement);
    ErrorBound bound;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      bound.of_simplices.push_back(
        bound_on_simplex(body, displacement, stress, t));

    bound.of_faces.resize(body.mesh.faces.size());
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_pressed())
        bound.of_faces[f] =
          bound_on_face(body, displacement, depth, stress.pressure[f], f);
    return bound;
  }



  template ErrorBound
  bound_error(const SplitBody<2> &,
              const QuadraticField<2> &,
              const double,
              const StressField<2> &);
  template ErrorBound
  bound_error(const SplitBody<3> &,
              const QuadraticField<3> &,
              const double,
              const StressField<3> &);
} // namespace ElastoPlastic
