// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_bound_analysis_h
#define bounds_error_bound_analysis_h

#include <functional>
#include <optional>
#include <string>

#include "bounds/equilibrium_output.h"
#include "bounds/error/error_bound.h"
#include "contact/gap_function.h"
#include "contact_run/guaranteed_error.h"
#include "input/parameters.h"
#include "loading/loading_parameters.h"
#include "loads/boundary_conditions.h"
#include "output/columns.h"
#include "problem/model.h"

namespace ElastoPlastic
{
  /// A guaranteed bound of the error of a contact problem, in one step from the
  /// virgin state: the equilibrium method is run on the mesh of the
  /// displacement method, and the two energies are compared (doc/theory,
  /// "Guaranteed error").
  ///
  /// The mesh is distributed; the conic programs are solved by the first rank.
  template <int dim>
  class ErrorBoundAnalysis : public GuaranteedError<dim>
  {
  public:
    /// All arguments but the first mesh, @p triangulation, must live as long as
    /// this object. Collective.
    /// @throws InputError if materials, mesh or boundary conditions are not
    /// what the equilibrium method can do.
    ErrorBoundAnalysis(const Model<dim>         &model,
                       const Parameters         &parameters,
                       const MPI_Comm            communicator,
                       const GapFunction<dim>   &gap_function,
                       const Triangulation<dim> &triangulation);

    using typename GuaranteedError<dim>::Solution;
    using typename GuaranteedError<dim>::DisplacementAt;

    /// Adds a row to error_bound.csv, too.
    double
    evaluate(const Solution       &solution,
             const DisplacementAt &displacement_at) override;

    const Vector<float> &
    indicators() const override
    {
      return error_indicators;
    }

    const std::string &
    why_missing() const override
    {
      return reason_why_missing;
    }

    /// Those that the last bound has been computed from, to equilibrium-*.vtu.
    void
    write_fields(const unsigned int cycle) override;

  private:
    /// @throws ConvergenceError
    ErrorBoundRow
    find_bound(const Solution &solution);

    StressField<dim>
    equilibrate(const Load &load) const;

    /// Bounds of the force at the given depth, or of the depth under the given
    /// force: slopes of Pi and J, convex functions of it (doc/theory, "Force
    /// between bounds"). Collective.
    void
    bound_load(ErrorBoundRow        &row,
               const Solution       &solution,
               const DisplacementAt &displacement_at);

    /// Pi + J of the displacement method at another @p depth and the stresses
    /// of the last bound; infinite without that displacement. Collective.
    double
    energy_gap_at_depth(const double          depth,
                        const Solution       &solution,
                        const DisplacementAt &displacement_at);

    /// Pi + J of the displacement of the last bound and stresses in equilibrium
    /// with another @p force; infinite if there are none. Collective.
    double
    energy_gap_under_force(const double force, const Solution &solution);

    /// And its parts, on the first rank, which count for the bounds of the
    /// load.
    double
    energy_gap(const QuadraticField<dim> &displacement,
               const double               depth,
               const StressField<dim>    &stress);

    /// What @p function returns there, on all ranks. Collective.
    double
    on_first_rank(const std::function<double()> &function) const;

    const Model<dim>       &model;
    const Parameters       &parameters;
    const MPI_Comm          communicator;
    const GapFunction<dim> &gap_function;
    EquilibriumOutput<dim>  output;

    std::optional<CsvTable<ErrorBoundRow>> table;
    Vector<float>                          error_indicators;
    std::string                            reason_why_missing;

    // On the first rank: the problem on the last mesh, its two solutions, and
    // the parts of the bound.
    SplitBody<dim>      body;
    StressField<dim>    stress;
    QuadraticField<dim> displacement;
    std::vector<double> errors; ///< by simplices
    std::vector<double> errors_of_load;
  };
} // namespace ElastoPlastic

#endif
