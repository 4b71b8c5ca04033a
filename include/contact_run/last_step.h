// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_last_step_h
#define contact_run_last_step_h

#include <optional>
#include <utility>

#include "evaluation/solve_result.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  /// The equilibrium at the end of the last load step, which the next one
  /// begins with, how fast things have changed on the way there, and how large
  /// they have been until now. The displacement is empty in the virgin state,
  /// as are all vectors without an initial stress.
  struct LastStep
  {
    SolveResult result;
    VectorType  displacement;
    /// The nodal forces in equilibrium with the stresses; in the virgin state
    /// with the initial one, if there is one.
    VectorType forces;
    VectorType displacement_rate;
    /// How far the surface has slipped along the indenter.
    VectorType slip;
    double     depth_rate = 0, force_rate = 0;
    /// How much plastic work and dissipation the step has added.
    double plastic_work_increment = 0, dissipation_increment = 0;
    double duration = 0;
    /// Its error, measured in what accurate steps allow.
    double    step_error = 1;
    MeanForce mean_force;

    /// Of the whole history: the largest sum of the magnitudes of all nodal
    /// forces, which small ones are measured against; and the largest contact
    /// area.
    double largest_forces       = 0;
    double largest_contact_area = 0;
    double largest_depth = 0, largest_force = 0, largest_displacement = 0;

    bool
    is_virgin() const
    {
      return displacement.size() == 0;
    }

    /// Whether the indenter ever has.
    bool
    has_touched() const
    {
      return largest_contact_area > 0.;
    }

    /// Whether no contact @p area until now is larger, but for rounding: that
    /// of a hold stays as it is.
    bool
    is_largest(const double area) const
    {
      constexpr double rounding = 1e-9;
      return area >= (1. - rounding) * largest_contact_area;
    }

    /// The work of the nodal forces on the way from here to @p new_displacement
    /// and @p new_forces, by the trapezoidal rule. Collective.
    double
    work_to(const VectorType &new_displacement,
            const VectorType &new_forces) const
    {
      double work = 0.5 * (new_forces * new_displacement);
      if (!is_virgin())
        work += 0.5 * (forces * new_displacement - new_forces * displacement -
                       forces * displacement);
      else if (forces.size() > 0)
        work += 0.5 * (forces * new_displacement);
      return work;
    }

    /// Adds to @p next what has been summed up until now. What material points
    /// have done is counted from states that have been extrapolated by this
    /// part, @p weight, of their last increments: so are its sums.
    void
    add_to(SolveResult &next, const double weight) const
    {
      next.plastic_work +=
        result.plastic_work + weight * plastic_work_increment;
      next.dissipation += result.dissipation + weight * dissipation_increment;
      next.external_work += result.external_work;
      next.frictional_dissipation += result.frictional_dissipation;
    }

    /// By how much @p next, with @p new_displacement, deviates from what the
    /// rates until now would have led to: the part of it that is the local
    /// error of the implicit Euler method with steps of different lengths,
    /// relative to the largest values until now; at most 1e6. Of what follows
    /// where the other is given by the @p control of the indenter, force or
    /// depth; without an indenter, of the displacement. For a step that
    /// continues the last one. Collective.
    double
    deviation_from_rates(const SolveResult            &next,
                         const VectorType             &new_displacement,
                         const std::optional<Control> &control) const
    {
      const double step      = next.time - result.time;
      const auto   deviation = [&]() -> std::pair<double, double> {
        if (control == Control::depth)
          return {std::abs(next.force - result.force - step * force_rate),
                  largest_force};
        if (control == Control::force)
          return {std::abs(next.depth - result.depth - step * depth_rate),
                  largest_depth};
        VectorType difference = new_displacement;
        difference.sadd(1., -1., displacement);
        difference.add(-step, displacement_rate);
        return {difference.linfty_norm(), largest_displacement};
      };
      const auto [difference, largest] = deviation();
      const double part                = step / (step + duration);
      return part * std::min(difference / std::max(largest, 1e-300), 1e6);
    }

    /// Notes how fast @p next, with @p new_displacement, has been reached, and
    /// what its step has added to what add_to() has summed up.
    void
    find_rates(const SolveResult &next, const VectorType &new_displacement)
    {
      plastic_work_increment = next.plastic_work - result.plastic_work;
      dissipation_increment  = next.dissipation - result.dissipation;

      duration      = next.time - result.time;
      depth_rate    = (next.depth - result.depth) / duration;
      force_rate    = (next.force - result.force) / duration;
      largest_depth = std::max(largest_depth, std::abs(next.depth));
      largest_force = std::max(largest_force, std::abs(next.force));
      largest_displacement =
        std::max(largest_displacement, new_displacement.linfty_norm());
      displacement_rate = new_displacement;
      if (!is_virgin())
        displacement_rate -= displacement;
      displacement_rate /= duration;
    }

    /// What is not a vector, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &result &depth_rate &force_rate &plastic_work_increment
        &dissipation_increment &duration &step_error &mean_force &largest_forces
          &largest_contact_area &largest_depth &largest_force
            &largest_displacement;
    }
  };
} // namespace ElastoPlastic

#endif
