// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/exceptions.h"
#include "base/process.h"
#include "bounds/conic/conic_evaluation.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/kkt_system.h"
#include "bounds/conic/side_by_side.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int max_iterations = 100;

    /// So many iterations without a better iterate are the last.
    constexpr unsigned int max_idle_iterations = 15;

    /// How much of the way to the boundary of the cones a step goes.
    constexpr double largest_part = 0.99;

    /// So many corrections of centrality at most, of steps that are not long,
    /// until one makes them little longer.
    constexpr unsigned int max_corrections = 2;
    constexpr double       long_step       = 0.9;
    constexpr double       smallest_gain   = 0.03;

    /// So many steps may it take until an iterate is strictly inside the cones.
    constexpr unsigned int max_centerings = 10;

    using SecondOrderCone::ConstView;
    using SecondOrderCone::View;



    /// The iteration of minimize(), in the notation of ConicSolution; W is the
    /// scaling.
    class InteriorPoint
    {
    public:
      InteriorPoint(ConicProgram the_program, const double tolerance)
        : program(std::move(the_program))
        , layout(program)
        , n_cones(layout.cones.size())
        , scales(expected_scales(program, layout))
        , shares(n_cones)
        , tolerance(tolerance)
        , system(program, layout)
      {
        for (unsigned int c = 0; c < n_cones; ++c)
          shares[c] = scales[c].slack * scales[c].multiplier;
        shares /= shares.l1_norm();
        current.x.reinit(layout.unknowns.back());
        current.s.reinit(layout.rows.back());
        current.z.reinit(layout.rows.back());
        current.y.reinit(program.right_hand_side.size());
        scaled = current.z;
        return_free_memory(); // of what the program was made from
      }

      ConicSolution
      run()
      {
        if (program.live_load.size() > 0 &&
            program.live_load.linfty_norm() < Tolerance::smallest_load)
          throw UnboundedError();
        begin();
        while (!converged() && current.n_iterations < max_iterations &&
               current.n_iterations <= best_iteration + max_idle_iterations &&
               step())
          {
            if (termination_requested_here())
              throw TerminationError("Ended on request (SIGTERM).");
            ++current.n_iterations;
            look_at_iterate();
            check_solvability(program, layout, system, current, residual);
          }
        if (best)
          current = *std::exchange(best, std::nullopt);
        current.is_optimal = converged();
        if (interior.x.size() == 0 ||
            current.relative_gap > std::max(tolerance, Tolerance::largest_gap))
          throw ConvergenceError(
            "The interior point method has not converged.");
        const ConicSolution last = current;
        direction                = StepDirection();
        if (!make_admissible(program, layout, system, interior, current))
          {
            center(interior);
            interior = current;
            current  = last;
            make_admissible(program, layout, system, interior, current);
          }
        current.relative_gap = last.relative_gap;
        current.multipliers  = multipliers_of_blocks(layout, current.z);
        return current;
      }

    private:
      // Without the cones and with the expected scales, this is a linear
      // system, s being -W^2 z. Its solution is moved into the cones.
      void
      begin()
      {
        scalings = expected_scalings(layout, scales);
        if (!system.factorize(scalings))
          throw ConvergenceError(
            "The interior point method cannot begin: "
            "rounding errors are too large.");
        residual = evaluate(program, layout, system, current);
        system.solve(current, residual);
        current.s = evaluate(program, layout, system, current).z;
        move_into_cones(current.s, &ConeScale::slack);
        move_into_cones(current.z, &ConeScale::multiplier);
        look_at_iterate();
      }

      /// Adds the same multiple of its expected size, a ConeScale's @p size, to
      /// all cones, so that @p values are inside.
      void
      move_into_cones(Vector<double> &values, const double ConeScale::*size)
      {
        double outside = -std::numeric_limits<double>::max();
        for (unsigned int c = 0; c < n_cones; ++c)
          {
            const ConstView v = layout.cone(std::as_const(values), c);
            outside           = std::max(outside,
                               (SecondOrderCone::norm_of_tail(v) - v[0]) /
                                 (scales[c].*size));
          }
        if (outside >= 0)
          for (unsigned int c = 0; c < n_cones; ++c)
            layout.cone(values, c)[0] += (1. + outside) * (scales[c].*size);
      }

      bool
      converged() const
      {
        return distance_from_solution() <= 1.;
      }

      /// Not more than 1 if the iterate is a solution.
      double
      distance_from_solution() const
      {
        return std::max(current.relative_gap / tolerance,
                        std::max(current.primal_error, current.dual_error) /
                          Tolerance::equations);
      }

      void
      look_at_iterate()
      {
        residual = evaluate(program, layout, system, current);
        if (current.n_iterations == 0 ||
            distance_from_solution() < best_distance)
          {
            best.reset();
            best_distance  = distance_from_solution();
            best_iteration = current.n_iterations;
          }
        if (interior.x.size() == 0 &&
            current.primal_error <= Tolerance::equations)
          interior = current;
      }

      bool
      scale()
      {
        direction = StepDirection(); // The factorisation needs its memory.
        scalings.clear();
        for (unsigned int c = 0; c < n_cones; ++c)
          {
            const ConstView s = layout.cone(std::as_const(current.s), c),
                            z = layout.cone(std::as_const(current.z), c);
            if (!(SecondOrderCone::determinant(s) > 0 &&
                  SecondOrderCone::determinant(z) > 0))
              return false;
            scalings.emplace_back(s, z);
            const View lambda = layout.cone(scaled, c);
            std::copy_n(z.begin(), lambda.size(), lambda.begin());
            scalings[c].multiply(lambda);
          }
        return system.factorize(scalings);
      }

      /// lambda o lambda
      Vector<double>
      square_of_scaled() const
      {
        Vector<double> result(scaled.size());
        for (unsigned int c = 0; c < n_cones; ++c)
          SecondOrderCone::multiply(layout.cone(result, c),
                                    layout.cone(scaled, c),
                                    layout.cone(scaled, c));
        return result;
      }

      /// @return false if rounding errors do not allow another one.
      bool
      step()
      {
        if (!scale())
          return false;

        // The predictor tells how much smaller the gap can become in one step,
        Vector<double> complementarity = square_of_scaled();
        find_direction(complementarity, 1., Tolerance::residual_of_predictor);
        const double centering =
          std::pow(1. - std::min(1., largest_step(layout, scaled, direction)),
                   3);

        // the corrector adds terms of second order, and goes to the central
        // path.
        Vector<double> &scaled_s = direction.scaled_s;
        for (unsigned int c = 0; c < n_cones; ++c)
          {
            const View v = layout.cone(scaled_s, c);
            SecondOrderCone::multiply(
              v, v, layout.cone(std::as_const(direction.scaled_z), c));
          }
        subtract_centre(scaled_s, centering * (current.s * current.z));
        complementarity += scaled_s;
        find_direction(complementarity, 1. - centering, Tolerance::residual);
        const double length = correct_centrality(complementarity, centering);
        if (!best)
          best = current;
        advance(length);
        return true;
      }

      /// Longer steps save factorisations.
      /// @return the largest step.
      double
      correct_centrality(Vector<double> &complementarity,
                         const double    centering)
      {
        double length = largest_step(layout, scaled, direction);
        if (current.relative_gap < Tolerance::smallest_corrected_gap)
          return length;
        Vector<double> targets = shares;
        targets *= centering * (current.s * current.z);
        for (unsigned int k = 0; k < max_corrections && length < long_step; ++k)
          {
            StepDirection last = std::move(direction);
            complementarity -=
              centrality_correction(layout, scaled, last, length, targets);
            find_direction(complementarity,
                           1. - centering,
                           Tolerance::residual);
            const double gain =
              largest_step(layout, scaled, direction) - length;
            if (gain < 0)
              direction = std::move(last);
            else
              length += gain;
            if (gain < smallest_gain)
              break;
          }
        return length;
      }

      /// As far as the cones allow.
      void
      advance(const double longest)
      {
        const double     length = std::min(1., largest_part * longest);
        const KktVector &change = direction.change;
        current.x.add(length, change.x);
        current.y.add(length, change.y);
        current.z.add(length, change.z);
        current.load_factor += length * change.load_factor;
        for (unsigned int c = 0; c < n_cones; ++c)
          scalings[c].multiply(layout.cone(direction.scaled_s, c));
        current.s.add(length, direction.scaled_s);
      }

      // An @p iterate on which the rounding errors of its equations are not
      // small when compared with its slacks goes to the central path, where
      // they are largest, without making the gap smaller.
      void
      center(const ConicSolution &iterate)
      {
        current  = iterate;
        residual = evaluate(program, layout, system, current);
        for (unsigned int k = 0;
             k < max_centerings && current.primal_error > Tolerance::interior &&
             scale();
             ++k)
          {
            Vector<double> complementarity = square_of_scaled();
            subtract_centre(complementarity, current.s * current.z);
            find_direction(complementarity, 1., Tolerance::residual);
            advance(largest_step(layout, scaled, direction));
            residual = evaluate(program, layout, system, current);
          }
      }

      /// Subtracts what lambda o lambda is on the central path with this @p
      /// gap: a multiple of the unit of each cone.
      void
      subtract_centre(Vector<double> &values, const double gap) const
      {
        for (unsigned int c = 0; c < n_cones; ++c)
          layout.cone(values, c)[0] -= gap * shares[c];
      }

      /// Newton's direction for a @p part of the residuals and for
      ///   lambda o (W dz + W^-1 ds) = -complementarity.
      /// @param relative_residual see KktSystem::solve()
      void
      find_direction(const Vector<double> &complementarity,
                     const double          part,
                     const double          relative_residual)
      {
        KktVector right_hand_side = residual;
        right_hand_side.x *= part;
        right_hand_side.y *= part;
        right_hand_side.z *= part;
        right_hand_side.load_factor *= part;

        // W^-1 ds = -(lambda \ complementarity) - W dz
        Vector<double> &scaled_s = direction.scaled_s,
                       &scaled_z = direction.scaled_z;
        scaled_s                 = complementarity;
        scaled_s *= -1.;
        Vector<double> slack = scaled_s;
        for (unsigned int c = 0; c < n_cones; ++c)
          {
            const View quotient = layout.cone(scaled_s, c);
            SecondOrderCone::divide(quotient,
                                    quotient,
                                    layout.cone(std::as_const(scaled), c));
            std::copy_n(quotient.begin(),
                        quotient.size(),
                        layout.cone(slack, c).begin());
            scalings[c].multiply(layout.cone(slack, c));
          }
        right_hand_side.z -= slack;
        system.solve(direction.change,
                     std::move(right_hand_side),
                     relative_residual);

        scaled_z = direction.change.z;
        for (unsigned int c = 0; c < n_cones; ++c)
          scalings[c].multiply(layout.cone(scaled_z, c));
        scaled_s -= scaled_z;
      }

      ConicProgram       program; ///< without blocks, which the system has
      const ConicLayout  layout;
      const unsigned int n_cones;
      const std::vector<ConeScale> scales; ///< of the cones at the beginning
      Vector<double>               shares; ///< of s^T z that the cones may keep
      const double                 tolerance;
      KktSystem                    system;
      KktSystem::Scalings          scalings;

      ConicSolution current;
      ConicSolution interior; ///< far inside the cones, satisfies A x = b
      std::optional<ConicSolution> best; ///< of all, if not the current one
      double                       best_distance  = 0;
      unsigned int                 best_iteration = 0;
      KktVector                    residual;
      Vector<double>               scaled; ///< lambda = W z = W^-1 s
      StepDirection                direction;
    };
  } // namespace



  ConicSolution
  minimize(ConicProgram program, const double tolerance)
  {
    return_large_blocks();
    // Without cones, 0 <= 1 is one: deal.II's vectors may not be empty.
    if (std::all_of(program.blocks.begin(),
                    program.blocks.end(),
                    [](const ConicBlock &block) {
                      return block.cone_sizes.empty();
                    }))
      {
        ConicBlock &block = program.blocks.front();
        block.add_inequality(Vector<double>(block.linear_cost.size()));
        block.cone_offset[0] = 1.;
      }
    InteriorPoint              iteration(std::move(program), tolerance);
    const ExclusiveWork::Pause pause;
    return iteration.run();
  }
} // namespace ElastoPlastic
