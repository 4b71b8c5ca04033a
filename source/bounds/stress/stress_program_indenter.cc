// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  // The indenter's forces point down.
  void
  StressProgram::add_indenter()
  {
    Vector<double> force(1);
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      if (body.conditions[s].components[1].type == SideConditionType::contact)
        for (unsigned int i = 0; i <= degree; ++i)
          if (equations[s][i][1] != numbers::invalid_unsigned_int)
            {
              contact_points.push_back({s, i});
              ConicBlock &block = program.blocks.emplace_back(1);
              force[0]          = 1.;
              block.add_to_equation(equations[s][i][1], force);
              force[0] = -1.;
              block.add_inequality(force);
            }
  }



  void
  StressProgram::add_gap()
  {
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        const auto [side, point]              = contact_points[i];
        contact_block(i).cone_scales[0].slack = share_of_side(side);
        add_contact_cost(i, moments(side, body.gap)[point]);
      }
  }



  void
  StressProgram::add_force(const double factor)
  {
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      add_contact_cost(i, factor);
  }



  ConicBlock &
  StressProgram::contact_block(const unsigned int i)
  {
    return program.blocks[body.mesh.triangles.size() + i];
  }



  double
  StressProgram::vertical_part(const unsigned int i) const
  {
    return body.conditions[contact_points[i].side].components[1].direction[1];
  }



  void
  StressProgram::add_contact_cost(const unsigned int i, const double distance)
  {
    contact_block(i).linear_cost[0] +=
      vertical_part(i) * distance / (body.strain_unit * body.length_unit);
  }



  double
  StressProgram::force_unit() const
  {
    return body.stress_unit * body.length_unit * body.weight_unit() *
           body.angle();
  }



  void
  StressProgram::prescribe_force(const double force)
  {
    const unsigned int row = program.right_hand_side.size();
    program.right_hand_side.grow_or_shrink(row + 1);
    program.right_hand_side[row] = force / force_unit();
    program.n_dense_rows         = 1;
    Vector<double> part(1);
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        part[0] = vertical_part(i);
        contact_block(i).add_to_equation(row, part);
      }
  }
} // namespace ElastoPlastic
