// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/hencky_material.h"
#include "bounds/stress/stress_program.h"

// What StressProgram minimises: the energy.

namespace ElastoPlastic
{
  using namespace HenckyMaterial;

  namespace
  {
    /// C^-1 for the components of a stress; the shear stresses count twice.
    template <int dim>
    FullMatrix<double>
    compliance_matrix(const Material<double> &material)
    {
      constexpr unsigned int n = n_stress_components<dim>;
      FullMatrix<double>     c(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            std::array<double, n> unit = {}, other = {};
            unit[i] = other[j] = 1.;
            c(i, j)            = stress_from<dim>(unit.data()) *
                      compliance(material, stress_from<dim>(other.data()));
          }
      return c;
    }
  } // namespace



  template <int dim>
  FullMatrix<double>
  StressProgram<dim>::weighted_mass(const unsigned int t,
                                    const unsigned int part) const
  {
    const double unit = body.relative_volume(t) / Element::n_parts *
                        body.stress_unit / body.strain_unit;
    FullMatrix<double> mass;
    if (!body.is_axisymmetric())
      {
        mass = Bernstein<dim>::mass_matrix(degree);
        mass *= unit;
        return mass;
      }
    if constexpr (dim == 2)
      {
        const auto w = local(t).weights_at_corners();
        mass.reinit(Bernstein<2>::n_functions(degree),
                    Bernstein<2>::n_functions(degree));
        for (const auto &[position, weight] :
             quadrature_over({{w[3 * part], w[3 * part + 1], w[3 * part + 2]}}))
          {
            const auto functions = Bernstein<2>::functions(degree, position);
            for (unsigned int i = 0; i < functions.size(); ++i)
              for (unsigned int j = 0; j < functions.size(); ++j)
                mass(i, j) += unit * weight * functions[i] * functions[j];
          }
      }
    return mass;
  }



