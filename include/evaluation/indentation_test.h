// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_indentation_test_h
#define evaluation_indentation_test_h

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "evaluation/tip_on_surface.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The law of an unloading, force = coefficient (depth -
  /// final_depth)^exponent
  /// @cite oliver_pharr_1992, equation (5).
  struct PowerLaw
  {
    /// (The coefficient of a large exponent may be no number of the machine.)
    double log_coefficient;
    double exponent;
    double final_depth;

    /// Its slope at @p depth > final_depth.
    double
    stiffness(const double depth) const
    {
      return exponent *
             std::exp(log_coefficient +
                      (exponent - 1.) * std::log(depth - final_depth));
    }
  };



  /// The law that is closest to pairs of depth and positive force: the sum of
  /// the squares of the relative deviations of the force is smallest (to first
  /// order, since logarithms are compared). There must be at least three
  /// different depths. Final depths are looked for up to a thousand times the
  /// range of the depths below the smallest.
  PowerLaw
  fit_power_law(const std::vector<std::pair<double, double>> &points);



  /// The end of a load step: the columns of history.csv of the same names.
  struct IndentationPoint
  {
    unsigned int step = 0;
    double       time = 0, depth = 0, force = 0, contact_area = 0;
    double       contact_radius = 0, pile_up = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &step &time &depth &force &contact_area &contact_radius &pile_up;
    }
  };



  /// The constants of the evaluation, by which laboratories differ; see the
  /// section "Evaluation".
  struct EvaluationParameters
  {
    /// stiffness = 2 beta E_r sqrt(area / pi)
    double beta = 1;
    /// contact depth = depth - epsilon force / stiffness; 0 stands for that of
    /// the tip.
    double epsilon = 0;
    /// Of the indenter's material: Young's modulus, 0 if it is rigid, and
    /// Poisson's ratio.
    double indenter_modulus = 0, indenter_ratio = 0.07;
    /// Whether the stiffness of a small unloading is found at each step.
    bool continuous_stiffness = false;

    /// (1 - nu^2) / E of the indenter; 0 if it is rigid.
    double
    indenter_compliance() const
    {
      return indenter_modulus > 0. ?
               (1. - indenter_ratio * indenter_ratio) / indenter_modulus :
               0.;
    }

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check() const;
  };



  /// What an unloading says about the material, by the method of
  /// @cite oliver_pharr_1992. Forces, areas and the stiffness are those of the
  /// part of the body that is modelled; hardness and modulus do not depend on
  /// it.
  struct UnloadingResult
  {
    /// Where it begins.
    IndentationPoint maximum;
    PowerLaw         law;
    /// Of the law, at the maximum.
    double stiffness = 0;
    /// How deep the indenter touches, from the first contact (equation (4)).
    double contact_depth = 0;
    /// TipOnSurface::overlapped_area() at this depth, of the modelled part.
    double tip_area = 0;
    /// The part of the indenter that presses on the modelled part.
    double modelled_part = 1;
    double beta          = 1;
    /// EvaluationParameters::indenter_compliance().
    double indenter_compliance = 0;
    /// Of a hold or a jump of the rate instead of an unloading, see RateTest.
    double creep_depth           = std::numeric_limits<double>::quiet_NaN();
    double hold_rate_sensitivity = std::numeric_limits<double>::quiet_NaN();
    double jump_rate_sensitivity = std::numeric_limits<double>::quiet_NaN();

    /// The mean pressure force / @p area at the maximum; 0 without area.
    double
    hardness(const double area) const
    {
      return area > 0 ? maximum.force / area : 0.;
    }

    /// sqrt(pi) stiffness / (2 beta sqrt(area)) of the whole contact, equation
    /// (2); 0 without area. The indenter of the simulation is rigid: with
    /// beta = 1, this is E / (1 - nu^2). The compliance of a real one is added
    /// to its inverse.
    double
    reduced_modulus(const double area) const;
  };



  /// Watches an indentation test, step by step, and evaluates every unloading.
  /// An unloading begins at the last step before depth and force decrease, and
  /// ends at the first step at which they do not. The law is fitted to its
  /// steps between the two shares of the largest force below; with fewer than
  /// three such steps there is no result.
  ///
  /// Where the mesh changes on the way, the indenter does not move, but its
  /// depth or its force jumps. The curve is put together again: what follows is
  /// shifted in depth and scaled in force, which leaves the exponent of the law
  /// alone, to where the curve has been left.
  class IndentationTest
  {
  public:
    static constexpr double lowest_share  = 0.50;
    static constexpr double highest_share = 0.95;

    /// @param tip of the indenter, on the surface.
    /// @param modelled_part of the indenter's surroundings, such as 1/4 in a
    /// quarter model; see modelled_part().
    IndentationTest(const std::shared_ptr<const TipOnSurface> &tip,
                    const double                               modelled_part,
                    const EvaluationParameters                &constants = {});

    /// The modelled part of the indenter's surroundings.
    double
    part_of_surroundings() const
    {
      return modelled_part;
    }

    /// Adds the end of the next step. @return the result of an unloading as
    /// soon as all steps for its fit are there: when the force has fallen below
    /// the lowest share, or else when the unloading has ended. Collective.
    std::optional<UnloadingResult>
    add(const IndentationPoint &point);

    /// The mesh has changed: the end of the last step, @p before, is @p after
    /// on the new one.
    void
    change_mesh(const IndentationPoint &before, const IndentationPoint &after);

    /// What @p stiffness, with which an unloading from @p maximum on begins,
    /// says about the material; without a fitted law. Collective.
    UnloadingResult
    with_stiffness(const IndentationPoint &maximum,
                   const double            stiffness) const;

    /// The test is over. @return the result of an unloading that goes on until
    /// then and has not been returned yet. Collective.
    std::optional<UnloadingResult>
    finish();

    /// What this object remembers.
    struct Progress
    {
      /// The last maximum and the steps of the unloading from there, as if the
      /// mesh had not changed since the maximum.
      std::vector<IndentationPoint> unloading;
      bool                          evaluated = false;
      /// What brings the next point to this mesh.
      double depth_shift = 0;
      double force_scale = 1;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &unloading &evaluated &depth_shift &force_scale;
      }
    };

    /// For checkpoints.
    const Progress &
    progress() const
    {
      return memory;
    }

    void
    resume(const Progress &progress)
    {
      memory = progress;
    }

  private:
    std::optional<UnloadingResult>
    evaluate();

    std::shared_ptr<const TipOnSurface> tip;
    double                              modelled_part;
    EvaluationParameters                constants;

    Progress memory;
  };
} // namespace ElastoPlastic

#endif
