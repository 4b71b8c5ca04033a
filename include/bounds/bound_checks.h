// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_bound_checks_h
#define bounds_bound_checks_h

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

#include "material/material.h"

// What can be wrong with bounds of limit loads and errors although each entry
// is right. The rest of it, which shows when a PlaneBody or SpaceBody is put
// together, is listed at LimitLoadAnalysis::check().

namespace ElastoPlastic
{
  using namespace dealii;

  /// All materials must be perfectly plastic. @throws InputError
  void
  check_materials_of_limit_load(const std::vector<Material<double>> &materials);

  /// The indenter must reach a side or a face of the @p body, which is a
  /// PlaneBody or a SpaceBody. @throws InputError
  template <typename Body>
  void
  check_reach_of_indenter(const Body &body);

  /// That stresses cannot press on the @p body anywhere, because the indenter
  /// reaches only parts of its sides or faces; empty if they can.
  template <typename Body>
  std::string
  warning_of_partial_reach(const Body &body);

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
