// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <memory>

#include "base/exceptions.h"
#include "equilibrium/hencky_material.h"
#include "limit_load_analysis.h"
#include "loading/load_program.h"
#include "safe_load.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The search begins on a coarse mesh, and refines few cells at a time.
    constexpr types::global_cell_index max_initial_cells = 150;



    bool
    has_limit_load(const Parameters &parameters)
    {
      const auto materials = parameters.material.materials();
      return parameters.dimension == 2 &&
             parameters.discretization.kinematics != Kinematics::axisymmetric &&
             parameters.indenter.type != "none" &&
             parameters.boundary_conditions.traction.empty() &&
             std::all_of(materials.begin(), materials.end(), is_perfect) &&
             std::all_of(materials.begin(),
                         materials.end(),
                         HenckyMaterial::yields);
    }



    /// At the ends of the segments of the load history, and of its steps.
    double
    largest_force(const LoadingParameters &parameters)
    {
      const LoadProgram   program(parameters);
      std::vector<double> times = program.segment_ends();
      for (unsigned int step = 1; step < parameters.n_steps; ++step)
        times.push_back(program.final_time() * step / parameters.n_steps);

      double largest = 0;
      for (const double time : times)
        {
          const Load load = program.load(time);
          if (load.control == Control::force)
            largest = std::max(largest, load.value);
        }
      return largest;
    }



    std::unique_ptr<LimitLoadAnalysis>
    make_analysis(Parameters parameters, const MPI_Comm communicator)
    {
      parameters.refinement                     = RefinementParameters();
      parameters.refinement.refinement_fraction = 0.1;
      while (true)
        {
          auto analysis =
            std::make_unique<LimitLoadAnalysis>(parameters, communicator);
          if (parameters.geometry.initial_refinements == 0 ||
              analysis->n_cells() <= max_initial_cells)
            return analysis;
          --parameters.geometry.initial_refinements;
        }
    }
  } // namespace



  // A body from which the indenter cannot displace material has no limit load.
  void
  require_safe_load(const Parameters &parameters, const MPI_Comm communicator)
  {
    const double force = largest_force(parameters.loading);
    if (force <= 0 || !has_limit_load(parameters))
      return;
    try
      {
        make_analysis(parameters, communicator)->require_safe(force);
      }
    catch (const ConvergenceError &)
      {}
  }
} // namespace ElastoPlastic
