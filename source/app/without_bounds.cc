// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "app/bounds.h"
#include "base/exceptions.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    [[noreturn]] void
    reject_analysis(const Parameters &parameters)
    {
      throw InputError(
        "Analysis",
        parameters.analysis == Analysis::limit_load ?
          "limit load" :
          "contact with error bound",
        "this program was built without the bounds of limit loads and errors. "
        "Build it with CMake's '-DSTRICT_BOUNDS=ON', which needs CHOLMOD and "
        "OpenMP, or choose 'Analysis = contact'.");
    }
  } // namespace



  template <int dim>
  void
  StrictBounds<dim>::find_limit_load(const Model<dim> &,
                                     const Parameters &parameters,
                                     const MPI_Comm,
                                     const bool)
  {
    reject_analysis(parameters);
  }



  template <int dim>
  types::global_cell_index
  StrictBounds<dim>::check_limit_load(const Model<dim> &,
                                      const Parameters &parameters,
                                      const MPI_Comm)
  {
    reject_analysis(parameters);
  }



  template <int dim>
  std::unique_ptr<GuaranteedError<dim>>
  StrictBounds<dim>::make_error_bound(const DiscreteBody<dim> &,
                                      const Parameters &parameters,
                                      Log &)
  {
    reject_analysis(parameters);
  }



  template <int dim>
  void
  StrictBounds<dim>::require_safe_load(const Model<dim> &model,
                                       const Parameters &parameters,
                                       const MPI_Comm    communicator)
  {
    if (const auto load = load_in_question(model, parameters))
      Log(communicator, Verbosity::quiet)
        .warn(
          "This program was built without the bounds of limit loads "
          "(CMake's STRICT_BOUNDS): " +
          load->in_words() +
          " is not compared with them. The load is applied all the same; "
          "beyond a limit load, it finds no equilibrium.");
  }



  template <int dim>
  std::string
  StrictBounds<dim>::first_look_at_load(const Model<dim> &model,
                                        const Parameters &parameters,
                                        const MPI_Comm)
  {
    const auto load = load_in_question(model, parameters);
    return load ? "not compared with " + load->in_words() +
                    ": this program was built without its bounds" :
                  "";
  }



  template struct StrictBounds<2>;
  template struct StrictBounds<3>;
} // namespace ElastoPlastic
