// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_columns_h
#define output_columns_h

#include <cmath>
#include <iosfwd>
#include <limits>

#include "evaluation/imprint.h"
#include "evaluation/indentation_test.h"
#include "evaluation/solve_result.h"
#include "output/output_parameters.h"
#include "output/table.h"

#include <mpi.h>

namespace ElastoPlastic
{
  /// The equilibria on the old and the new mesh under the same load; plastic
  /// work and dissipation of the second one are those of the way to it.
  struct MeshChange
  {
    const SolveResult &before;
    const SolveResult &after;
  };

  /// A row of limit_load.csv.
  struct LimitLoadRow
  {
    unsigned int cycle;
    unsigned int cells, triangles;
    double       lower_bound, upper_bound;
    unsigned int lower_iterations, upper_iterations;
    double       stress_error, velocity_error;
    double       wall_seconds;

    /// Not a number as long as the lower bound is zero.
    double
    relative_difference() const
    {
      return lower_bound == 0. ?
               std::numeric_limits<double>::quiet_NaN() :
               (upper_bound - lower_bound) / std::abs(lower_bound);
    }
  };



  /// A row of error_bound.csv.
  struct ErrorBoundRow
  {
    struct Interval
    {
      double lower, upper;
    };


    unsigned int            cycle;
    unsigned int            cells;
    types::global_dof_index dofs;
    unsigned int            triangles;
    double                  depth, force;
    double                  equilibrium_depth, equilibrium_force;
    double                  equilibrium_max_pressure, equilibrium_contact_area;
    double                  complementary_energy;
    double                  bound_of_body, bound_of_contact;
    unsigned int            iterations;
    double                  stress_error;
    double                  wall_seconds;
    Interval                force_bounds, depth_bounds;

    double
    bound() const
    {
      return bound_of_body + bound_of_contact;
    }
  };



  /// The columns of statistics.csv: a row per nonlinear solve.
  const Columns<SolveResult> &
  statistics_columns();

  /// The columns of history.csv: a row per converged load step.
  const Columns<SolveResult> &
  history_columns();

  /// The columns of surface_profile.csv in @p dimension dimensions: a row per
  /// point of the contact surface.
  const Columns<SurfaceRow> &
  surface_profile_columns(const unsigned int dimension);

  /// The columns of mesh_changes.csv: a row per change of the mesh.
  const Columns<MeshChange> &
  mesh_change_columns();

  /// The columns of indentation.csv: a row per unloading, hold or jump of the
  /// rate.
  const Columns<UnloadingResult> &
  indentation_columns();

  /// The columns of continuous_stiffness.csv: a row per converged load step
  /// whose UnloadingStiffness has been found.
  const Columns<UnloadingResult> &
  continuous_stiffness_columns();

  /// The columns of limit_load.csv: a row per mesh.
  const Columns<LimitLoadRow> &
  limit_load_columns();

  /// The columns of error_bound.csv: a row per mesh.
  const Columns<ErrorBoundRow> &
  error_bound_columns();



  /// Writes what the columns of all tables are, and in which @p units, as a
  /// page (Markdown): doc/lookup/tables.md, if they have no names.
  void
  print_table_reference(std::ostream &out, const Units &units);



  /// Writes this page to the file tables.md in the output directory if the
  /// user has named the units. Collective. @throws FileError
  void
  write_table_reference(const MPI_Comm          communicator,
                        const OutputParameters &parameters);
} // namespace ElastoPlastic

#endif
