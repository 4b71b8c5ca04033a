// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <map>

#include "base/compatibility.h"
#include "evaluation/boundary_displacements.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  template <int dim>
  BoundaryDisplacements<dim>::BoundaryDisplacements(
    const LoadedBody<dim>                           &body,
    const parallel::distributed::Triangulation<dim> &triangulation)
    : kinematics(body.strain_model.kinematics)
  {
    std::map<types::boundary_id, double> areas;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              out_of_plane_length(face->center(), kinematics) >
                1e-10 * face->diameter())
            areas[face->boundary_id()] += face->measure();
    for (const auto &[name, id] : body.boundary_conditions.names())
      if (Utilities::MPI::max(areas[id], communicator_of(triangulation)) > 0.)
        boundaries[name] = id;
  }



  template <int dim>
  std::vector<std::string>
  BoundaryDisplacements<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &[name, id] : boundaries)
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(name + "_displacement_" + "xyz"[d]);
    return result;
  }



  template <int dim>
  std::vector<double>
  BoundaryDisplacements<dim>::compute(const DoFHandler<dim> &dof_handler,
                                      const VectorType      &u) const
  {
    const auto                 &fe = dof_handler.get_fe();
    FEFaceValues<dim>           values(fe,
                             QGauss<dim - 1>(fe.degree + 1),
                             update_values | update_JxW_values |
                               update_quadrature_points);
    const VectorType            ghosted_u = ghosted_copy(u, dof_handler);
    std::vector<Tensor<1, dim>> displacements(values.n_quadrature_points);

    // The integrals of the components of u, and of 1.
    std::map<types::boundary_id, std::array<double, dim + 1>> integrals;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              values.reinit(cell, f);
              values[FEValuesExtractors::Vector(0)].get_function_values(
                ghosted_u, displacements);
              auto &integral = integrals[cell->face(f)->boundary_id()];
              for (const unsigned int q : values.quadrature_point_indices())
                {
                  const double area =
                    values.JxW(q) *
                    out_of_plane_length(values.quadrature_point(q), kinematics);
                  for (unsigned int d = 0; d < dim; ++d)
                    integral[d] += area * displacements[q][d];
                  integral[dim] += area;
                }
            }

    std::vector<double> sums;
    for (const auto &[name, id] : boundaries)
      sums.insert(sums.end(), integrals[id].begin(), integrals[id].end());
    Utilities::MPI::sum(sums, communicator_of(dof_handler), sums);
    std::vector<double> means;
    for (unsigned int i = 0; i < sums.size(); i += dim + 1)
      for (unsigned int d = 0; d < dim; ++d)
        means.push_back(sums[i + d] / sums[i + dim]);
    return means;
  }



  template class BoundaryDisplacements<2>;
  template class BoundaryDisplacements<3>;
} // namespace ElastoPlastic
