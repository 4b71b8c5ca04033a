// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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



    /// @p tolerance relative to the expected size.
    bool
    is_in_cones(const ConicLayout    &layout,
                const Vector<double> &s,
                const double          tolerance)
    {
      for (unsigned int c = 0; c < layout.cones.size(); ++c)
        {
          const auto of_s = layout.cone(s, c);
          if (SecondOrderCone::norm_of_tail(of_s) - of_s[0] >
              tolerance * layout.scales[c].slack)
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



    /// By so much a step is to become longer.
    constexpr double lengthening = 0.3;

    /// The interval of eigenvalues, relative to the target.
    constexpr double smallest = 0.1;
    constexpr double largest  = 10.;



    /// Large eigenvalues are brought down by a limited amount.
    double
    correction(const double eigenvalue, const double target)
    {
      return std::max(std::clamp(eigenvalue,
                                 smallest * target,
                                 largest * target) -
                        eigenvalue,
                      -largest * target);
    }



    /// The vector with the same directions as @p v, and the corrections of its
    /// eigenvalues v_0 + |v_1| and v_0 - |v_1| as its own.
    void
    correct(const SecondOrderCone::View v, const double target)
    {
      const double tail  = SecondOrderCone::norm_of_tail(v);
      const double upper = correction(v[0] + tail, target),
                   lower = correction(v[0] - tail, target);
      v[0]               = 0.5 * (upper + lower);
      for (unsigned int i = 1; i < v.size(); ++i)
        v[i] *= tail > 0 ? 0.5 * (upper - lower) / tail : 0.;
    }
  } // namespace



  KktVector
  evaluate(const ConicProgram &program,
           const ConicLayout  &layout,
           const KktSystem    &system,
           ConicSolution      &solution)
  {
    KktVector residual;
    residual.x = layout.linear_cost;
    residual.x *= -1.;
    residual.z = layout.cone_offset;
    residual.z -= solution.s;
    residual.y                       = program.right_hand_side;
    residual.load_factor             = program.live_load.size() > 0 ? 1. : 0.;
    const Vector<double> slope       = system.quadratic_slope(solution.x);
    const double         dual_size   = std::max({residual.load_factor,
                                                 slope.linfty_norm(),
                                                 layout.linear_cost.linfty_norm()});
    const double         primal_size = std::max(
      {1.,
               program.right_hand_side.linfty_norm(),
               std::abs(solution.load_factor) * largest_entry(program.live_load)});
    system.subtract_product(residual, solution);

    solution.cost = 0.5 * (slope * solution.x) +
                    layout.linear_cost * solution.x - solution.load_factor;
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



  std::vector<ConeScale>
  expected_scales(const ConicProgram &program, const ConicLayout &layout)
  {
    std::vector<ConeScale> scales = layout.scales;
    for (unsigned int b = 0; b < program.expected_multipliers.size(); ++b)
      for (unsigned int c = layout.first_cones[b];
           c < layout.first_cones[b + 1];
           ++c)
        scales[c].multiplier *= program.expected_multipliers[b];
    return scales;
  }



  std::vector<double>
  multipliers_of_blocks(const ConicLayout &layout, const Vector<double> &z)
  {
    std::vector<double> result;
    for (unsigned int b = 0; b + 1 < layout.first_cones.size(); ++b)
      {
        const unsigned int begin = layout.first_cones[b],
                           end   = layout.first_cones[b + 1];
        double sum               = 0;
        for (unsigned int c = begin; c < end; ++c)
          sum += z[layout.cones[c].begin] / layout.scales[c].multiplier;
        result.push_back(begin < end ? sum / (end - begin) : 0.);
      }
    return result;
  }



  KktSystem::Scalings
  expected_scalings(const ConicLayout            &layout,
                    const std::vector<ConeScale> &scales)
  {
    KktSystem::Scalings scalings;
    for (unsigned int c = 0; c < layout.cones.size(); ++c)
      {
        const ConeScale   &scale = scales[c];
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
    const bool is_restored = !satisfies_equations(solution);
    if (is_restored)
      {
        const auto scalings = expected_scalings(layout, layout.scales);
        if (!system.factorize(scalings))
          throw ConvergenceError("Rounding errors are too large.");
        restore_equations(program, layout, system, solution);
      }
    solution.s += evaluate(program, layout, system, solution).z;
    if (is_in_cones(layout, solution.s, 0.))
      {
        evaluate(program, layout, system, solution);
        return true;
      }

    ConicSolution inside = interior;
    if (is_restored)
      restore_equations(program, layout, system, inside);
    inside.s += evaluate(program, layout, system, inside).z;
    const double part = part_in_cones(layout, inside.s, solution.s);
    if (part > 0 && part < 1)
      {
        solution.x.sadd(part, 1. - part, inside.x);
        solution.s.sadd(part, 1. - part, inside.s);
        solution.load_factor =
          part * solution.load_factor + (1. - part) * inside.load_factor;
      }
    evaluate(program, layout, system, solution);
    return part > 0 || is_in_cones(layout, solution.s, Tolerance::cone);
  }



  double
  largest_step(const ConicLayout    &layout,
               const Vector<double> &scaled,
               const StepDirection  &direction)
  {
    double inverse = std::numeric_limits<double>::min();
    for (const auto *const change : {&direction.scaled_s, &direction.scaled_z})
      for (unsigned int c = 0; c < layout.cones.size(); ++c)
        inverse =
          std::max(inverse,
                   SecondOrderCone::inverse_step(layout.cone(scaled, c),
                                                 layout.cone(*change, c)));
    return 1. / inverse;
  }



  Vector<double>
  centrality_correction(const ConicLayout    &layout,
                        const Vector<double> &scaled,
                        const StepDirection  &direction,
                        const double          length,
                        const Vector<double> &targets)
  {
    const double   longer = std::min(1., length + lengthening);
    Vector<double> result = scaled, scaled_z = scaled;
    result.add(longer, direction.scaled_s);
    scaled_z.add(longer, direction.scaled_z);
    for (unsigned int c = 0; c < layout.cones.size(); ++c)
      {
        const auto product = layout.cone(result, c);
        SecondOrderCone::multiply(product,
                                  product,
                                  layout.cone(std::as_const(scaled_z), c));
        correct(product, targets[c]);
      }
    return result;
  }
} // namespace ElastoPlastic
