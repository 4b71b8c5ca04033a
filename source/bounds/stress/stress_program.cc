// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/hencky_material.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/local_stresses.h"
#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace JohnsonMercier;
    using namespace HenckyMaterial;
    using namespace LocalAlgebra;

    constexpr unsigned int n_components = n_stress_components;



    /// C^-1 for the components 11, 22, 12, 33; the shear stress counts twice.
    FullMatrix<double>
    compliance_matrix(const Material<double> &material)
    {
      constexpr std::array<std::array<unsigned int, 2>, n_components> indices =
        {{{{0, 0}}, {{1, 1}}, {{0, 1}}, {{2, 2}}}};
      FullMatrix<double> c(n_components, n_components);
      for (unsigned int j = 0; j < n_components; ++j)
        {
          SymmetricTensor<2, 3> stress;
          stress[indices[j][0]][indices[j][1]] = 1.;
          const auto strain                    = compliance(material, stress);
          for (unsigned int i = 0; i < n_components; ++i)
            c(i, j) = (i == 2 ? 2. : 1.) * strain[indices[i][0]][indices[i][1]];
        }
      return c;
    }



    /// The area of a subtriangle, with what turns compliances into the units of
    /// the body.
    double
    energy_weight(const PlaneBody &body, const unsigned int t)
    {
      return area(body.mesh.corners(body.mesh.triangles[t])) /
             (3. * body.length_unit * body.length_unit) * body.stress_unit /
             body.strain_unit;
    }



    /// The multipliers of the yield conditions are moments of the plastic
    /// strain: like the area, where that is smooth, or nearly the same on all
    /// triangles, where it concentrates and they are refined. A power in
    /// between takes half as many iterations as equal scales do.
    ConeScale
    yield_scale(const PlaneBody   &body,
                const unsigned int t,
                const unsigned int degree)
    {
      const double part =
        area(body.mesh.corners(body.mesh.triangles[t])) *
        LocalStresses::weights(body, t, /* degree = */ 1)[2] /
        (n_points(degree) * body.length_unit * body.length_unit);
      return {body.materials[t].yield_radius / body.stress_unit,
              std::pow(part, 0.75)};
    }

  } // namespace



  StressProgram::StressProgram(const PlaneBody       &body,
                               const OutOfPlaneStress out_of_plane,
                               const unsigned int     degree)
    : body(body)
    , out_of_plane(out_of_plane)
    , degree(degree)
  {
    number_equations();
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      {
        add_block(t);
        add_yield_conditions(t);
        add_sides(t);
      }
    add_indenter();
  }



  void
  StressProgram::add_block(const unsigned int t)
  {
    const bool own_unknown = out_of_plane == OutOfPlaneStress::unknown;
    const FullMatrix<double> basis =
      LocalStresses::equilibrated_basis(body, t, degree);
    const unsigned int n =
      basis.n() + (own_unknown ? n_points(degree) : 0) +
      (hardens(body.materials[t]) ?
         LocalStresses::points_off_axis(body, t, degree).size() :
         0);

    FullMatrix<double> &stress =
      point_stresses.emplace_back(n_components * n_points(degree), n);
    for (unsigned int p = 0; p < n_points(degree); ++p)
      {
        const unsigned int row = n_components * p;
        for (unsigned int j = 0; j < basis.n(); ++j)
          {
            for (unsigned int c = 0; c < 3; ++c)
              stress(row + c, j) = basis(3 * p + c, j);
            if (out_of_plane == OutOfPlaneStress::mean)
              stress(row + 3, j) =
                0.5 * (basis(3 * p, j) + basis(3 * p + 1, j));
          }
        if (own_unknown)
          stress(row + 3, basis.n() + p) = 1.;
      }
    if (out_of_plane == OutOfPlaneStress::circumferential)
      add_circumferential_stress(t, basis);

    program.blocks.emplace_back(n);
  }



  void
  StressProgram::add_circumferential_stress(const unsigned int        t,
                                            const FullMatrix<double> &basis)
  {
    const auto coefficients =
      LocalStresses::circumferential_matrix(body, t, degree);
    const auto weighting = LocalStresses::weighting_matrix(body, t, degree);
    FullMatrix<double> of_subtriangles(coefficients.m(), basis.n()),
      weighted(weighting.m(), basis.n());
    coefficients.mmult(of_subtriangles, basis);
    weighting.mmult(weighted, of_subtriangles);
    for (unsigned int p = 0; p < weighted.m(); ++p)
      for (unsigned int j = 0; j < basis.n(); ++j)
        point_stresses[t](n_components * p + 3, j) = weighted(p, j);
  }



  // |dev tau| <= R + zeta
  void
  StressProgram::add_yield_conditions(const unsigned int t)
  {
    const Material<double> &material = body.materials[t];
    if (!yields(material))
      return;
    ConicBlock              &block = program.blocks[t];
    const FullMatrix<double> points =
      LocalStresses::yield_points(body, t, degree);
    FullMatrix<double> stress(points.m(), point_stresses[t].n());
    points.mmult(stress, point_stresses[t]);
    ElastoPlastic::add_yield_conditions(
      block, stress, material.yield_radius / body.stress_unit);
    if (hardens(material))
      for (unsigned int i = 0, n = block.cone_sizes.size(); i < n; ++i)
        block.cone_matrix(4 * i, block.cone_matrix.n() - n + i) = -1.;
  }



  FullMatrix<double>
  StressProgram::weighted_mass(const unsigned int t) const
  {
    const auto   weights = LocalStresses::weights(body, t, /* degree = */ 1);
    const double unit    = energy_weight(body, t);
    const unsigned int n = Bernstein::n_functions(degree);
    FullMatrix<double> mass(3 * n, 3 * n);
    for (unsigned int k = 0; k < 3; ++k)
      for (const WeightedPoint &point : quadrature_over(
             {{weights[3 * k], weights[3 * k + 1], weights[3 * k + 2]}}))
        {
          const auto functions = Bernstein::functions(degree, point.position);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              mass(n * k + i, n * k + j) +=
                unit * point.weight * functions[i] * functions[j];
        }
    return mass;
  }



  FullMatrix<double>
  StressProgram::elastic_energy(const unsigned int t) const
  {
    const FullMatrix<double> c    = compliance_matrix(body.materials[t]);
    const FullMatrix<double> mass = weighted_mass(t);
    FullMatrix<double> energy(n_components * mass.m(), n_components * mass.n());
    for (unsigned int p = 0; p < mass.m(); ++p)
      for (unsigned int q = 0; q < mass.n(); ++q)
        for (unsigned int i = 0; i < n_components; ++i)
          for (unsigned int k = 0; k < n_components; ++k)
            energy(n_components * p + i, n_components * q + k) =
              mass(p, q) * c(i, k);
    return energy;
  }



  // zeta is weighted like the stresses.
  void
  StressProgram::add_hardening_energy(const unsigned int t)
  {
    const auto weights = LocalStresses::weights(body, t, degree);
    const auto points  = LocalStresses::points_off_axis(body, t, degree);
    const FullMatrix<double> mass  = weighted_mass(t);
    FullMatrix<double>      &cost  = program.blocks[t].quadratic_cost;
    const unsigned int       first = cost.n() - points.size();
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int j = 0; j < points.size(); ++j)
        cost(first + i, first + j) += weights[points[i]] * weights[points[j]] *
                                      mass(points[i], points[j]) /
                                      hardening(body.materials[t]);
  }



  void
  StressProgram::add_energy()
  {
    has_energy = true;
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      {
        ConicBlock        &block = program.blocks[t];
        const unsigned int n     = block.linear_cost.size();
        block.quadratic_cost.reinit(n, n);
        FullMatrix<double> strain(point_stresses[t].m(), n);
        elastic_energy(t).mmult(strain, point_stresses[t]);
        point_stresses[t].Tmmult(block.quadratic_cost, strain);
        if (yields(body.materials[t]))
          std::fill(block.cone_scales.begin(),
                    block.cone_scales.end(),
                    yield_scale(body, t, degree));
        if (hardens(body.materials[t]))
          add_hardening_energy(t);

        for (const SideOfTriangle &side : sides[t])
          for (unsigned int c = 0; c < 2; ++c)
            {
              if (body.conditions[side.side].components[c].type !=
                  SideConditionType::displacement)
                continue;
              for (unsigned int i = 0; i <= degree; ++i)
                block.linear_cost.add(given_multiplier(side.side, i, c),
                                      side.forces[i][c]);
            }
      }
  }
} // namespace ElastoPlastic
