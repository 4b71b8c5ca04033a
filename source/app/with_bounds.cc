// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "app/bounds.h"
#include "base/compatibility.h"
#include "base/exceptions.h"
#include "bounds/error_bound_analysis.h"
#include "bounds/limit_load_analysis.h"
#include "bounds/mesh/split_mesh.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The search begins on a coarse mesh, and refines few cells at a time.
    constexpr types::global_cell_index max_initial_cells = 150;



    Parameters
    with_refinement_of_few_cells(const Parameters &parameters)
    {
      Parameters result                     = parameters;
      result.refinement                     = RefinementParameters();
      result.refinement.refinement_fraction = 0.1;
      if (result.output.screen == Verbosity::summary)
        result.output.screen = Verbosity::quiet; // a table of load steps
      return result;
    }



    // What the conic programs cannot find says nothing about the force: the
    // body may be enclosed and have no limit load at all, or have no mechanism
    // that bounds it; the rounding errors may be too large. Nor does it if the
    // equilibrium method does not know a load. Then it is for the load steps to
    // find out.
    template <typename Look>
    std::string
    reason_without_bounds(const Look &look)
    {
      try
        {
          look();
          return "";
        }
      catch (const ConvergenceError &error)
        {
          return error.what();
        }
      catch (const InputError &error)
        {
          return error.what();
        }
    }
  } // namespace



  template <int dim>
  void
  StrictBounds<dim>::find_limit_load(const Model<dim> &model,
                                     const Parameters &parameters,
                                     const MPI_Comm    communicator,
                                     const bool        overwrite)
  {
    LimitLoadAnalysis(model, parameters, communicator).run(overwrite);
  }



  template <int dim>
  types::global_cell_index
  StrictBounds<dim>::check_limit_load(const Model<dim> &model,
                                      const Parameters &parameters,
                                      const MPI_Comm    communicator)
  {
    LimitLoadAnalysis analysis(model, parameters, communicator);
    analysis.check();
    return analysis.n_cells();
  }



  template <int dim>
  std::unique_ptr<GuaranteedError<dim>>
  StrictBounds<dim>::make_error_bound(const DiscreteBody<dim> &body,
                                      const Parameters        &parameters,
                                      Log                     &log)
  {
    auto bound =
      std::make_unique<ErrorBoundAnalysis<dim>>(body.model,
                                                parameters,
                                                communicator_of(
                                                  body.triangulation()),
                                                body.gap_function(),
                                                body.triangulation());
    if (const std::string warning =
          warning_of_curved_body(body.triangulation());
        !warning.empty())
      log.warn(warning);
    return bound;
  }



  template <int dim>
  void
  StrictBounds<dim>::require_safe_load(const Model<dim> &model,
                                       const Parameters &parameters,
                                       const MPI_Comm    communicator)
  {
    const auto load = load_in_question(model, parameters);
    if (!load)
      return;

    const Model<dim>  coarse_model = model.with_few_cells(max_initial_cells);
    const Parameters  few_cells    = with_refinement_of_few_cells(parameters);
    const std::string reason       = reason_without_bounds([&]() {
      LimitLoadAnalysis(coarse_model, few_cells, communicator)
        .require_safe(*load);
    });
    if (!reason.empty())
      Log(communicator, Verbosity::quiet)
        .warn("There is no bound of the limit load to compare " +
              load->in_words() + " with. " + reason +
              " The load is applied all the same; beyond a limit load, it "
              "finds no equilibrium.");
  }



  template <int dim>
  std::string
  StrictBounds<dim>::first_look_at_load(const Model<dim> &model,
                                        const Parameters &parameters,
                                        const MPI_Comm    communicator)
  {
    const auto load = load_in_question(model, parameters);
    if (!load)
      return "";

    const Model<dim>  coarse_model = model.with_few_cells(max_initial_cells);
    const Parameters  few_cells    = with_refinement_of_few_cells(parameters);
    bool              is_safe      = false;
    const std::string reason       = reason_without_bounds([&]() {
      is_safe = LimitLoadAnalysis(coarse_model, few_cells, communicator)
                  .is_safe_at_first_sight(*load);
    });
    if (!reason.empty())
      return "there is no bound to compare " + load->in_words() + " with. " +
             reason;
    return is_safe ? load->in_words() + " is below the limit load" :
                     "a coarse mesh does not tell whether " + load->in_words() +
                       " is below it; the run begins with finding out";
  }



  template struct StrictBounds<2>;
  template struct StrictBounds<3>;
} // namespace ElastoPlastic
