// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/exceptions.h"
#include "bounds/conic/conic_evaluation.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int max_restorations = 5;



    double
    largest_entry(const Vector<double> &v)
    {
      return v.size() > 0 ? v.linfty_norm() : 0.;
    }



    bool
    satisfies_equations(const ConicSolution &solution)
    {
      return solution.primal_error <= Tolerance::primal_equations &&
             solution.dual_error <= Tolerance::dual_equations;
    }



    // What stresses lack, stresses make up for, and not the multipliers: these
    // are velocities, which have conditions of their own.
    void
    restore_equations(const ConicProgram &program,
                      const ConicLayout  &layout,
                      const KktSystem    &system,
                      ConicSolution      &solution)
    {
      KktVector residual = evaluate(program, layout, system, solution), change;
      for (unsigned int k = 0;
           k < max_restorations && !satisfies_equations(solution);
           ++k)
        {
          KktVector of_stresses   = residual;
          of_stresses.x           = 0.;
          of_stresses.z           = 0.;
          of_stresses.load_factor = 0.;
          system.solve(change, of_stresses);
          solution.x += change.x;
          solution.load_factor += change.load_factor;

          residual   = evaluate(program, layout, system, solution);
          residual.y = 0.;
          residual.z = 0.;
          system.solve(change, residual);
          solution.x += change.x;
          solution.y += change.y;
          solution.z += change.z;
          solution.load_factor += change.load_factor;
          solution.s += evaluate(program, layout, system, solution).z;
          residual = evaluate(program, layout, system, solution);
        }
    }



    bool
    is_in_cones(const ConicLayout &layout, const Vector<double> &s)
    {
      for (unsigned int c = 0; c < layout.cones.size(); ++c)
        {
          const auto of_s = layout.cone(s, c);
          if (SecondOrderCone::norm_of_tail(of_s) - of_s[0] >
              Tolerance::cone * layout.scales[c].slack)
            return false;
        }
      return true;
    }



    /// How much of the way from the slacks @p inside the cones to @p s remains
    /// in them; zero if the former are not inside.
    double
    part_in_cones(const ConicLayout    &layout,
                  const Vector<double> &inside,
                  const Vector<double> &s)
    {
      double         inverse = 1.;
      Vector<double> way     = s;
      way -= inside;
      for (unsigned int c = 0; c < layout.cones.size(); ++c)
        {
          const auto of_s = layout.cone(s, c), from = layout.cone(inside, c),
                     to = layout.cone(std::as_const(way), c);
          if (of_s[0] >= SecondOrderCone::norm_of_tail(of_s))
            continue;
          if (!(from[0] > SecondOrderCone::norm_of_tail(from)))
            return 0.;
          inverse = std::max(inverse, SecondOrderCone::inverse_step(from, to));
        }
      return 1. / inverse;
    }
  } // namespace



  KktVector
  evaluate(const ConicProgram &program,
           const ConicLayout  &layout,
           const KktSystem    &system,
           ConicSolution      &solution)
  {
    KktVector residual;
    residual.x.reinit(solution.x.size());
    residual.z.reinit(solution.z.size());
    residual.y = program.right_hand_side;
    residual.z -= solution.s;
    residual.load_factor       = program.live_load.size() > 0 ? 1. : 0.;
    const Vector<double> slope = quadratic_slope(program, layout, solution.x);
    double               quadratic_cost = 0, linear_cost = 0,
           dual_size = residual.load_factor;
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock &block = program.blocks[b];
        for (unsigned int i = 0; i < block.linear_cost.size(); ++i)
          {
            const unsigned int j = layout.unknowns[b] + i;
            residual.x[j]        = -block.linear_cost[i];
            quadratic_cost += solution.x[j] * slope[j];
            linear_cost += solution.x[j] * block.linear_cost[i];
            dual_size = std::max(
              {dual_size, std::abs(slope[j]), std::abs(block.linear_cost[i])});
          }
        for (unsigned int i = 0; i < block.cone_offset.size(); ++i)
          residual.z[layout.rows[b] + i] += block.cone_offset[i];
      }
    const double primal_size = std::max(
      {1.,
       program.right_hand_side.linfty_norm(),
       std::abs(solution.load_factor) * largest_entry(program.live_load)});
    system.subtract_product(residual, solution);

    solution.cost = 0.5 * quadratic_cost + linear_cost - solution.load_factor;
    solution.relative_gap =
      (solution.s * solution.z) /
      std::max(Tolerance::smallest_cost, std::abs(solution.cost));
    solution.primal_error =
      std::max(residual.y.linfty_norm(), residual.z.linfty_norm()) /
      primal_size;
    solution.dual_error =
      std::max(residual.x.linfty_norm(), std::abs(residual.load_factor)) /
      std::max(Tolerance::smallest_cost, dual_size);
    return residual;
  }



  KktSystem::Scalings
  expected_scalings(const ConicLayout &layout)
  {
    KktSystem::Scalings scalings;
    for (unsigned int c = 0; c < layout.cones.size(); ++c)
      {
        const ConeScale   &scale = layout.scales[c];
        const unsigned int size  = layout.cones[c].size;
        const std::array<double, SecondOrderCone::max_size> s = {{scale.slack}};
        const std::array<double, SecondOrderCone::max_size> z = {
          {scale.multiplier}};
        scalings.emplace_back(SecondOrderCone::ConstView(s.data(), size),
                              SecondOrderCone::ConstView(z.data(), size));
      }
    return scalings;
  }



  bool
  make_admissible(const ConicProgram  &program,
                  const ConicLayout   &layout,
                  KktSystem           &system,
                  const ConicSolution &interior,
                  ConicSolution       &solution)
  {
    ConicSolution inside = interior;
    if (!satisfies_equations(solution))
      {
        const auto scalings = expected_scalings(layout);
        if (!system.factorize(scalings))
          throw ConvergenceError("Rounding errors are too large.");
        restore_equations(program, layout, system, inside);
        restore_equations(program, layout, system, solution);
      }
    inside.s += evaluate(program, layout, system, inside).z;
    solution.s += evaluate(program, layout, system, solution).z;

    const double part = part_in_cones(layout, inside.s, solution.s);
    if (part > 0 && part < 1)
      {
        solution.x.sadd(part, 1. - part, inside.x);
        solution.s.sadd(part, 1. - part, inside.s);
        solution.load_factor =
          part * solution.load_factor + (1. - part) * inside.load_factor;
      }
    evaluate(program, layout, system, solution);
    return part > 0 || is_in_cones(layout, solution.s);
  }
} // namespace ElastoPlastic
