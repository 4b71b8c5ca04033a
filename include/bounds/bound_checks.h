// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_bound_checks_h
#define bounds_bound_checks_h

#include <string>
#include <vector>

#include "bounds/body/split_body.h"

// What can be wrong with bounds of limit loads and errors although each entry
// is right. The rest of it, which shows when a SplitBody is put together, is
// listed at LimitLoadAnalysis::check().

namespace ElastoPlastic
{
  using namespace dealii;

  /// All materials must be perfectly plastic. @throws InputError
  void
  check_materials_of_limit_load(const std::vector<Material<double>> &materials);

  /// The indenter must reach a face of the @p body. @throws InputError
  template <int dim>
  void
  check_reach_of_indenter(const SplitBody<dim> &body);

  /// That stresses cannot press on the @p body anywhere, because the indenter
  /// reaches only parts of its faces; empty if they can.
  template <int dim>
  std::string
  warning_of_partial_reach(const SplitBody<dim> &body);

  /// Whether the loads that do not grow are too much for the body, if the load
  /// factor is between these bounds; empty if not.
  std::string
  warning_of_constant_loads(const double lower_bound, const double upper_bound);

  /// That the mesh is not the body; empty if the boundary is not curved.
  template <int dim>
  std::string
  warning_of_curved_body(const Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
