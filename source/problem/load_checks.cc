// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "mesh/body_size.h"
#include "mesh/boundary_faces.h"
#include "problem/problem_checks.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Expressions are evaluated in so many cells of a rank at each time: to
    /// evaluate them in all would take as long as the steps of an elastic body.
    constexpr unsigned int n_sampled_cells = 500;



    /// Where locally owned cells need the values that are prescribed on
    /// @p boundaries: the nodes, for displacements, and the quadrature points
    /// of the faces, for tractions. Each point with its boundary.
    template <int dim>
    std::vector<std::pair<types::boundary_id, Point<dim>>>
    boundary_points(const DoFHandler<dim>              &dof_handler,
                    const std::set<types::boundary_id> &boundaries)
    {
      const auto               &fe = dof_handler.get_fe();
      const Quadrature<dim - 1> nodes(
        fe.base_element(0).get_unit_face_support_points());
      FEFaceValues<dim> at_nodes(fe, nodes, update_quadrature_points);
      FEFaceValues<dim> at_quadrature_points(fe,
                                             QGauss<dim - 1>(fe.degree + 1),
                                             update_quadrature_points);

      std::vector<std::pair<types::boundary_id, Point<dim>>> result;
      for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
        for (auto *const points : {&at_nodes, &at_quadrature_points})
          {
            points->reinit(cell, f);
            for (const auto &point : points->get_quadrature_points())
              result.emplace_back(cell->face(f)->boundary_id(), point);
          }
      return result;
    }



    template <int dim>
    std::vector<Point<dim>>
    centres_of_some_cells(const Triangulation<dim> &triangulation)
    {
      const unsigned int n_between =
        1 + triangulation.n_active_cells() / n_sampled_cells;
      std::vector<Point<dim>> centres;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            cell->active_cell_index() % n_between == 0)
          centres.push_back(cell->center());
      return centres;
    }



    /// The smallest of all materials.
    template <int dim>
    double
    smallest_shear_modulus(const Model<dim> &model)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const Material<double> &material : model.materials)
        smallest = std::min(smallest, material.shear_modulus);
      return smallest;
    }



    /// The loads of a body at the points where they are evaluated, relative to
    /// such as would deform it by about its own size.
    template <int dim>
    class SampledLoads
    {
    public:
      SampledLoads(
        const Model<dim>                                &model,
        const DoFHandler<dim>                           &dof_handler,
        const parallel::distributed::Triangulation<dim> &triangulation)
        : model(model)
        , length(body_size(triangulation))
        , stress(smallest_shear_modulus(model))
      {
        const BoundaryConditions<dim> &conditions = model.boundary_conditions;
        std::set<types::boundary_id>   boundaries =
          conditions.ids(BoundaryConditionType::traction);
        boundaries.merge(
          conditions.ids(BoundaryConditionType::prescribed_displacement));
        boundary = boundary_points(dof_handler, boundaries);
        if (model.body_force.is_present())
          inner = centres_of_some_cells(triangulation);
      }

      /// The largest one. @throws InputError
      double
      largest(const double time) const
      {
        const auto &displacements =
          model.boundary_conditions.prescribed_displacements();
        double result = model.indenter.shape ? of_indenter(time) : 0.;
        for (const auto &[id, point] : boundary)
          result =
            std::max(result,
                     model.boundary_conditions.largest_value(id, point, time) /
                       (displacements.count(id) > 0 ? length : stress));
        for (const Point<dim> &point : inner)
          {
            const Tensor<1, dim> force = model.body_force.value(point, time);
            for (unsigned int d = 0; d < dim; ++d)
              result = std::max(result, std::abs(force[d]) * length / stress);
          }
        return result;
      }

    private:
      // (Where it depends on what is reached, or on what the indenter moves
      // into, it may be any.)
      double
      of_indenter(const double time) const
      {
        const auto load = model.load_program.load(time);
        if (!load || !model.load_program.path().is_at_rest())
          return std::numeric_limits<double>::infinity();
        if (load->control == Control::depth)
          return std::max(load->value, 0.) / length;
        const bool is_round =
          model.strain_model.kinematics == Kinematics::axisymmetric;
        return load->value / stress / std::pow(length, is_round ? 2 : dim - 1);
      }

      const Model<dim>                                      &model;
      const double                                           length, stress;
      std::vector<std::pair<types::boundary_id, Point<dim>>> boundary;
      std::vector<Point<dim>>                                inner;
    };



    /// See SampledLoads. Collective. @throws InputError
    template <int dim>
    double
    largest_load_at_any_time(
      const Model<dim>                                &model,
      TimeSteps                                        steps,
      const DoFHandler<dim>                           &dof_handler,
      const parallel::distributed::Triangulation<dim> &triangulation)
    {
      const MPI_Comm          communicator = communicator_of(dof_handler);
      const SampledLoads<dim> loads(model, dof_handler, triangulation);
      double                  largest = 0.;
      rethrow_collectively(communicator, [&]() {
        for (; !steps.finished(); steps.advance())
          largest = std::max(largest, loads.largest(steps.next_time()));
      });
      return Utilities::MPI::max(largest, communicator);
    }



    /// Whether the body bears an initial stress at a quadrature point.
    /// Collective. @throws InputError
    template <int dim>
    bool
    bears_initial_stress(const InitialStress<dim> &stress,
                         const DoFHandler<dim>    &dof_handler)
    {
      const MPI_Comm communicator = communicator_of(dof_handler);
      const auto    &fe           = dof_handler.get_fe();
      FEValues<dim>  points(fe,
                           QGauss<dim>(fe.degree + 1),
                           update_quadrature_points);
      double         largest = 0.;
      rethrow_collectively(communicator, [&]() {
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              points.reinit(cell);
              for (const auto &point : points.get_quadrature_points())
                largest = std::max(largest, stress.value(point).norm());
            }
      });
      return Utilities::MPI::max(largest, communicator) > 0.;
    }
  } // namespace



  template <int dim>
  void
  check_loads(const Model<dim>                                &model,
              const TimeSteps                                 &steps,
              const DoFHandler<dim>                           &dof_handler,
              const parallel::distributed::Triangulation<dim> &triangulation)
  {
    constexpr double smallest_load = 1e-20;

    const double largest =
      largest_load_at_any_time(model, steps, dof_handler, triangulation);
    if (largest == 0. &&
        !bears_initial_stress(model.initial_stress, dof_handler))
      throw InputError(
        "Nothing loads the body: at the ends of all load steps, neither depth "
        "nor force of the indenter is greater than 0 (both are positive where "
        "it is pressed in), and tractions, prescribed "
        "displacements, body forces and the initial stress are zero, as far as "
        "there are any. Check 'Loading', 'Boundary conditions', 'Body force' "
        "and 'Initial stress'.");
    if (largest > 0. && largest < smallest_load)
      throw InputError(
        "The loads are so small that the rounding of numbers hides what they "
        "do: at the ends of all load steps, the largest of them strains the "
        "body by about " +
        Patterns::Tools::to_string(largest) +
        ". At least 1e-20 is needed. Are the values in 'Loading', 'Boundary "
        "conditions' and 'Body force' in the same system of units as lengths "
        "and moduli?");
  }



  void
  check_field_times(const OutputParameters &output,
                    const LoadProgram      &load_program)
  {
    if (output.fields != FieldOutputTimes::at_times)
      return;
    const double end = load_program.final_time();
    for (const double time : output.field_times)
      if (time <= 0. || time > (1. + 1e-9) * end)
        throw InputError("Output/Field times",
                         output.field_times,
                         "there are no fields at " +
                           Patterns::Tools::to_string(time) +
                           ": the load steps begin at t = 0, where nothing "
                           "has happened, and end at t = " +
                           Patterns::Tools::to_string(end) +
                           ". Leave that time out, or change 'Loading'.");
  }



  template void
  check_loads(const Model<2> &,
              const TimeSteps &,
              const DoFHandler<2> &,
              const parallel::distributed::Triangulation<2> &);
  template void
  check_loads(const Model<3> &,
              const TimeSteps &,
              const DoFHandler<3> &,
              const parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
