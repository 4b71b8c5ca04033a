// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_load_history_h
#define problem_load_history_h

#include <optional>
#include <string>
#include <vector>

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
} // namespace ElastoPlastic

#endif
