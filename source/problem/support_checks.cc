// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "loads/loaded_body.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/boundary_faces.h"
#include "problem/problem_checks.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Ones at the unknowns that the supports hold, not counting constraints.
    template <int dim>
    VectorType
    held_unknowns(const Model<dim>      &model,
                  const DoFHandler<dim> &dof_handler,
                  const Supports<dim>   &supports,
                  const VectorType      &layout)
    {
      VectorType held(layout.get_partitioner());
      supports.set_fixed_entries(held, 1.);
      if (model.strain_model.kinematics == Kinematics::axisymmetric)
        for (const auto dof : DoFTools::extract_dofs(
               dof_handler, ComponentMask(std::vector<bool>{true, false})))
          held(dof) = 1.; // rings resist all but the vertical motion
      return held;
    }



    template <int dim>
    [[noreturn]] void
    reject_free_motion(const FreeMotion<dim> &motion)
    {
      std::ostringstream what;
      what << "its rigid body motion '" << motion.name << "'";
      if (!motion.whole_body)
        what << " of the part between ("
             << motion.part.get_boundary_points().first << ") and ("
             << motion.part.get_boundary_points().second
             << "), which no face of a cell connects with the rest";
      throw InputError(
        "The supports do not hold the body: nothing prevents " + what.str() +
        ". Add a fixed boundary or rollers to 'Boundary conditions'. The "
        "indenter is no support: it only presses.");
    }



    template <int dim>
    bool
    is_pressed_against_indenter(const ContactSet<dim> &contact,
                                const VectorType      &external_forces,
                                const VectorType      &motion)
    {
      if (contact.is_force_driven())
        return false;
      VectorType candidates(external_forces.get_partitioner());
      contact.set_candidate_entries(candidates, 1.);
      return (candidates * motion) * (external_forces * motion) > 0;
    }



    /// Calls @p action(face, vertex number) on the contact boundary of this
    /// rank. Collective.
    template <int dim, typename Action>
    void
    for_each_contact_vertex(const Model<dim>      &model,
                            const DoFHandler<dim> &dof_handler,
                            const Action          &action)
    {
      const auto boundaries =
        model.boundary_conditions.ids(BoundaryConditionType::contact);
      rethrow_collectively(communicator_of(dof_handler), [&]() {
        for (const auto &[cell, f] : known_faces(dof_handler, boundaries))
          for (const auto v : cell->face(f)->vertex_indices())
            action(cell->face(f), v);
      });
    }



    /// Ones at the vertical unknowns of the sides or faces of the contact
    /// boundary that the indenter reaches, at a corner or in the middle.
    template <int dim>
    VectorType
    reached_unknowns(const Model<dim>       &model,
                     const GapFunction<dim> &gap_function,
                     const DoFHandler<dim>  &dof_handler,
                     const VectorType       &layout)
    {
      const auto is_reached = [&](const auto &face) {
        const auto vertices = face->vertex_indices();
        return std::isfinite(gap_function.value(face->center())) ||
               std::any_of(vertices.begin(), vertices.end(), [&](const auto v) {
                 return std::isfinite(gap_function.value(face->vertex(v)));
               });
      };
      VectorType reached(layout.get_partitioner());
      for_each_contact_vertex(
        model, dof_handler, [&](const auto &face, const unsigned int v) {
          if (const auto dof = face->vertex_dof_index(v, dim - 1);
              reached.in_local_range(dof) && is_reached(face))
            reached(dof) = 1.;
        });
      return reached;
    }



    /// Ones at all unknowns that an indenter may hold, should the body be
    /// pressed against it.
    template <int dim>
    VectorType
    unknowns_on_indenter(const Model<dim>      &model,
                         const DoFHandler<dim> &dof_handler,
                         const VectorType      &layout)
    {
      VectorType held(layout.get_partitioner());
      if (model.indenter.shape)
        for_each_contact_vertex(
          model, dof_handler, [&](const auto &face, const unsigned int v) {
            for (unsigned int d = 0; d < dim; ++d)
              if (const auto dof = face->vertex_dof_index(v, d);
                  held.in_local_range(dof))
                held(dof) = 1.;
          });
      return held;
    }



    /// Whether all unknowns that are @p reached move to the same side.
    bool
    move_together(const VectorType &reached, const VectorType &motion)
    {
      constexpr double rounding = 1e-9;

      double     lowest = 0., highest = 0.;
      VectorType moved = motion;
      moved.scale(reached);
      for (const double value : moved)
        {
          lowest  = std::min(lowest, value);
          highest = std::max(highest, value);
        }
      lowest  = Utilities::MPI::min(lowest, motion.get_mpi_communicator());
      highest = Utilities::MPI::max(highest, motion.get_mpi_communicator());
      return std::max(-lowest, highest) > rounding &&
             std::min(-lowest, highest) <= rounding;
    }



    bool
    drive(const VectorType &forces, const VectorType &motion)
    {
      constexpr double rounding = 1e-9;
      return std::abs(forces * motion) >
             rounding * forces.l2_norm() * motion.l2_norm();
    }
  } // namespace



  template <int dim>
  void
  check_supports(const Model<dim>      &model,
                 const DoFHandler<dim> &dof_handler,
                 const Supports<dim>   &supports,
                 const ContactSet<dim> &contact,
                 const VectorType      &external_forces)
  {
    VectorType held =
      held_unknowns(model, dof_handler, supports, external_forces);
    auto motions = free_motions(dof_handler, held, supports.constraints());
    if (!motions.empty() &&
        is_pressed_against_indenter(contact,
                                    external_forces,
                                    motions.front().displacement))
      {
        contact.set_candidate_entries(held, 1.);
        motions = free_motions(dof_handler, held, supports.constraints());
      }
    if (!motions.empty())
      reject_free_motion(motions.front());
  }



  // (Without an indenter, nothing is reached.)
  template <int dim>
  void
  check_supports_of_limit_load(
    const Model<dim>                                &model,
    const GrowingLoad                                growing_load,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    const FESystem<dim> fe(FE_Q<dim>(1), dim);
    DoFHandler<dim>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    Supports<dim> supports(model);
    supports.reinit(dof_handler);

    const VectorType layout(dof_handler.locally_owned_dofs(),
                            supports.constraints().get_local_lines(),
                            communicator_of(triangulation));
    VectorType       held = held_unknowns(model, dof_handler, supports, layout);
    if (growing_load == GrowingLoad::indenter)
      {
        const VectorType reached =
          reached_unknowns(model, gap_function, dof_handler, layout);
        for (const FreeMotion<dim> &motion :
             free_motions(dof_handler, held, supports.constraints()))
          if (move_together(reached, motion.displacement))
            reject_free_motion(motion);
      }

    std::vector<VectorType> loads;
    for (const double time : {0., 1.})
      {
        loads.emplace_back(layout.get_partitioner());
        compute_external_forces(
          loads.back(), dof_handler, supports.hanging_nodes(), model, time);
      }
    if (growing_load == GrowingLoad::indenter)
      loads.pop_back();
    held += unknowns_on_indenter(model, dof_handler, layout);
    for (const FreeMotion<dim> &motion :
         free_motions(dof_handler, held, supports.constraints()))
      for (const VectorType &forces : loads)
        if (drive(forces, motion.displacement))
          reject_free_motion(motion);
  }



  template void
  check_supports(const Model<2> &,
                 const DoFHandler<2> &,
                 const Supports<2> &,
                 const ContactSet<2> &,
                 const VectorType &);
  template void
  check_supports(const Model<3> &,
                 const DoFHandler<3> &,
                 const Supports<3> &,
                 const ContactSet<3> &,
                 const VectorType &);
  template void
  check_supports_of_limit_load(const Model<2> &,
                               const GrowingLoad,
                               const GapFunction<2> &,
                               const parallel::distributed::Triangulation<2> &);
  template void
  check_supports_of_limit_load(const Model<3> &,
                               const GrowingLoad,
                               const GapFunction<3> &,
                               const parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
