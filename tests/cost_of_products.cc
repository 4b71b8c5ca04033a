// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// cost_of_products [CELLS_PER_DIRECTION]
//
// Measures what the time of a run is made of: products with the tangent of the
// problem and of a level of multigrid, forces, and vector updates, on a cube of
// so many linear elements (half as many quadratic ones) per direction and rank,
// beside what the machine can do at most: bytes that it moves (STREAM triad)
// and operations of its SIMD units. Writes a table of numbers separated by
// commas; `scripts/verify.py --tables cost_of_products` makes that of
// doc/develop/speed.md of it. All ranks work at the same time.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "base/compatibility.h"
#include "material/material_parameters.h"
#include "mechanics/cell_kernel.h"
#include "mechanics/solid_operator.h"

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int dim = 3;

  /// Seconds of the fastest of several calls, on the slowest rank.
  double
  seconds(const std::function<void()> &work)
  {
    double fastest = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < 12; ++i)
      {
        MPI_Barrier(MPI_COMM_WORLD);
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> time =
          std::chrono::steady_clock::now() - begin;
        fastest =
          std::min(fastest, Utilities::MPI::max(time.count(), MPI_COMM_WORLD));
      }
    return fastest;
  }



  /// In GB/s and rank: a = b + s c, of which a is also read before it is
  /// written (McCalpin 1995).
  double
  triad()
  {
    constexpr std::size_t size = 20'000'000;
    std::vector<double>   a(size, 1.), b(size, 2.), c(size, 3.);
    const double          time = seconds([&]() {
      for (std::size_t i = 0; i < size; ++i)
        a[i] = b[i] + 3. * c[i];
    });
    return 4. * sizeof(double) * size / time * 1e-9;
  }



  /// In 10^9 operations per second and rank: multiply and add, in more
  /// independent chains than the latency of one is long.
  template <typename Number>
  double
  peak()
  {
    using Batch                          = Simd<Number>;
    constexpr unsigned int      n_chains = 12, n_steps = 2'000'000;
    std::array<Batch, n_chains> x;
    x.fill(Batch(Number(1.)));
    const Batch  factor(Number(0.999)), summand(Number(0.001));
    const double time = seconds([&]() {
      std::array<Batch, n_chains> in_registers = x;
      for (unsigned int i = 0; i < n_steps; ++i)
        for (Batch &chain : in_registers)
          chain = chain * factor + summand;
      x = in_registers;
    });
    Number       sum  = 0.;
    for (const Batch &chain : x)
      sum += chain[0];
    AssertThrow(std::abs(sum - n_chains) < 1e-3, ExcInternalError());
    return 2. * Batch::size() * n_chains * n_steps / time * 1e-9;
  }



  /// Of a product on one cell: for each component, gradients at the quadrature
  /// points and back by sums over one direction after the other (to the points,
  /// then derivatives between them), and at each point about 130 for strain,
  /// stress and mean volumetric strain.
  double
  operations_per_cell(const unsigned int degree)
  {
    const double n        = degree + 1;
    const double n_points = n * n * n;
    return 2. * dim * 6. * n * n * (2. * n * n) + 130. * n_points;
  }



  /// Of a product mode by mode: sums and differences of the numbers of nodes,
  /// for each component 4 on each of 12 edges or, if elements are quadratic, 13
  /// on each of 27 lines; and in each mode about 60 operations for gradient,
  /// stress and forces.
  double
  operations_by_modes(const unsigned int degree)
  {
    return degree == 1 ? 3. * 4. * 12. + 7. * 60. : 3. * 13. * 27. + 26. * 60.;
  }



  /// A cube that every rank has the same number of cells of.
  class Body
  {
  public:
    Body(const unsigned int degree, const unsigned int n_per_direction)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
    {
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      GridGenerator::subdivided_hyper_rectangle(mesh,
                                                {n_per_direction,
                                                 n_per_direction,
                                                 n_per_direction * n_ranks},
                                                Point<dim>(),
                                                Point<dim>(1., 1., n_ranks));
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      constraints.close();
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
  };



  /// Bytes of one number, what a kernel is, and what it does and moves on one
  /// cell beside its vectors.
  struct Kernel
  {
    std::string           name;
    std::size_t           number_size;
    double                operations, bytes_of_cells, n_vectors;
    std::function<void()> work;
  };



  void
  print(const Body &body, const unsigned int degree, const Kernel &kernel)
  {
    const double time    = seconds(kernel.work);
    const double n_cells = body.mesh.n_locally_owned_active_cells();
    const double n_dofs  = body.dof_handler.n_locally_owned_dofs();
    const double bytes   = kernel.n_vectors * kernel.number_size * n_dofs +
                         kernel.bytes_of_cells * n_cells;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << kernel.name << ',' << degree << ',' << kernel.number_size
                << ',' << 1e9 * time / n_cells << ','
                << kernel.operations * n_cells / n_dofs << ',' << bytes / n_dofs
                << ',' << 1e-9 * kernel.operations * n_cells / time << ','
                << 1e-9 * bytes / time << std::endl;
  }



  void
  measure(const unsigned int degree, const unsigned int n_per_direction)
  {
    const Body         body(degree, n_per_direction);
    const StrainModel  strain_model(VolumetricTreatment::b_bar);
    const auto         materials = MaterialParameters().materials();
    SolidOperator<dim> flowing(degree, strain_model, materials),
      elastic(degree, strain_model, materials);
    VectorType u, forces;
    for (SolidOperator<dim> *const solid : {&flowing, &elastic})
      {
        solid->reinit(body.dof_handler, body.constraints);
        solid->initialize_vector(u);
        solid->initialize_vector(forces);
        if (solid == &flowing)
          for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
            u.local_element(i) = 0.1 * std::sin(i);
        solid->predict_flow(u, u);
        solid->linearize(u);
      }

    const auto level = make_level_kernel<dim>(degree, strain_model);
    level->reinit(body.dof_handler, body.constraints);
    CellTangents<dim> tangents(strain_model.is_finite());
    tangents.reinit(level->n_batches());
    for (unsigned int batch = 0; batch < level->n_batches(); ++batch)
      for (const unsigned int modulus : {0, 1})
        tangents.value(batch, modulus) = 1.f;
    level->prepare_products(tangents);
    CellKernel<dim, CellTangents<dim>>::Vector x, y;
    level->initialize_vector(x);
    level->initialize_vector(y);
    x = 1e-6f;

    // Of a cell: indices of its nodes; and tangents, at all its points or one.
    // (Those of cells that are boxes share their Jacobians.)
    const double indices =
      sizeof(unsigned int) * body.fe.n_dofs_per_cell() / dim;
    const double at_points = Utilities::fixed_power<dim>(degree + 1.) *
                             PointTangents<dim>::bytes_of_flowing_point;
    const double of_tangent = sizeof(float) * Tangent<dim, float>::n_values;
    const std::vector<Kernel> kernels = {{"product where the body flows",
                                          sizeof(double),
                                          operations_per_cell(degree),
                                          indices + at_points,
                                          3,
                                          [&]() {
                                            flowing.vmult(forces, u);
                                          }},
                                         {"product where it is elastic",
                                          sizeof(double),
                                          operations_by_modes(degree),
                                          indices,
                                          3,
                                          [&]() {
                                            elastic.vmult(forces, u);
                                          }},
                                         {"product of a level",
                                          sizeof(float),
                                          operations_by_modes(degree),
                                          indices + of_tangent,
                                          3,
                                          [&]() {
                                            level->vmult(y, x, tangents);
                                          }},
                                         {"vector update",
                                          sizeof(float),
                                          2. * body.dof_handler.n_dofs() /
                                            body.mesh.n_global_active_cells(),
                                          0,
                                          3,
                                          [&]() {
                                            y.add(1e-3f, x);
                                          }}};
    for (const Kernel &kernel : kernels)
      print(body, degree, kernel);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int n = argc > 1 ? Utilities::string_to_int(argv[1]) : 48;
  const double       bandwidth = triad(), in_double = peak<double>(),
               in_single = peak<float>();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "name,degree,bytes_of_number,ns_per_cell,operations,bytes,"
                 "gflops,gb_per_s"
              << std::endl
              << "machine,0,8,0,0,0," << in_double << ',' << bandwidth
              << std::endl
              << "machine,0,4,0,0,0," << in_single << ',' << bandwidth
              << std::endl;
  measure(1, n);
  measure(2, n / 2);
}