  template <int dim>
  FullMatrix<double>
  StressProgram<dim>::strain_moments(const unsigned int        t,
                                     const FullMatrix<double> &stresses) const
  {
    constexpr unsigned int   n_components = n_stress_components<dim>;
    const unsigned int       n_functions  = Bernstein<dim>::n_functions(degree);
    const FullMatrix<double> c = compliance_matrix<dim>(body.materials[t]);
    FullMatrix<double>       strains(stresses.m(), stresses.n()),
      moments(stresses.m(), stresses.n());
    for (unsigned int i = 0; i < stresses.m(); ++i)
      for (unsigned int e = 0; e < n_components; ++e)
        if (const double entry = c(i % n_components, e); entry != 0.)
          for (unsigned int j = 0; j < stresses.n(); ++j)
            strains(i, j) += entry * stresses(i - i % n_components + e, j);
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const FullMatrix<double> mass  = weighted_mass(t, k);
        const unsigned int       first = n_components * n_functions * k;
        for (unsigned int p = 0; p < n_functions; ++p)
          for (unsigned int q = 0; q < n_functions; ++q)
            for (unsigned int e = 0; e < n_components; ++e)
              for (unsigned int j = 0; j < stresses.n(); ++j)
                moments(first + n_components * p + e, j) +=
                  mass(p, q) * strains(first + n_components * q + e, j);
      }
    return moments;
  }



  // The stresses are weighted, this strain is not.
  template <int dim>
  Vector<double>
  StressProgram<dim>::moments_of_initial_strain(const unsigned int t) const
  {
    AssertDimension(degree, 1);
    constexpr unsigned int n_components = n_stress_components<dim>;
    constexpr unsigned int n_functions  = dim + 1;
    FullMatrix<double>     mass         = Bernstein<dim>::mass_matrix(degree);
    mass *= body.relative_volume(t) / (Element::n_parts * body.strain_unit);
    Vector<double> moments(n_components * n_functions * Element::n_parts);
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const auto strains = on_part<dim>(body.initial_strains[t], k);
        for (unsigned int p = 0; p < n_functions; ++p)
          {
            SymmetricTensor<2, 3> moment;
            for (unsigned int q = 0; q < n_functions; ++q)
              moment += mass(p, q) * strains[q];
            for (unsigned int e = 0; e < n_components; ++e)
              {
                std::array<double, n_components> unit = {};
                unit[e]                               = 1.;
                moments[n_components * (n_functions * k + p) + e] =
                  moment * stress_from<dim>(unit.data());
              }
          }
      }
    return moments;
  }



  template <int dim>
  double
  StressProgram<dim>::energy_of_initial_stress() const
  {
    double energy = 0;
    for (unsigned int t = 0; t < body.initial_strains.size(); ++t)
      {
        const double volume =
          body.angle() * ElastoPlastic::volume(body.corners_of(t));
        const auto weights = body.weights(body.corners_of(t));
        for (const auto &[position, weight] : simplex_quadrature<dim>())
          energy += 0.5 * volume * weight * interpolate(position, weights) *
                    HenckyMaterial::elastic_product(
                      body.materials[t],
                      interpolate(position, body.initial_strains[t]));
      }
    return energy;
  }



  // zeta is weighted like the stresses.
  template <int dim>
  void
  StressProgram<dim>::add_hardening_energy(const unsigned int t)
  {
    const unsigned int        n_functions = Bernstein<dim>::n_functions(degree);
    const auto                weights     = local(t).weights();
    std::vector<unsigned int> points;
    for (unsigned int p = 0; p < weights.size(); ++p)
      if (weights[p] > 0)
        points.push_back(p);
    std::vector<FullMatrix<double>> masses;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      masses.push_back(weighted_mass(t, k));
    FullMatrix<double> &cost  = program.blocks[t].quadratic_cost;
    const unsigned int  first = cost.n() - points.size();
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int j = 0; j < points.size(); ++j)
        if (points[i] / n_functions == points[j] / n_functions)
          cost(first + i, first + j) +=
            weights[points[i]] * weights[points[j]] *
            masses[points[i] / n_functions](points[i] % n_functions,
                                            points[j] % n_functions) /
            hardening(body.materials[t]);
  }



  template <int dim>
  void
  StressProgram<dim>::add_work_of_supports(const unsigned int        t,
                                           const FullMatrix<double> &stresses)
  {
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const unsigned int face = body.mesh.simplices[t].faces[k];
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto &component = body.conditions[face].components[c];
            if (component.type != ConditionType::displacement ||
                component.value.is_zero())
              continue;
            for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
              program.blocks[t].linear_cost.add(given_multiplier({face, i}, c),
                                                row_of(point_force(t, k, i, c),
                                                       stresses));
          }
      }
  }



  // The multipliers of the yield conditions are moments of the plastic strain:
  // like the volume, where that is smooth, or nearly the same on all simplices,
  // where it concentrates and they are refined. A power in between takes half
  // as many iterations as equal scales do (doc/theory, "Guaranteed error").
  template <int dim>
  void
  StressProgram<dim>::add_energy()
  {
    has_energy = true;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        ConicBlock              &block    = program.blocks[t];
        const FullMatrix<double> stresses = point_stresses(t);
        block.quadratic_cost.reinit(stresses.n(), stresses.n());
        stresses.Tmmult(block.quadratic_cost, strain_moments(t, stresses));
        if (hardens(body.materials[t]))
          add_hardening_energy(t);
        if (!body.initial_strains.empty())
          {
            Vector<double> moments = moments_of_initial_strain(t);
            moments *= -1.;
            stresses.Tvmult_add(block.linear_cost, moments);
          }
        add_work_of_supports(t, stresses);
        const double part = body.relative_volume(t) *
                            local(t).weight_of_centre() /
                            Element::n_points(degree);
        std::fill(block.cone_scales.begin(),
                  block.cone_scales.end(),
                  ConeScale{body.materials[t].yield_radius / body.stress_unit,
                            std::pow(part, 0.75)});
      }
  }
} // namespace ElastoPlastic
