// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

#include "base/termination.h"
#include "elasto_plastic_contact.h"
#include "io/parameter_input.h"
#include "io/saved_mesh.h"
#include "loading/same_past.h"

namespace ElastoPlastic
{
  namespace
  {
    LoadingParameters
    loading_parameters(const Checkpoint::Entries &entries)
    {
      LoadingParameters parameters;
      ParameterHandler  prm;
      parameters.add_parameters(prm);
      for (const auto &[path, value] : entries)
        if (path.rfind("Loading/", 0) == 0)
          set_entry(prm, path, value);
      return parameters;
    }
  } // namespace



  template <int dim>
  template <typename Archive>
  void
  ElastoPlasticContact<dim>::serialize_progress(Archive              &archive,
                                                Statistics::Progress &progress)
  {
    archive &time_steps &load_program &field_output &cycle &last_step &imprint
      &largest_forces &largest_contact_area &progress;
  }



  // With the last solution of the linear solver, which helps the next one.
  template <int dim>
  std::vector<VectorType *>
  ElastoPlasticContact<dim>::fields_of_last_step(VectorType &response)
  {
    std::vector<VectorType *> fields;
    if (model.contact.edge == EdgeRule::within_faces)
      fields = contact.edge_memory().vectors();
    for (VectorType *field : {&last_step.displacement,
                              &last_step.displacement_rate,
                              &last_step.slip,
                              &last_step.forces,
                              &response})
      fields.push_back(field);
    return fields;
  }



  // What the next load step begins with: the mesh, with the states of the
  // material points and the fields in its cells, and where the history is.
  template <int dim>
  void
  ElastoPlasticContact<dim>::save_checkpoint(Statistics &statistics)
  {
    TimerOutput::Scope scope(timer, "Checkpoint");
    statistics.write_to_disk();

    std::ostringstream            state;
    boost::archive::text_oarchive archive(state);
    Statistics::Progress          progress = statistics.progress();
    serialize_progress(archive, progress);
    archive &contact.edge_memory();

    VectorType response = tangent_solver->known_response();
    if (response.size() == 0)
      solid->initialize_vector(response);
    CellValues values = solid->states();
    append_fields(values, fields_of_last_step(response), dof_handler);
    checkpoint.save(state.str(), [&](const std::string &mesh_file) {
      save_mesh(triangulation, values, mesh_file);
    });
    time_since_checkpoint.restart();
  }



  // The clock of the first rank decides.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::checkpoint_is_due() const
  {
    return Utilities::MPI::broadcast(
      communicator,
      time_since_checkpoint.wall_time() >=
        60. * parameters.output.minutes_between_checkpoints);
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
    check_same_past(loading_parameters(contents.entries),
                    parameters.loading,
                    last_step.result.time);
    if (last_step.result.step == time_steps.number())
      time_steps.end_step_at(last_step.result.time);

    coarsen_to_coarse_mesh(triangulation);
    CellValues values = load_mesh(triangulation, contents.mesh_file);
    setup_body();
    setup_contact();
    archive   &contact.edge_memory();
    VectorType response;
    const auto fields = fields_of_last_step(response);
    for (VectorType *field : fields)
      solid->initialize_vector(*field);
    take_fields(values, fields, dof_handler);
    solid->set_states(values);
    if (response.l2_norm() > 0)
      tangent_solver->set_response(response);
    take_back_step();
    contact.restore_edge();
    small_strain_guard.warning(last_step.result); // has been said
    log.remark(
      "Resumed at t = " + Patterns::Tools::to_string(last_step.result.time) +
      ", after step " + std::to_string(last_step.result.step) + ".");
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
