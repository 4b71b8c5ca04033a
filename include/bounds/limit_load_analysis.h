// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_limit_load_analysis_h
#define bounds_limit_load_analysis_h

#include <deal.II/distributed/tria.h>

#include <functional>
#include <string>
#include <vector>

#include "bounds/equilibrium_output.h"
#include "bounds/limit_load.h"
#include "contact/gap_function.h"
#include "input/parameters.h"
#include "output/columns.h"
#include "output/log.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  /// The largest force that an indenter can exert on a body of perfectly
  /// plastic materials, or the largest factor of its other loads, between two
  /// rigorous bounds: that of stresses in exact equilibrium, which are safe,
  /// and that of a mechanism of collapse (doc/theory, "Limit loads"). The
  /// mesh is refined where the two fields disagree.
  ///
  /// The mesh is distributed; the conic programs are solved by the first rank.
  template <int dim>
  class LimitLoadAnalysis
  {
  public:
    /// Builds the mesh and checks what can be checked before anything is
    /// computed. @p model and @p parameters must outlive this object.
    /// @throws InputError
    LimitLoadAnalysis(const Model<dim> &model,
                      const Parameters &parameters,
                      const MPI_Comm    communicator);

    /// What run() looks at before it computes anything, and before results are
    /// gone: that the indenter reaches the body; that it stands on level sides
    /// if it is rough; that loads which are to grow are there, and linear
    /// functions of the time; that body forces are the same everywhere; in
    /// space, that tractions and displacements are linear on faces, and that
    /// cells can be cut into tetrahedra. Says whether the body is curved, and
    /// whether the indenter reaches no side as a whole.
    /// @throws InputError
    void
    check();

    /// Computes the bounds on all meshes, and writes limit_load.csv and the
    /// fields to the output directory. @p overwrite allows to replace earlier
    /// ones. @throws ConvergenceError, FileError, TerminationError, which say
    /// the last bounds
    void
    run(const bool overwrite);

    /// Refines the mesh until it is decided whether the body can bear the
    /// @p load, or until there are many cells. Writes no files.
    /// @throws EquilibriumError if it cannot, or if that remains undecided.
    void
    require_safe(const LoadInQuestion &load);

    /// Whether the @p load is below the lower bound on the first mesh. Writes
    /// no files. @throws EquilibriumError if it is not below the upper one.
    bool
    is_safe_at_first_sight(const LoadInQuestion &load);

    types::global_cell_index
    n_cells() const
    {
      return triangulation.n_global_active_cells();
    }

  private:
    void
    setup_body();

    /// Of the bounds of the mesh before, relative; 1 if there is none.
    double
    last_difference() const
    {
      return cycle == 0 || row.lower_bound == 0. ? 1. :
                                                   row.relative_difference();
    }

    void
    find_bounds();

    /// If the last bounds are not the best ones of their mesh.
    void
    warn_of_rounding_errors();

    void
    find_bounds_or_say_last();

    void
    let_grow(const LoadInQuestion &load);

    /// Whether the load is below the last lower bound.
    /// @throws EquilibriumError if it is not below the upper one.
    bool
    is_safe(const LoadInQuestion &load) const;

    /// The last bounds, and what to do.
    std::string
    bounds_in_words(const LoadInQuestion &load) const;

    void
    write_results(CsvTable<LimitLoadRow> &table);

    bool
    is_last_cycle() const
    {
      return cycle + 1 >= parameters.refinement.n_cycles;
    }

    void
    refine_mesh();

    const Model<dim> &model;
    const Parameters &parameters;
    const MPI_Comm    communicator;
    const bool        first_rank;

    Log                    log;
    EquilibriumOutput<dim> output;
    SlipOutput<dim>        slip_output;
    unsigned int           cycle = 0;

    parallel::distributed::Triangulation<dim> triangulation;
    const GapFunction<dim>                    gap_function;

    /// Which tractions and body forces are there, and grow.
    std::function<Loads<dim>(const SplitMesh<dim> &)> loads;

    // On the first rank: the problem on the present mesh, and its solution.
    SplitBody<dim>      body;
    LimitLoad<dim>      bounds;
    ExpectedMultipliers expected;

    // On all ranks: what limit_load.csv says of it.
    LimitLoadRow row = {};
  };
} // namespace ElastoPlastic

#endif
