// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/solution_transfer.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

#include "base/termination.h"
#include "elasto_plastic_contact.h"
#include "mechanics/ghosted_copy.h"
#include "mechanics/state_transfer.h"

namespace ElastoPlastic
{
  template <int dim>
  template <typename Archive>
  void
  ElastoPlasticContact<dim>::serialize_progress(Archive              &archive,
                                                Statistics::Progress &progress)
  {
    archive &time_steps &load_program &field_output &cycle &last_step
      &depth_rate &largest_forces &progress;
  }



  // What the next load step begins with: the mesh, to whose cells the fields
  // are attached, and where the history is.
  template <int dim>
  void
  ElastoPlasticContact<dim>::save_checkpoint(Statistics::Progress progress)
  {
    TimerOutput::Scope scope(timer, "Checkpoint");

    std::ostringstream            state;
    boost::archive::text_oarchive archive(state);
    serialize_progress(archive, progress);

    VectorType response = tangent_solver->known_response();
    if (response.size() == 0)
      solid->initialize_vector(response);
    const GhostedCopies<dim> fields({&committed_displacement,
                                     &displacement_rate,
                                     &committed_forces,
                                     &response},
                                    dof_handler);

    checkpoint.save(state.str(), [&](const std::string &mesh_file) {
      parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
        dof_handler);
      transfer.prepare_for_serialization(fields.pointers());
      const CellStates   states = solid->states();
      StateTransfer<dim> state_transfer(triangulation,
                                        fe.degree,
                                        model.materials.size());
      state_transfer.prepare(states);
      triangulation.save(mesh_file);
    });
  }



  template <int dim>
  Statistics::Progress
  ElastoPlasticContact<dim>::load_checkpoint()
  {
    TimerOutput::Scope scope(timer, "Checkpoint");

    const Checkpoint::Contents    contents = checkpoint.load();
    std::istringstream            state(contents.state);
    boost::archive::text_iarchive archive(state);
    Statistics::Progress          progress;
    serialize_progress(archive, progress);

    coarsen_to_coarse_mesh(triangulation);
    triangulation.load(contents.mesh_file);
    setup_body();
    VectorType response;
    for (VectorType *field : {&displacement_rate, &committed_forces, &response})
      solid->initialize_vector(*field);
    std::vector<VectorType *> fields = {&displacement,
                                        &displacement_rate,
                                        &committed_forces,
                                        &response};
    parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
      dof_handler);
    transfer.deserialize(fields);
    solid->set_states(
      StateTransfer<dim>(triangulation, fe.degree, model.materials.size())
        .load());
    committed_displacement = displacement;

    setup_contact();
    if (response.l2_norm() > 0)
      tangent_solver->set_response(response);
    take_back_step();
    screen.remark(
      "Resumed at t = " + Patterns::Tools::to_string(time_steps.time()) +
      ", before step " + std::to_string(time_steps.number()) + ".");
    return progress;
  }



  // Called after every Newton step.
  template <int dim>
  void
  ElastoPlasticContact<dim>::stop_if_requested() const
  {
    if (step_is_under_way && termination_requested(communicator))
      throw TerminationError(
        "Ended on request (SIGTERM) in load step " +
        std::to_string(time_steps.number()) +
        (time_steps.number() > 1 ?
           ". The option --resume goes on after the last completed one." :
           ", which was the first. There is nothing to resume."));
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
