// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

#include "base/exceptions.h"
#include "base/process.h"
#include "contact_run/elasto_plastic_contact.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  template <int dim>
  template <typename Archive>
  void
  ElastoPlasticContact<dim>::serialize_progress(Archive             &archive,
                                                RunTables::Progress &progress)
  {
    archive &step &output &evaluation &progress;
  }



  // What the next load step begins with: the mesh, with the states of the
  // material points and the fields in its cells, and where the history is.
  template <int dim>
  void
  ElastoPlasticContact<dim>::save_checkpoint(RunTables &statistics)
  {
    TimerOutput::Scope scope(timer, "Checkpoint");
    statistics.write_to_disk();
    output.write_to_disk();

    std::ostringstream            state;
    boost::archive::text_oarchive archive(state, boost::archive::no_header);
    RunTables::Progress           progress = statistics.progress();
    serialize_progress(archive, progress);

    checkpoint.save(state.str(), [&](const std::string &mesh_file) {
      step.save(mesh_file);
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



  // The step under way cannot be finished, for whatever reason.
  template <int dim>
  void
  ElastoPlasticContact<dim>::keep_what_has_been_computed(const Error &error,
                                                         RunTables &statistics)
  {
    step.take_back();
    save_checkpoint(statistics);
    throw_error(error.status,
                std::string(error.what()) +
                  " What has been computed up to t = " +
                  Patterns::Tools::to_string(step.last().result.time) +
                  " is kept: the option --resume goes on from there, also "
                  "with other entries of 'Nonlinear solver', 'Linear "
                  "solver' and 'Loading'.");
  }



  // Without the mesh and what it carries.
  template <int dim>
  Checkpoint::Contents
  ElastoPlasticContact<dim>::read_checkpoint(RunTables::Progress &progress)
  {
    Checkpoint::Contents          contents = checkpoint.load();
    std::istringstream            state(contents.state);
    boost::archive::text_iarchive archive(state, boost::archive::no_header);
    serialize_progress(archive, progress);
    check_same_past(contents.loading(),
                    parameters.loading,
                    step.last().result.time);
    return contents;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::check_checkpoint()
  {
    RunTables::Progress progress;
    read_checkpoint(progress);
  }



  template <int dim>
  RunTables::Progress
  ElastoPlasticContact<dim>::load_checkpoint()
  {
    TimerOutput::Scope scope(timer, "Checkpoint");

    RunTables::Progress        progress;
    const Checkpoint::Contents contents = read_checkpoint(progress);
    step.restore(contents.mesh_file);
    evaluation.do_not_repeat(step.last().result);
    log.remark(
      "Resumed at t = " + Patterns::Tools::to_string(step.last().result.time) +
      ", after step " + std::to_string(step.last().result.step) + ".");
    return progress;
  }



  // Called after every Newton step.
  template <int dim>
  void
  ElastoPlasticContact<dim>::stop_if_requested() const
  {
    if (step.is_under_way() && termination_requested(communicator))
      throw TerminationError(
        "Ended on request (SIGTERM) in load step " +
        std::to_string(step.times().number()) +
        (step.is_first() ?
           ", which was the first. There is nothing to resume." :
           "."));
  }



  // The checkpoint is that of a history which had come to its end. The mesh is
  // what this step has left.
  template <int dim>
  void
  ElastoPlasticContact<dim>::go_on_after_end(RunTables &statistics)
  {
    if (adaptation.is_due(step.last().result.step))
      error_estimate.find_indicators();
    go_on_to_next_step(statistics);
    if (step.times().finished())
      log.remark(
        "The load history is complete, and nothing is left to do. To "
        "go on, make it longer: 'Loading/History', or 'Final time', and "
        "'Number of steps'.");
  }
} // namespace ElastoPlastic
