// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "base/rethrow_collectively.h"
#include "load_checks.h"
#include "mechanics/boundary_points.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Expressions are evaluated in so many cells of a rank at each time: to
    /// evaluate them in all would take as long as the steps of an elastic body.
    constexpr unsigned int n_sampled_cells = 500;



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



    /// The loads of a body at the points where they are evaluated.
    template <int dim>
    class SampledLoads
    {
    public:
      SampledLoads(const Model<dim> &model, const DoFHandler<dim> &dof_handler)
        : model(model)
      {
        const BoundaryConditions<dim> &conditions = model.boundary_conditions;
        std::set<types::boundary_id>   boundaries =
          conditions.ids(BoundaryConditionType::traction);
        boundaries.merge(
          conditions.ids(BoundaryConditionType::prescribed_displacement));
        boundary = boundary_points(dof_handler, boundaries);
        if (model.body_force.is_present())
          inner = centres_of_some_cells(dof_handler.get_triangulation());
      }

      /// @return whether there is any load. @throws InputError
      bool
      check(const double time) const
      {
        const auto load = model.load_program.load(time);
        bool       is_loaded =
          model.indenter.shape &&
          (!load || load->control == Control::depth || load->value > 0.);
        for (const auto &[id, point] : boundary)
          is_loaded |= model.boundary_conditions.check_values(id, point, time);
        for (const Point<dim> &point : inner)
          is_loaded |= model.body_force.value(point, time).norm() > 0.;
        return is_loaded;
      }

    private:
      const Model<dim>                                      &model;
      std::vector<std::pair<types::boundary_id, Point<dim>>> boundary;
      std::vector<Point<dim>>                                inner;
    };



    /// Collective. @throws InputError
    template <int dim>
    bool
    is_loaded_at_any_time(const Model<dim>      &model,
                          TimeSteps              steps,
                          const DoFHandler<dim> &dof_handler)
    {
      const MPI_Comm          communicator = dof_handler.get_communicator();
      const SampledLoads<dim> loads(model, dof_handler);
      bool                    is_loaded = false;
      rethrow_collectively(communicator, [&]() {
        for (; !steps.finished(); steps.advance())
          is_loaded |= loads.check(steps.next_time());
      });
      return Utilities::MPI::logical_or(is_loaded, communicator);
    }
  } // namespace



  template <int dim>
  void
  check_loads(const Model<dim>      &model,
              const TimeSteps       &steps,
              const DoFHandler<dim> &dof_handler)
  {
    if (!is_loaded_at_any_time(model, steps, dof_handler))
      throw InputError(
        "Nothing loads the body: at the ends of all load steps, the force of "
        "the indenter, tractions, prescribed displacements and body forces are "
        "zero, as far as there are any. Check 'Loading', 'Boundary conditions' "
        "and 'Body force'.");
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
                         Patterns::Tools::to_string(output.field_times),
                         "there are no fields at " +
                           Patterns::Tools::to_string(time) +
                           ": the load steps begin at t = 0, where nothing "
                           "has happened, and end at t = " +
                           Patterns::Tools::to_string(end) +
                           ". Leave that time out, or change 'Loading'.");
  }



  template void
  check_loads(const Model<2> &, const TimeSteps &, const DoFHandler<2> &);
  template void
  check_loads(const Model<3> &, const TimeSteps &, const DoFHandler<3> &);
} // namespace ElastoPlastic
