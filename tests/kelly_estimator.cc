// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The estimates are those of deal.II's KellyErrorEstimator: on meshes that are
// refined here and there, with slanting faces, and faces that the two cells see
// in different orientations.

#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/error_estimator.h>

#include "adaptivity/kelly_estimator.h"
#include "base/ghost_values.h"
#include "base/largest_error.h"
#include "mechanics/solid_operator.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;



  /// Refines everywhere, then the cells near the origin, twice, and shears all.
  template <int dim>
  void
  refine_and_shear(Mesh<dim> &mesh)
  {
    mesh.refine_global(1);
    for (const double distance : {0.9, 0.4})
      refine_where(mesh, [&](const auto &cell) {
        return cell->center().norm() < distance;
      });
    GridTools::transform(
      [](const Point<dim> &x) {
        Point<dim> moved = x;
        moved[0] += 0.3 * x[dim - 1] * x[dim - 1];
        moved[dim - 1] += 0.2 * x[0] * x[1];
        return moved;
      },
      mesh);
  }



  template <int dim>
  void
  check(const std::string &name, const Mesh<dim> &mesh)
  {
    for (const unsigned int degree : {1, 2})
      {
        const FESystem<dim> fe(FE_Q<dim>(degree), dim);
        DoFHandler<dim>     dof_handler(mesh);
        dof_handler.distribute_dofs(fe);
        VectorType u(dof_handler.locally_owned_dofs(), MPI_COMM_WORLD);
        for (const auto i : u.locally_owned_elements())
          u(i) = std::sin(1. + 7. * i);

        Vector<float> exact(mesh.n_active_cells());
        KellyErrorEstimator<dim>::estimate(MappingQ1<dim>(),
                                           dof_handler,
                                           QGauss<dim - 1>(degree + 1),
                                           {},
                                           ghosted_copy(u, dof_handler),
                                           exact);
        const Vector<float> found =
          KellyEstimator<dim>(fe).estimate(dof_handler, u);
        double difference = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          if (const unsigned int i = cell->active_cell_index();
              cell->is_locally_owned())
            keep_largest(difference, std::abs(found(i) / exact(i) - 1.));
        verify(name + ", degree " + std::to_string(degree),
               Utilities::MPI::max(difference, MPI_COMM_WORLD),
               1e-6);
      }
  }



  template <int dim>
  void
  check_ball()
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_ball(mesh);
    refine_and_shear(mesh);
    verify("hanging nodes", mesh.has_hanging_nodes());
    check("ball in " + std::to_string(dim) + " dimensions", mesh);
  }
} // namespace



int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_ball<2>();
  check_ball<3>();
  for (unsigned int i = 0; i < 8; ++i)
    {
      const bool orientation = i & 1, flip = i & 2, rotation = i & 4;
      Mesh<3>    mesh(MPI_COMM_WORLD);
      GridGenerator::non_standard_orientation_mesh(
        mesh, orientation, flip, rotation, /* manipulate_left_cube = */ false);
      refine_and_shear(mesh);
      check("two cubes, orientation " + std::to_string(i), mesh);
    }
}
