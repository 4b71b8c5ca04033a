// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <utility>

#include "bounds/body/hencky_material.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/stress/space_stress_program.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  SpaceStressProgram::SpaceStressProgram(const SpaceBody &body)
    : body(body)
  {
    number_equations();
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        add_block(t);
        add_tractions(t);
      }
    add_indenter();
  }



  // The work of given tractions is on the right-hand side.
  void
  SpaceStressProgram::number_equations()
  {
    std::vector<double> values, growth;
    equations.resize(3 * body.mesh.faces.size());
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto   &component = body.conditions[f].components[c];
            unsigned int &equation  = equations[body.index(f, i)][c];
            equation                = numbers::invalid_unsigned_int;
            if (component.type == SideConditionType::displacement)
              continue;
            equation          = values.size();
            const double unit = body.area_of_corner(f) / body.stress_unit;
            values.push_back(unit * body.load(f, c, i));
            growth.push_back(unit * body.load_factor_unit *
                             body.growth(f, c, i));
          }
    program.right_hand_side = Vector<double>(values.begin(), values.end());
    if (body.load_factor_unit > 0)
      program.growth = Vector<double>(growth.begin(), growth.end());
  }



  FullMatrix<double>
  SpaceStressProgram::basis_of(const unsigned int t) const
  {
    return TetrahedronStress::equilibrated_basis(
      body.mesh.corners(body.mesh.tetrahedra[t]));
  }



  void
  SpaceStressProgram::add_block(const unsigned int t)
  {
    const FullMatrix<double> basis    = basis_of(t);
    const Material<double>  &material = body.materials[t];
    const unsigned int       n_growths =
      HenckyMaterial::hardens(material) ? TetrahedronStress::n_points : 0;
    ConicBlock &block = program.blocks.emplace_back(basis.n() + n_growths);
    if (HenckyMaterial::yields(material))
      add_yield_conditions(block, basis, t);
  }



  // |dev tau| <= R + zeta at the corners of the parts
  void
  SpaceStressProgram::add_yield_conditions(ConicBlock               &block,
                                           const FullMatrix<double> &basis,
                                           const unsigned int        t) const
  {
    using namespace TetrahedronStress;
    static const FullMatrix<double> deviator =
      TetrahedronStress::deviator_matrix();
    const unsigned int size = 1 + deviator.m();

    block.cone_matrix.reinit(size * n_points, block.linear_cost.size());
    block.cone_offset.reinit(size * n_points);
    block.cone_sizes.assign(n_points, size);
    block.cone_scales.assign(n_points, ConeScale());
    for (unsigned int p = 0; p < n_points; ++p)
      {
        block.cone_offset[size * p] =
          body.materials[t].yield_radius / body.stress_unit;
        if (HenckyMaterial::hardens(body.materials[t]))
          block.cone_matrix(size * p, basis.n() + p) = -1.;
        for (unsigned int d = 0; d < deviator.m(); ++d)
          for (unsigned int c = 0; c < deviator.n(); ++c)
            for (unsigned int j = 0; j < basis.n(); ++j)
              block.cone_matrix(size * p + 1 + d, j) -=
                deviator(d, c) * basis(deviator.n() * p + c, j);
      }
  }



  void
  SpaceStressProgram::add_tractions(const unsigned int t)
  {
    const FullMatrix<double> basis = basis_of(t);
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const unsigned int f        = body.mesh.tetrahedra[t].faces[k];
            const unsigned int equation = equations[body.index(f, i)][c];
            if (equation != numbers::invalid_unsigned_int)
              program.blocks[t].add_to_equation(
                equation, force_at_corner(t, basis, k, i, c));
          }
  }



  Vector<double>
  SpaceStressProgram::force_at_corner(const unsigned int        t,
                                      const FullMatrix<double> &basis,
                                      const unsigned int        k,
                                      const unsigned int        i,
                                      const unsigned int        component) const
  {
    const auto              &tetrahedron = body.mesh.tetrahedra[t];
    const unsigned int       f           = tetrahedron.faces[k];
    const FullMatrix<double> traction    = TetrahedronStress::traction_matrix(
      outward_normal(body.mesh.corners(tetrahedron), k));
    const Tensor<1, 3> direction =
      body.area_of_corner(f) *
      body.conditions[f].components[component].direction;
    const unsigned int first =
      TetrahedronStress::value_index(k, corner_of_face(k, i));

    Vector<double> row(program.blocks[t].linear_cost.size());
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < TetrahedronStress::n_components; ++e)
        for (unsigned int j = 0; j < basis.n(); ++j)
          row[j] += direction[d] * traction(d, e) * basis(first + e, j);
    return row;
  }



  // The pressure points down.
  void
  SpaceStressProgram::add_indenter()
  {
    Vector<double> row(1);
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].components[2].type == SideConditionType::contact)
        for (unsigned int i = 0; i < 3; ++i)
          {
            contact_corners.push_back({f, i});
            ConicBlock &block = program.blocks.emplace_back(1);
            row[0]            = body.area_of_corner(f);
            block.add_to_equation(equations[body.index(f, i)][2], row);
            row[0] = -1.;
            block.add_inequality(row);
          }
  }



  SpaceStressField
  SpaceStressProgram::solve(const double tolerance)
  {
    const ConicLayout   layout(program);
    const bool          force_is_given = program.n_dense_rows > 0;
    const ConicSolution solution = minimize(std::move(program), tolerance);
    const double        length   = body.length_unit;
    const double        force    = body.stress_unit * length * length;

    SpaceStressField field;
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        const FullMatrix<double> basis = basis_of(t);
        Vector<double>          &values =
          field.values.emplace_back(TetrahedronStress::n_values);
        LocalAlgebra::add_product(values.begin(),
                                  basis,
                                  solution.x.begin() + layout.unknowns[t]);
        values *= body.stress_unit;
      }
    field.pressure.resize(body.mesh.faces.size());
    const unsigned int first = layout.unknowns[body.mesh.tetrahedra.size()];
    for (unsigned int i = 0; i < contact_corners.size(); ++i)
      {
        const auto [f, corner]    = contact_corners[i];
        const double pressure     = solution.x[first + i];
        field.pressure[f][corner] = body.stress_unit * pressure;
        field.force += force * body.area_of_corner(f) * pressure;
      }
    if (force_is_given)
      field.depth =
        -body.strain_unit * length * solution.y[solution.y.size() - 1];
    field.load_factor  = body.load_factor_unit * solution.load_factor;
    field.cost         = solution.cost * force * body.strain_unit * length;
    field.n_iterations = solution.n_iterations;
    field.is_optimal   = solution.is_optimal;
    return field;
  }
} // namespace ElastoPlastic
