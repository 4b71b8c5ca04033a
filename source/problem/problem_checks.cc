// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "evaluation/nominal_contact.h"
#include "mesh/body_size.h"
#include "mesh/boundary_faces.h"
#include "problem/load_history.h"
#include "problem/problem_checks.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The horizontal directions across which rollers through the indenter's
    /// first position hold the body.
    template <int dim>
    std::array<bool, dim - 1>
    directions_of_symmetry(const Model<dim>         &model,
                           const Triangulation<dim> &triangulation)
    {
      const Point<dim - 1> &position = model.indenter.position;
      const auto            rollers =
        model.boundary_conditions.ids(BoundaryConditionType::roller);
      std::array<unsigned int, dim - 1> found = {};
      for (const auto &[cell, f] : owned_faces(triangulation, rollers))
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const auto face     = cell->face(f);
            const auto vertices = face->vertex_indices();
            found[d] +=
              std::all_of(vertices.begin(), vertices.end(), [&](const auto v) {
                return std::abs(face->vertex(v)[d] - position[d]) <
                       1e-10 * face->diameter();
              });
          }
      std::array<bool, dim - 1> result;
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[d] =
          Utilities::MPI::sum(found[d], communicator_of(triangulation)) > 0;
      return result;
    }



    /// modelled_part() where the indenter is after a motion.
    template <int dim>
    double
    part_around(const Model<dim>                                &model,
                const Tensor<1, 2>                              &motion,
                const parallel::distributed::Triangulation<dim> &triangulation)
    {
      Point<dim - 1> position = model.indenter.position;
      for (unsigned int d = 0; d < dim - 1; ++d)
        position[d] += motion[d];
      return modelled_part(triangulation,
                           model.boundary_conditions.ids(
                             BoundaryConditionType::contact),
                           position,
                           model.strain_model.kinematics);
    }



    [[noreturn]] void
    reject_motion_across_symmetry(const std::string &path, const unsigned int d)
    {
      throw InputError(
        "Loading/Path",
        path,
        std::string("the indenter stands on a plane of symmetry across ") +
          "xy"[d] +
          ", beyond which its mirror image would move the other way. Let it "
          "move along that plane, or model the whole body.");
    }



    /// Name and text of the entry that says how deep the indenter goes.
    std::pair<std::string, std::string>
    entry_of_depth(const LoadingParameters &loading)
    {
      return loading.history.empty() ?
               std::pair("Loading/Depth", loading.depth) :
               std::pair("Loading/History", loading.history);
    }
  } // namespace



  template <int dim>
  void
  check_contact_boundaries(
    const Model<dim>                                &model,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    constexpr double rounding = 1e-6;

    std::map<types::boundary_id, double> upwards;
    for (const auto id :
         model.boundary_conditions.ids(BoundaryConditionType::contact))
      upwards[id] = -1.;
    const FE_Nothing<dim> fe;
    FEFaceValues<dim> values(fe, QMidpoint<dim - 1>(), update_normal_vectors);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (const auto found = upwards.find(cell->face(f)->boundary_id());
              cell->face(f)->at_boundary() && found != upwards.end())
            {
              values.reinit(cell, f);
              found->second =
                std::max(found->second, values.normal_vector(0)[dim - 1]);
            }
    for (const auto &[name, id] : model.boundary_conditions.names())
      if (const auto found = upwards.find(id);
          found != upwards.end() &&
          Utilities::MPI::max(found->second, communicator_of(triangulation)) <=
            rounding)
        throw InputError(
          "The boundary '" + name +
          "' of 'Boundary conditions/Contact' does not face the indenter, which "
          "comes from above (in the last coordinate): no part of it faces "
          "upwards. Turn the body, or name another boundary.");
  }



  template <int dim>
  void
  check_reach(const Model<dim>        &model,
              TimeSteps                steps,
              const LoadingParameters &loading,
              const double             min_gap)
  {
    if (std::isinf(min_gap))
      throw InputError(
        "The indenter can never touch the body: no node of the contact "
        "boundary lies within its reach. Check 'Indenter/Position', its size "
        "and 'Indenter/Reach', or refine the mesh ('Geometry/Initial "
        "refinements').");

    bool is_pushed_to_depth = false;
    for (; !steps.finished(); steps.advance())
      if (const auto load = model.load_program.load(steps.next_time()))
        {
          const bool is_depth = load->control == Control::depth;
          if (is_depth ? load->value > min_gap ||
                           (load->value == min_gap && has_other_loads(model)) :
                         load->value > 0.)
            return;
          is_pushed_to_depth |= is_depth;
        }
    if (!is_pushed_to_depth)
      return;
    throw InputError(
      entry_of_depth(loading).first,
      entry_of_depth(loading).second,
      "the indenter can never touch the body: the smallest gap under it is " +
        Patterns::Tools::to_string(min_gap) +
        ". Push deeper, reduce 'Indenter/Initial gap', or refine the mesh under "
        "the tip.");
  }



  template <int dim>
  void
  check_width(const GapFunction<dim>                          &gap_function,
              const parallel::distributed::Triangulation<dim> &triangulation)
  {
    constexpr double smallest_part = 1e-6;
    const double     width         = smallest_part * body_size(triangulation);
    const auto       reaches       = [&](const Tensor<1, dim> &offset) {
      Point<dim> point;
      for (unsigned int d = 0; d < dim - 1; ++d)
        point[d] = gap_function.position()[d];
      return std::isfinite(gap_function.value(point + offset));
    };
    for (unsigned int d = 0; reaches({}) && d < dim - 1; ++d)
      {
        Tensor<1, dim> side;
        side[d] = width;
        if (!reaches(side) && !reaches(-side))
          throw InputError(
            "The indenter reaches less than 1e-6 of the size of the body to "
            "both sides, which no mesh resolves. Are 'Indenter/Radius', 'Half "
            "width', 'Size' or 'Reach' and the lengths in 'Geometry' in the "
            "same unit?");
      }
  }



  template <int dim>
  void
  check_depth(const Model<dim>         &model,
              const TimeSteps          &steps,
              const LoadingParameters  &loading,
              const Triangulation<dim> &triangulation)
  {
    const auto depth = largest_load(model.load_program, steps, Control::depth);
    const bool moves =
      !model.boundary_conditions.prescribed_displacements().empty();
    const double height = body_height(triangulation);
    if (!depth || moves || *depth - model.indenter.initial_gap < height)
      return;
    throw InputError(entry_of_depth(loading).first,
                     entry_of_depth(loading).second,
                     "at the depth " + Patterns::Tools::to_string(*depth) +
                       " the indenter is through the body, whose height is " +
                       Patterns::Tools::to_string(height) +
                       ". Are both in the same unit of length?");
  }



  template <int dim>
  void
  check_path(const Model<dim>                                &model,
             const GapFunction<dim>                          &gap_function,
             TimeSteps                                        steps,
             const LoadingParameters                         &loading,
             const parallel::distributed::Triangulation<dim> &triangulation)
  {
    const IndenterPath &path = model.load_program.path();
    if (path.is_at_rest())
      return;
    const auto   symmetric = directions_of_symmetry(model, triangulation);
    const double part      = part_around(model, {}, triangulation);

    const NominalContact<dim> contact(model,
                                      model.indenter,
                                      triangulation,
                                      gap_function);
    const auto                radius_at = [&](const double time) {
      const auto load = model.load_program.load(time);
      return load && load->control == Control::depth ?
                              contact.radius_at_surface(load->value).value_or(0.) :
                              0.;
    };
    Tensor<1, 2> last = path.displacement(steps.time());
    for (; !steps.finished(); steps.advance())
      {
        const double       time         = steps.next_time();
        const Tensor<1, 2> displacement = path.displacement(time);
        for (unsigned int d = 0; d < dim - 1; ++d)
          if (symmetric[d] && displacement[d] != 0.)
            reject_motion_across_symmetry(loading.path, d);
        const Tensor<1, 2> way = displacement - last;
        const Tensor<1, 2> foremost =
          way.norm() > 0. ? displacement + radius_at(time) / way.norm() * way :
                            displacement;
        last                      = displacement;
        constexpr double rounding = 1e-6;
        if (std::min(part_around(model, displacement, triangulation),
                     part_around(model, foremost, triangulation)) <
            part - rounding)
          throw InputError(
            "Loading/Path",
            loading.path,
            "at t = " + Patterns::Tools::to_string(time) +
              " the indenter comes to the edge of the contact boundary, or "
              "is beyond it, where it would press on nothing. End the path "
              "before, or model more of the body.");
      }
  }



  template void
  check_contact_boundaries(const Model<2> &,
                           const parallel::distributed::Triangulation<2> &);
  template void
  check_contact_boundaries(const Model<3> &,
                           const parallel::distributed::Triangulation<3> &);
  template void
  check_reach(const Model<2> &,
              TimeSteps,
              const LoadingParameters &,
              const double);
  template void
  check_width(const GapFunction<2> &,
              const parallel::distributed::Triangulation<2> &);
  template void
  check_depth(const Model<2> &,
              const TimeSteps &,
              const LoadingParameters &,
              const Triangulation<2> &);
  template void
  check_path(const Model<2> &,
             const GapFunction<2> &,
             TimeSteps,
             const LoadingParameters &,
             const parallel::distributed::Triangulation<2> &);
  template void
  check_reach(const Model<3> &,
              TimeSteps,
              const LoadingParameters &,
              const double);
  template void
  check_width(const GapFunction<3> &,
              const parallel::distributed::Triangulation<3> &);
  template void
  check_depth(const Model<3> &,
              const TimeSteps &,
              const LoadingParameters &,
              const Triangulation<3> &);
  template void
  check_path(const Model<3> &,
             const GapFunction<3> &,
             TimeSteps,
             const LoadingParameters &,
             const parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
