// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// States at the points of a mesh of which some cells are divided and others
// put together: polynomials that the points of a cell determine are
// reproduced, the integral of anything else is kept. Saved with the mesh and
// loaded, they are the same.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>

#include "base/compatibility.h"
#include "mechanics/state_transfer.h"
#include "mesh/material_ids.h"
#include "restart/saved_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;



  /// Calls body(cell, points and weights) for all cells of this rank.
  template <int dim, typename Body>
  void
  for_each_cell(const Mesh<dim>   &mesh,
                const unsigned int degree,
                const Body        &body)
  {
    const FE_Nothing<dim> no_fields;
    FEValues<dim>         points(no_fields,
                         QGauss<dim>(degree + 1),
                         update_quadrature_points | update_JxW_values);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          points.reinit(cell);
          body(cell, points);
        }
  }



  /// Two numbers at a point: a product of polynomials of the given degree in
  /// each coordinate, and something that is no polynomial.
  template <int dim>
  std::array<double, 2>
  sample_values(const Point<dim> &x, const unsigned int degree)
  {
    double product = 1;
    for (unsigned int d = 0; d < dim; ++d)
      product *= 0.3 + d + std::pow(x[d], degree) - 0.7 * x[d];
    return {{product, x[0] > 0.3 ? std::sin(7 * x[1]) : 0.}};
  }



  template <int dim>
  CellStates
  sample_states(const Mesh<dim> &mesh, const unsigned int degree)
  {
    CellStates states(mesh.n_active_cells());
    for_each_cell(mesh, degree, [&](const auto &cell, const auto &points) {
      for (const auto &x : points.get_quadrature_points())
        for (const double value : sample_values(x, degree))
          states[cell->active_cell_index()].push_back(value);
    });
    return states;
  }



  /// The integrals of both numbers.
  template <int dim>
  std::vector<double>
  integrals(const Mesh<dim>   &mesh,
            const unsigned int degree,
            const CellStates  &states)
  {
    std::vector<double> sums(2, 0.);
    for_each_cell(mesh, degree, [&](const auto &cell, const auto &points) {
      for (const unsigned int q : points.quadrature_point_indices())
        for (unsigned int i = 0; i < 2; ++i)
          sums[i] +=
            states[cell->active_cell_index()][2 * q + i] * points.JxW(q);
    });
    Utilities::MPI::sum(sums, communicator_of(mesh), sums);
    return sums;
  }



  template <int dim>
  double
  largest_error(const Mesh<dim>   &mesh,
                const unsigned int degree,
                const CellStates  &states)
  {
    double error = 0;
    for_each_cell(mesh, degree, [&](const auto &cell, const auto &points) {
      for (const unsigned int q : points.quadrature_point_indices())
        error = std::max(error,
                         std::abs(states[cell->active_cell_index()][2 * q] -
                                  sample_values(points.quadrature_point(q),
                                                degree)[0]));
    });
    return Utilities::MPI::max(error, communicator_of(mesh));
  }



  /// Divides the cells around the origin, and puts those far from it together.
  template <int dim>
  void
  change(Mesh<dim>          &mesh,
         StateTransfer<dim> &transfer,
         const CellStates   &states)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          if (cell->center().norm() < 0.4)
            cell->set_refine_flag();
          else if (cell->center().norm() > 0.7)
            cell->set_coarsen_flag();
        }
    mesh.prepare_coarsening_and_refinement();
    transfer.prepare(states);
    mesh.execute_coarsening_and_refinement();
  }



  template <int dim>
  void
  test(const unsigned int degree)
  {
    output() << dim << "D, degree " << degree << std::endl;
    Mesh<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh);
    mesh.refine_global(3);

    const CellStates   old_states    = sample_states(mesh, degree);
    const auto         old_integrals = integrals(mesh, degree, old_states);
    StateTransfer<dim> transfer(mesh, degree, /* n_materials = */ 1);
    change(mesh, transfer, old_states);
    const CellStates states = transfer.take();

    const auto new_integrals = integrals(mesh, degree, states);
    verify("some cells are larger, others smaller",
           Utilities::MPI::sum(mesh.n_active_cells(2), MPI_COMM_WORLD) > 0 &&
             mesh.n_global_levels() == 5);
    verify("polynomials are reproduced",
           largest_error(mesh, degree, states) < 1e-12);
    verify("integrals are kept",
           std::abs(new_integrals[0] - old_integrals[0]) < 1e-12 &&
             std::abs(new_integrals[1] - old_integrals[1]) < 1e-12 &&
             std::abs(old_integrals[1]) > 1e-3);

    const auto for_each_cell = [](const Mesh<dim>        &a_mesh,
                                  const CellVisitor<dim> &visit,
                                  const CellStates       &values) {
      for (const auto &cell : a_mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          visit(cell, values[cell->active_cell_index()]);
    };
    save_mesh<dim>(
      MPI_COMM_WORLD,
      [&](const CellVisitor<dim> &visit) {
        for_each_cell(mesh, visit, states);
      },
      "mesh");
    Mesh<dim> loaded_mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(loaded_mesh);
    SavedMesh<dim> saved(MPI_COMM_WORLD, "mesh");
    saved.refine(loaded_mesh);
    bool are_same = loaded_mesh.n_active_cells() == mesh.n_active_cells();
    if (are_same)
      for_each_cell(
        loaded_mesh,
        [&](const auto &cell, const std::vector<double> &values) {
          are_same = are_same && saved.values(cell) == values;
        },
        states);
    verify("the same after loading", are_same);
  }



  /// A layer of another material above y = 0.9, which the first mesh, of cells
  /// of 1/4, does not see, and one to the left of x = 0.2, which it sees as one
  /// column of cells. Each point has one number, which is 1.
  void
  test_change_of_material()
  {
    output() << "change of material" << std::endl;
    Mesh<2> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh);
    mesh.refine_global(2);
    set_material_ids("Material id", "if(y > 0.9 || x < 0.2, 1, 0)", mesh);

    const auto n_points_with = [&mesh](const CellStates        &states,
                                       const types::material_id material,
                                       const double             value) {
      unsigned int n = 0;
      for_each_cell(mesh, 1, [&](const auto &cell, const auto &) {
        for (const double entry : states[cell->active_cell_index()])
          if (cell->material_id() == material &&
              std::abs(entry - value) < 1e-12)
            ++n;
      });
      return Utilities::MPI::sum(n, MPI_COMM_WORLD);
    };
    CellStates states(mesh.n_active_cells());
    for_each_cell(mesh, 1, [&](const auto &cell, const auto &) {
      states[cell->active_cell_index()].assign(4, 1.);
    });
    verify("a column of 4 cells of the other material",
           n_points_with(states, 1, 1.) == 4 * 4 &&
             n_points_with(states, 0, 1.) == 12 * 4);

    StateTransfer<2> to_finer(mesh, 1, /* n_materials = */ 2);
    to_finer.prepare(states);
    mesh.refine_global(1);
    states = to_finer.take();
    // 8 cells at the left were of that material before, 6 cells at the top were
    // not; those beside the column at the left have changed to the first one.
    output() << "  second material: " << n_points_with(states, 1, 1.)
             << " points with a past, " << n_points_with(states, 1, 0.)
             << " virgin\n  first material: " << n_points_with(states, 0, 1.)
             << " points with a past, " << n_points_with(states, 0, 0.)
             << " virgin" << std::endl;

    StateTransfer<2> to_coarser(mesh, 1, 2);
    to_coarser.prepare(states);
    mesh.coarsen_global(1);
    states = to_coarser.take();
    output() << "  and back: " << n_points_with(states, 1, 1.) << ", "
             << n_points_with(states, 0, 1.)
             << " points with the past of whole cells" << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      test<2>(degree);
      test<3>(degree);
    }
  test_change_of_material();
}
