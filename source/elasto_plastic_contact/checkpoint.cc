// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <sstream>

#include "base/termination.h"
#include "elasto_plastic_contact.h"
#include "io/saved_mesh.h"
#include "mechanics/ghosted_copy.h"

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

    VectorType response = tangent_solver->known_response();
    if (response.size() == 0)
      solid->initialize_vector(response);
    const GhostedCopies<dim> fields({&committed_displacement,
                                     &displacement_rate,
                                     &committed_forces,
                                     &response},
                                    dof_handler);

    CellValues                           values = solid->states();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (const VectorType *field : fields.pointers())
            for (const auto dof : dofs)
              values[cell->active_cell_index()].push_back((*field)(dof));
        }
    checkpoint.save(state.str(), [&](const std::string &mesh_file) {
      save_mesh(triangulation, values, mesh_file);
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
    CellValues values = load_mesh(triangulation, contents.mesh_file);
    setup_body();
    VectorType                        response;
    const std::array<VectorType *, 4> fields = {
      {&displacement, &displacement_rate, &committed_forces, &response}};
    for (VectorType *field : fields)
      solid->initialize_vector(*field);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          auto      &of_cell  = values[cell->active_cell_index()];
          const auto n_states = of_cell.size() - fields.size() * dofs.size();
          auto       value    = of_cell.begin() + n_states;
          for (VectorType *field : fields)
            for (const auto dof : dofs)
              {
                if (field->in_local_range(dof))
                  (*field)(dof) = *value;
                ++value;
              }
          of_cell.resize(n_states);
        }
    solid->set_states(values);
    committed_displacement = displacement;

    setup_contact();
    if (response.l2_norm() > 0)
      tangent_solver->set_response(response);
    take_back_step();
    log.remark(
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
