// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include "bounds/body/hencky_material.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/stress/space_stress_program.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    /// int u v dx of functions that are linear on a part of a tetrahedron, by
    /// their values at two of its corners, relative to the volume of the
    /// tetrahedron.
    double
    mass(const unsigned int corner, const unsigned int other_corner)
    {
      return (corner == other_corner ? 2. : 1.) /
             (20. * TetrahedronStress::n_parts);
    }



    /// C^-1 @p stress, the shear components counting twice, like those of the
    /// components in stress : strain.
    std::array<double, TetrahedronStress::n_components>
    strain_components(const Material<double>      &material,
                      const SymmetricTensor<2, 3> &stress)
    {
      const auto strain = HenckyMaterial::compliance(material, stress);
      std::array<double, TetrahedronStress::n_components> result;
      for (unsigned int c = 0; c < TetrahedronStress::n_components; ++c)
        result[c] = (c < 3 ? 1. : 2.) * strain.access_raw_entry(c);
      return result;
    }



    /// int g phi ds for the linear function phi that is 1 at a corner of a face
    /// and 0 at the others, relative to a third of the area.
    std::array<double, 3>
    moments(const std::function<double(const Point<3> &)> &g,
            const TriangleFace                            &corners)
    {
      static const QWitherdenVincentSimplex<2> quadrature(4);
      std::array<double, 3>                    result = {};
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Point<2>              s        = quadrature.point(q);
          const std::array<double, 3> position = {
            {1. - s[0] - s[1], s[0], s[1]}};
          const Point<3> x(corners[0] + s[0] * (corners[1] - corners[0]) +
                           s[1] * (corners[2] - corners[0]));
          // (the weights add up to 1/2)
          for (unsigned int i = 0; i < 3; ++i)
            result[i] += 6. * quadrature.weight(q) * position[i] * g(x);
        }
      return result;
    }
  } // namespace



  // The scales of the cones are explained in doc/theory, "Guaranteed error".
  void
  SpaceStressProgram::add_energy()
  {
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        ConicBlock              &block = program.blocks[t];
        const FullMatrix<double> basis = basis_of(t);
        const double             part =
          volume(body.mesh.corners(body.mesh.tetrahedra[t])) /
          (body.length_unit * body.length_unit * body.length_unit);
        block.quadratic_cost.reinit(block.linear_cost.size(),
                                    block.linear_cost.size());
        add_elastic_energy(t, basis, part);
        if (HenckyMaterial::hardens(body.materials[t]))
          add_hardening_energy(t, part);
        add_work_of_supports(t, basis);
        std::fill(block.cone_scales.begin(),
                  block.cone_scales.end(),
                  ConeScale{body.materials[t].yield_radius / body.stress_unit,
                            std::pow(part / TetrahedronStress::n_points,
                                     0.75)});
      }
  }



  void
  SpaceStressProgram::add_elastic_energy(const unsigned int        t,
                                         const FullMatrix<double> &basis,
                                         const double              part)
  {
    using namespace TetrahedronStress;
    FullMatrix<double> strains(n_values, basis.n());
    for (unsigned int j = 0; j < basis.n(); ++j)
      for (unsigned int p = 0; p < n_points; ++p)
        {
          std::array<double, n_components> values;
          for (unsigned int c = 0; c < n_components; ++c)
            values[c] = basis(n_components * p + c, j);
          const auto strain =
            strain_components(body.materials[t], stress_from(values.data()));
          for (unsigned int q = 4 * (p / 4); q < 4 * (p / 4) + 4; ++q)
            for (unsigned int c = 0; c < n_components; ++c)
              strains(n_components * q + c, j) += part * body.stress_unit /
                                                  body.strain_unit *
                                                  mass(p, q) * strain[c];
        }
    FullMatrix<double> energy(basis.n(), basis.n());
    basis.Tmmult(energy, strains);
    program.blocks[t].quadratic_cost.fill(energy);
  }



  void
  SpaceStressProgram::add_hardening_energy(const unsigned int t,
                                           const double       part)
  {
    using namespace TetrahedronStress;
    FullMatrix<double> &cost  = program.blocks[t].quadratic_cost;
    const unsigned int  first = cost.n() - n_points;
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int q = 4 * (p / 4); q < 4 * (p / 4) + 4; ++q)
        cost(first + p, first + q) =
          part * body.stress_unit / body.strain_unit * mass(p, q) /
          HenckyMaterial::hardening(body.materials[t]);
  }



  // Traction and displacement are linear on a face.
  void
  SpaceStressProgram::add_work_of_supports(const unsigned int        t,
                                           const FullMatrix<double> &basis)
  {
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const auto &component =
            body.conditions[body.mesh.tetrahedra[t].faces[k]].components[c];
          if (component.type != SideConditionType::displacement)
            continue;
          const auto &u = component.values;
          for (unsigned int i = 0; i < 3; ++i)
            if (const double moment = 0.25 * (u[0] + u[1] + u[2] + u[i]);
                moment != 0.)
              program.blocks[t].linear_cost.add(
                -moment / (body.strain_unit * body.length_unit),
                force_at_corner(t, basis, k, i, c));
        }
  }



  void
  SpaceStressProgram::add_gap()
  {
    for (unsigned int i = 0; i < contact_corners.size(); ++i)
      {
        const auto [f, corner]                     = contact_corners[i];
        contact_block(i).cone_scales[0].multiplier = body.area_of_corner(f);
        add_contact_cost(
          i, moments(body.gap, body.mesh.corners(body.mesh.faces[f]))[corner]);
      }
  }



  void
  SpaceStressProgram::add_force(const double factor)
  {
    for (unsigned int i = 0; i < contact_corners.size(); ++i)
      add_contact_cost(i, factor);
  }



  ConicBlock &
  SpaceStressProgram::contact_block(const unsigned int i)
  {
    return program.blocks[body.mesh.tetrahedra.size() + i];
  }



  void
  SpaceStressProgram::add_contact_cost(const unsigned int i,
                                       const double       distance)
  {
    contact_block(i).linear_cost[0] +=
      body.area_of_corner(contact_corners[i].face) * distance /
      (body.strain_unit * body.length_unit);
  }



  void
  SpaceStressProgram::prescribe_force(const double force)
  {
    const unsigned int row = program.right_hand_side.size();
    program.right_hand_side.grow_or_shrink(row + 1);
    program.right_hand_side[row] =
      force / (body.stress_unit * body.length_unit * body.length_unit);
    program.n_dense_rows = 1;
    Vector<double> part(1);
    for (unsigned int i = 0; i < contact_corners.size(); ++i)
      {
        part[0] = body.area_of_corner(contact_corners[i].face);
        contact_block(i).add_to_equation(row, part);
      }
  }
} // namespace ElastoPlastic
