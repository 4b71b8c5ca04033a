// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_mesh_adaptation_h
#define contact_run_mesh_adaptation_h

#include "adaptivity/refinement.h"
#include "contact_run/discrete_body.h"
#include "contact_run/last_step.h"
#include "output/log.h"

namespace ElastoPlastic
{
  /// Decides when there is to be another mesh, and flags the cells for it: by
  /// the errors of the solution (RefinementParameters), and so that enough
  /// elements lie over the radius of the contact.
  ///
  /// All functions are collective.
  template <int dim>
  class MeshAdaptation
  {
  public:
    /// The present mesh of @p body is the first: its cells stay. All arguments
    /// must outlive this object. @throws InputError if that mesh is too large.
    MeshAdaptation(const RefinementParameters &parameters,
                   DiscreteBody<dim>          &body,
                   Log                        &log);

    /// The smallest gap under the indenter that contact can begin with: that of
    /// a node which can touch, or, since the mesh follows an indenter that has
    /// entered it, of any node.
    double
    min_gap() const;

    /// Whether load step @p step is to be solved on another mesh after that
    /// with the number @p cycle: the first step is, on a sequence of meshes.
    bool
    mark_in_step(const unsigned int step, const unsigned int cycle);

    /// Whether the mesh in or after load step @p step depends on the errors of
    /// its solution.
    bool
    needs_errors(const unsigned int step) const
    {
      return step == 1 || is_due(step);
    }

    /// Whether the mesh is to change after @p last_step.
    bool
    mark_after(const LastStep &last_step);

    /// Whether it is to change again: the indenter has entered the body but
    /// touches nothing yet.
    bool
    mark_until_touched(const LastStep &last_step);

    /// Whether the errors of the solution may change the mesh after load step
    /// @p step.
    bool
    is_due(const unsigned int step) const;

  private:
    /// Whether the indenter is in the body and has not touched it.
    bool
    enters_untouched(const LastStep &last_step) const
    {
      return parameters.n_over_contact_radius > 0 && !last_step.has_touched() &&
             !body.contact_zone().spots().empty();
    }

    bool
    mark_contact_zone(const unsigned int step);

    bool
    next_mesh_is_allowed() const;

    /// The same of a mesh that is to follow the contact after load step
    /// @p step. The first time that it may not, the user is warned.
    bool
    may_follow_contact(const unsigned int step);

    const RefinementParameters &parameters;
    DiscreteBody<dim>          &body;
    Log                        &log;
    const int                   finest_first_level;
    bool                        has_stopped_following = false;
  };
} // namespace ElastoPlastic

#endif
