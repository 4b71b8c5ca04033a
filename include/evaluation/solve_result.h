// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_solve_result_h
#define evaluation_solve_result_h

#include <boost/serialization/base_object.hpp>

#include <limits>

#include "contact/contact_state.h"
#include "mechanics/body_state.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What one nonlinear solve has found: a row of statistics.csv and, in part,
  /// of the table on the screen. Units are those of the input.
  struct SolveResult : ContactState, BodyState
  {
    unsigned int            step              = 0;
    double                  time              = 0;
    unsigned int            cycle             = 0;
    types::global_dof_index cells             = 0;
    types::global_dof_index dofs              = 0;
    unsigned int            newton_iterations = 0;
    unsigned int            linear_iterations = 0;
    double                  depth             = 0;
    /// See contact_radius() and pile_up().
    double contact_radius = 0;
    double pile_up        = 0;
    /// See worst_element(); measured with finite strains only
    double min_scaled_jacobian = 1;
    double residual            = 0;
    double energy              = 0;
    /// |force - reaction of the supports - tractions| / the largest sum of the
    /// magnitudes of all nodal forces so far
    double force_balance_error = 0;
    /// not a number if it has not been computed
    double estimated_error = std::numeric_limits<double>::quiet_NaN();
    double wall_seconds    = 0;
    /// peak, all ranks together
    double memory_mb = 0;
    /// of the indenter, the supports and the tractions since the virgin state,
    /// once the step has been committed
    double external_work = 0;
    /// See MeanForce; not a number where nothing has entered or left.
    double mean_depth = std::numeric_limits<double>::quiet_NaN();
    double mean_force = std::numeric_limits<double>::quiet_NaN();
    /// See UnloadingStiffness; not a number if it has not been computed.
    double contact_stiffness = std::numeric_limits<double>::quiet_NaN();

    /// (But for the estimated error, which belongs to one mesh, and the means
    /// and the contact stiffness, which belong to one step.)
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &boost::serialization::base_object<ContactState>(*this);
      archive &boost::serialization::base_object<BodyState>(*this);
      archive &step &time &cycle &cells &dofs &newton_iterations
        &linear_iterations &depth &contact_radius &pile_up &min_scaled_jacobian
          &residual &energy &force_balance_error &wall_seconds &memory_mb
            &external_work;
    }
  };
} // namespace ElastoPlastic

#endif
