// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// At which pace nodes that violate Coulomb's law begin to slip: all of them at
// once, or first those that do so most, mirror images together.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include "base/compatibility.h"
#include "contact/contact_set.h"
#include "sample_mesh.h"
#include "vector_field.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  constexpr double mu = 0.3;



  /// All nodes press with 1, and the more they are sheared, the farther they
  /// are from the middle: two a third more than friction allows, two a twelfth.
  /// By rounding, the right half is sheared a little more.
  const VectorField<2> forces([](const Point<2>    &x,
                                 const unsigned int component) {
    return component == 1 ? 1. :
                            (x[0] > 0.5 ? 1. + 1e-10 : 1.) *
                              (0.25 + 0.3 * std::abs(x[0] - 0.5));
  });



  /// The five nodes on the unit square below a flat indenter.
  class Block
  {
  public:
    Block()
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<2>(1), 2)
      , dof_handler(mesh)
      , contact(vertical_bounds<2>([](const Point<2> &) { return 0.; }),
                Kinematics::cartesian,
                EdgeRule::at_nodes,
                CoulombFriction<2>(mu, 1.))
    {
      make_columns(mesh, 4);
      dof_handler.distribute_dofs(fe);
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints = empty_constraints(dof_handler);
      constraints.close();
      zero.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
      contact.reinit(
        dof_handler, constraints, {3}, IndexSet(dof_handler.n_dofs()), zero);
      force = zero;
      VectorTools::interpolate(dof_handler, forces, force);
      contact.place(0.1);
      contact.begin_step(zero, 0., {});
      contact.activate_touching(zero);
    }

    /// Prints how many nodes stick before and after one switching test.
    void
    switch_once(const std::string &title, const FrictionPace pace)
    {
      output() << title << ": " << n_stuck();
      contact.update(zero, force, pace);
      output() << ", then " << n_stuck() << std::endl;
    }

  private:
    unsigned int
    n_stuck() const
    {
      return Utilities::MPI::sum<unsigned int>(contact.stuck_entries().size(),
                                               MPI_COMM_WORLD);
    }

    parallel::distributed::Triangulation<2> mesh;
    const FESystem<2>                       fe;
    DoFHandler<2>                           dof_handler;
    AffineConstraints<double>               constraints;
    ContactSet<2>                           contact;
    Vector                                  zero, force;
  };
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << "Nodes that stick" << std::endl;
  Block().switch_once("all that violate the law", FrictionPace::all);
  Block().switch_once("the worst first", FrictionPace::worst_first);
}
