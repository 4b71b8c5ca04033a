// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/evaluated_bounds.h"
#include "equilibrium/interior_point.h"
#include "equilibrium/local_algebra.h"
#include "equilibrium/space_stress.h"
#include "equilibrium/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    /// In the units of the body.
    class SpaceStressProgram
    {
    public:
      explicit SpaceStressProgram(const SpaceBody &body);

      SpaceStressField
      solve(const double tolerance) const;

    private:
      void
      number_equations();
      void
      add_block(const unsigned int tetrahedron);
      void
      add_yield_conditions(ConicBlock               &block,
                           const FullMatrix<double> &basis,
                           const unsigned int        tetrahedron) const;
      void
      add_tractions(ConicBlock               &block,
                    const FullMatrix<double> &basis,
                    const unsigned int        tetrahedron) const;
      void
      add_indenter();

      FullMatrix<double>
      basis_of(const unsigned int tetrahedron) const;

      const SpaceBody &body;
      ConicProgram     program;

      /// By corners of faces (see SpaceBody::index()) and components; invalid
      /// where there is none.
      std::vector<std::array<unsigned int, 3>> equations;
    };



    SpaceStressProgram::SpaceStressProgram(const SpaceBody &body)
      : body(body)
    {
      number_equations();
      for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
        add_block(t);
      add_indenter();
    }



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
      const FullMatrix<double> basis = basis_of(t);
      ConicBlock              &block = program.blocks.emplace_back(basis.n());
      add_yield_conditions(block, basis, t);
      add_tractions(block, basis, t);
    }



    // |dev tau| <= R at the corners of the parts
    void
    SpaceStressProgram::add_yield_conditions(ConicBlock               &block,
                                             const FullMatrix<double> &basis,
                                             const unsigned int        t) const
    {
      using namespace TetrahedronStress;
      static const FullMatrix<double> deviator =
        TetrahedronStress::deviator_matrix();
      const unsigned int size = 1 + deviator.m();

      block.cone_matrix.reinit(size * n_points, basis.n());
      block.cone_offset.reinit(size * n_points);
      block.cone_sizes.assign(n_points, size);
      block.cone_scales.assign(n_points, ConeScale());
      for (unsigned int p = 0; p < n_points; ++p)
        {
          block.cone_offset[size * p] =
            body.materials[t].yield_radius / body.stress_unit;
          for (unsigned int d = 0; d < deviator.m(); ++d)
            for (unsigned int c = 0; c < deviator.n(); ++c)
              for (unsigned int j = 0; j < basis.n(); ++j)
                block.cone_matrix(size * p + 1 + d, j) -=
                  deviator(d, c) * basis(deviator.n() * p + c, j);
        }
    }



    void
    SpaceStressProgram::add_tractions(ConicBlock               &block,
                                      const FullMatrix<double> &basis,
                                      const unsigned int        t) const
    {
      const auto        &tetrahedron = body.mesh.tetrahedra[t];
      const Tetrahedron  corners     = body.mesh.corners(tetrahedron);
      constexpr unsigned n           = TetrahedronStress::n_components;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int       f = tetrahedron.faces[k];
          const FullMatrix<double> traction =
            TetrahedronStress::traction_matrix(outward_normal(corners, k));
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int c = 0; c < 3; ++c)
              {
                const unsigned int equation = equations[body.index(f, i)][c];
                if (equation == numbers::invalid_unsigned_int)
                  continue;
                const auto &direction =
                  body.conditions[f].components[c].direction;
                const unsigned int first =
                  TetrahedronStress::value_index(k, corner_of_face(k, i));
                Vector<double> row(basis.n());
                for (unsigned int d = 0; d < 3; ++d)
                  for (unsigned int e = 0; e < n; ++e)
                    for (unsigned int j = 0; j < basis.n(); ++j)
                      row[j] += body.area_of_corner(f) * direction[d] *
                                traction(d, e) * basis(first + e, j);
                block.add_to_equation(equation, row);
              }
        }
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
              ConicBlock &block    = program.blocks.emplace_back(1);
              row[0]               = body.area_of_corner(f);
              block.linear_cost[0] = body.indenter_velocity[2] * row[0];
              block.add_to_equation(equations[body.index(f, i)][2], row);
              row[0] = -1.;
              block.add_inequality(row);
            }
    }



    SpaceStressField
    SpaceStressProgram::solve(const double tolerance) const
    {
      const ConicSolution solution = minimize(program, tolerance);
      const ConicLayout   layout(program);

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
      unsigned int n = layout.unknowns[body.mesh.tetrahedra.size()];
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        if (body.conditions[f].components[2].type == SideConditionType::contact)
          for (unsigned int i = 0; i < 3; ++i)
            field.force += body.area_of_corner(f) * solution.x[n++];
      field.force *= body.stress_unit * body.length_unit * body.length_unit;
      field.load_factor  = body.load_factor_unit * solution.load_factor;
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.is_optimal;
      return field;
    }
  } // namespace



  SymmetricTensor<2, 3>
  SpaceStressField::at(const unsigned int t,
                       const unsigned int part,
                       const unsigned int corner) const
  {
    return TetrahedronStress::stress_from(
      values[t].begin() + TetrahedronStress::value_index(part, corner));
  }



  SpaceStressField
  maximize_load(const SpaceBody &body, const double tolerance)
  {
    return explain_missing_limit(
      [&]() { return SpaceStressProgram(body).solve(tolerance); });
  }
} // namespace ElastoPlastic
