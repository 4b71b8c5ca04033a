// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/loads.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    /// As stresses: the tractions at the corners of all sides, and body forces
    /// at all vertices.
    template <int dim>
    Vector<double>
    all_loads(const SplitMesh<dim>          &mesh,
              const BoundaryConditions<dim> &conditions,
              const BodyForce<dim>          &body_force,
              const double                   time)
    {
      std::vector<double> values;
      for (const auto &side : mesh.faces)
        if (const auto traction = conditions.tractions().find(side.boundary_id);
            traction != conditions.tractions().end())
          {
            const auto corners = mesh.corners(side);
            for (const auto &corner : corners)
              for (const auto &component : traction->second)
                values.push_back(
                  component->value(from_inside(corner, centre_of(corners)),
                                   time));
          }
      const double size = mesh.size();
      for (const Point<dim> &vertex : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          values.push_back(size * body_force.value(vertex, time)[d]);
      return Vector<double>(values.begin(), values.end());
    }
  } // namespace



  template <int dim>
  Loads<dim>
  Loads<dim>::growing(const SplitMesh<dim>          &mesh,
                      const BoundaryConditions<dim> &conditions,
                      const BodyForce<dim>          &body_force)
  {
    // (at none of which waves vanish that do at the others)
    constexpr std::array<double, 4> times_between = {
      {0.2360679775, 0.5, 0.6180339887, 0.8541019662}};

    const auto at = [&](const double time) {
      return all_loads(mesh, conditions, body_force, time);
    };
    const Vector<double> begin = at(0.), end = at(1.);
    double size       = std::max(begin.linfty_norm(), end.linfty_norm()),
           difference = 0; // from what is linear in time
    for (const double time : times_between)
      {
        Vector<double> between = at(time);
        keep_largest(size, between.linfty_norm());
        between.add(time - 1., begin, -time, end);
        keep_largest(difference, between.linfty_norm());
      }
    if (size == 0)
      throw InputError(
        "Limit load/Load",
        "tractions",
        "there is no traction ('Boundary conditions/Traction') and no body "
        "force ('Body force') that could grow.");
    if (difference > Tolerance::expression * size)
      throw InputError(
        "Limit load/Load",
        "tractions",
        "tractions and body forces must be linear functions of the time t, "
        "which is the load factor. For instance: 'Traction = top: 0; -t'.");
    Vector<double> change = end;
    change -= begin;
    if (change.linfty_norm() > Tolerance::smallest_load * size)
      return {0., 1., body_force};
    return {std::nullopt, 0., body_force};
  }



  template <int dim>
  double
  Loads<dim>::time_of_largest(const SplitMesh<dim>          &mesh,
                              const BoundaryConditions<dim> &conditions,
                              const BodyForce<dim>          &body_force,
                              const std::vector<double>     &times)
  {
    const auto load_at = [&](const double time) {
      return all_loads(mesh, conditions, body_force, time).linfty_norm();
    };
    return *std::max_element(times.begin(),
                             times.end(),
                             [&](const double a, const double b) {
                               return load_at(a) < load_at(b);
                             });
  }



  template struct Loads<2>;
  template struct Loads<3>;
} // namespace ElastoPlastic
