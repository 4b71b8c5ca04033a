// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Hanging nodes and constraints between the unknowns of a node: expansion gives
// what AffineConstraints does, on the entries of other ranks, too, and can be
// undone; condensation is the transpose.

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include <numeric>

#include "base/compatibility.h"
#include "mechanics/eliminated_unknowns.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  /// A mesh with hanging nodes at whose left face one component follows another
  /// one.
  template <int dim>
  class Sample
  {
  public:
    Sample()
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(2), dim)
      , dof_handler(mesh)
    {
      GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
      refine_corner(mesh);
      dof_handler.distribute_dofs(fe);
      relevant    = DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints = empty_constraints(dof_handler);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      for (const auto dof : DoFTools::extract_boundary_dofs(
             dof_handler, ComponentMask(first_component()), {0}))
        {
          constraints.add_line(dof);
          constraints.add_entry(dof, dof + 1, 0.4);
        }
      constraints.close();
    }

    void
    check() const
    {
      Vector vector = field(0);
      vector.update_ghost_values();
      EliminatedUnknowns<dim, double> eliminated;
      eliminated.reinit(constraints, *vector.get_partitioner());

      Vector expected = vector;
      constraints.distribute(expected);
      expected.update_ghost_values();
      const std::vector<double> before = entries(vector);
      eliminated.expand(vector);
      verify("  expands",
             difference(entries(vector), entries(expected)) /
               expected.linfty_norm(),
             1e-14);
      eliminated.restore(vector);
      verify("  can be undone", entries(vector) == before);

      // forces that some cells of each rank have added, also to ghosts
      Vector forces = field(1);
      forces.update_ghost_values();
      forces.set_ghost_state(false);
      vector.update_ghost_values();
      eliminated.expand(vector);
      const std::vector<double> u = entries(vector), f = entries(forces);
      const double              work = Utilities::MPI::sum(
        std::inner_product(u.begin(), u.end(), f.begin(), 0.), MPI_COMM_WORLD);

      eliminated.condense(forces);
      for (const auto &line : constraints.get_lines())
        verify_zero(forces, line.index);
      forces.compress(VectorOperation::add);
      vector.zero_out_ghost_values();
      verify("  condensation is the transpose",
             std::abs(forces * vector / work - 1.),
             1e-12);
    }

  private:
    static std::vector<bool>
    first_component()
    {
      std::vector<bool> mask(dim, false);
      mask.front() = true;
      return mask;
    }

    /// Of this rank, ghosts included.
    static std::vector<double>
    entries(const Vector &vector)
    {
      return {vector.begin(),
              vector.end() + vector.get_partitioner()->n_ghost_indices()};
    }

    Vector
    field(const unsigned int number) const
    {
      Vector vector(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
      VectorTools::interpolate(dof_handler,
                               SampleField<dim>(number, 1.),
                               vector);
      return vector;
    }

    static double
    difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      double largest = 0;
      for (unsigned int i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
      return Utilities::MPI::max(largest, MPI_COMM_WORLD);
    }

    static void
    verify_zero(Vector &forces, const types::global_dof_index dof)
    {
      const auto &layout = *forces.get_partitioner();
      if ((layout.in_local_range(dof) || layout.is_ghost_entry(dof)) &&
          forces.local_element(layout.global_to_local(dof)) != 0.)
        throw ExcInternalError();
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    IndexSet                                  relevant;
    AffineConstraints<double>                 constraints;
  };
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << "2D" << std::endl;
  Sample<2>().check();
  output() << "3D" << std::endl;
  Sample<3>().check();
}
