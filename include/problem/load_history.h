// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_load_history_h
#define problem_load_history_h

#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "evaluation/rate_test.h"
#include "input/parameters.h"
#include "loading/load_program.h"
#include "loading/time_steps.h"
#include "problem/model.h"

// What the load steps of a Model are, of which the load program is a part:
// prescribed displacements, tractions and body forces depend on time, too.

namespace ElastoPlastic
{
  /// Whether there are others than that of the indenter.
  template <int dim>
  bool
  has_other_loads(const Model<dim> &model);



  /// The load steps that @p parameters ask for. Adaptive steps end where fixed
  /// ones do if something may turn there.
  template <int dim>
  TimeSteps
  make_time_steps(const Model<dim> &model, const Parameters &parameters);



  /// Watches how hardness depends on the rate, if a material has a rate law, in
  /// the segments of the @p loading of @p model; corners of its path divide
  /// none.
  template <int dim>
  std::optional<RateTest>
  make_rate_test(const Model<dim> &model, const LoadingParameters &loading);



  /// What to say of the segments of the load history in which nothing changes,
  /// in full sentences: no material depends on rates.
  template <int dim>
  std::vector<std::string>
  remarks_on_holds(const Model<dim> &model);



  /// The largest depth or force that is prescribed at the ends of @p steps;
  /// none if it is never prescribed, or not known in advance.
  std::optional<double>
  largest_load(const LoadProgram &load_program,
               TimeSteps          steps,
               const Control      control);



  /// What may be beyond a limit load: a force of the indenter, or the largest
  /// of the tractions and body forces at some times.
  struct LoadInQuestion
  {
    double              force = 0; ///< 0 if it is the other loads
    std::vector<double> times;     ///< none if it is the force

    std::string
    in_words() const
    {
      return times.empty() ? "the force " + to_text(force) :
                             "the largest load of tractions and body forces";
    }
  };



  /// The load that Johnson's condition of a safe load is about, (1.14) in
  /// @cite johnson_1978, and that the equilibrium method can compare with a
  /// limit load in short time, in two dimensions: the largest force that is
  /// prescribed, or if there is no indenter, the largest of the tractions and
  /// body forces. None if there is no such load, or no limit load: with
  /// friction, hardening, finite strains. A force that a depth has reached, and
  /// from which the next segment begins, is safe.
  template <int dim>
  std::optional<LoadInQuestion>
  load_in_question(const Model<dim> &model, const Parameters &parameters);
} // namespace ElastoPlastic

#endif
