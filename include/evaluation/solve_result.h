// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_solve_result_h
#define evaluation_solve_result_h

#include <boost/serialization/base_object.hpp>

#include <limits>

#include "contact/contact_state.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// What has happened inside the body, of all ranks together.
  struct BodyState
  {
    /// Of the quadrature points that have yielded.
    double plastic_volume                = 0;
    double max_equivalent_plastic_strain = 0;
    double elastic_energy                = 0;
    /// What hardening has stored.
    double hardening_energy = 0;
    /// Since the last commit() of the body. In a SolveResult that has been
    /// committed: since the virgin state.
    double plastic_work = 0;
    double dissipation  = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &plastic_volume &max_equivalent_plastic_strain &elastic_energy
        &hardening_energy &plastic_work &dissipation;
    }
  };



  /// That of @p solid with the @p displacement. Collective.
  template <int dim>
  BodyState
  body_state(const SolidOperator<dim> &solid, const VectorType &displacement);



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



  /// The force of the indenter as the derivative of its work with respect to
  /// the depth, from one entry of nodes into the contact to the next: a force
  /// on a mesh waves with a period of one entry, and over a period waves
  /// cancel (doc/theory, "The edge of the contact").
  class MeanForce
  {
  public:
    /// Goes on to the end of a load step, @p result. If nodes have entered or
    /// left in it, @p result gets the mean force since this happened last, or
    /// since the indenter turned back, and the depth in the middle; the work
    /// is that of the trapezoidal rule.
    void
    add(SolveResult &result);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &depth &force &active_nodes &first_depth &work;
    }

  private:
    /// At the end of the last step.
    double                  depth        = 0;
    double                  force        = 0;
    types::global_dof_index active_nodes = 0;

    /// Where the mean begins, and the work since then.
    double first_depth = 0;
    double work        = 0;
  };
} // namespace ElastoPlastic

#endif
