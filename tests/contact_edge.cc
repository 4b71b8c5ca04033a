// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A contact that ends within faces: the touched area, which does not depend on
// the nodes; the forces of nodes that touch and of nodes that are about to; and
// the expansion of reduced vectors that goes with it.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <cmath>

#include "base/compatibility.h"
#include "contact/contact_evaluation.h"
#include "sample_mesh.h"
#include "solver/reduced_unknowns.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  /// The unit square or cube under an indenter that touches it up to the
  /// distance @p radius from a corner, and from there on rises as under Hertz'
  /// sphere. (So far inside that all nodes there are closed, whatever those
  /// outside allow.)
  template <int dim>
  class TouchedBlock
  {
  public:
    TouchedBlock(const unsigned int degree,
                 const double       radius,
                 const Kinematics   kinematics = Kinematics::cartesian,
                 const EdgeRule     rule       = EdgeRule::within_faces)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , contact(vertical_bounds<dim>([radius](const Point<dim> &x) {
                  Point<dim> on_surface    = x;
                  on_surface[dim - 1]      = 0.;
                  const double behind_edge = on_surface.norm() - radius;
                  return behind_edge > 0. ? std::pow(behind_edge, 1.5) :
                                            behind_edge - 0.5;
                }),
                kinematics,
                rule)
    {
      make_columns(mesh, 12);
      dof_handler.distribute_dofs(fe);
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      zero.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
      no_constraints = empty_constraints(dof_handler);
      no_constraints.close();
      contact.reinit(dof_handler,
                     no_constraints,
                     {2 * dim - 1},
                     IndexSet(dof_handler.n_dofs()),
                     zero);
      contact.place(0.);
      contact.activate_touching(zero);
    }

    double
    area() const
    {
      return ContactEvaluation<dim>(contact, zero, zero).state().contact_area;
    }

    void
    check_forces() const
    {
      const Vector forces     = sample(2.);
      const auto   shared     = contact.shared_forces(zero, forces);
      const auto   n_entering = contact.n_active() - contact.n_closed();
      bool         are_stiff  = true;
      for (const EnteringUnknown &unknown : shared.entering)
        are_stiff = are_stiff && unknown.stiffness > 0.;
      verify("  some nodes are entering, with a stiffness",
             n_entering > 0 &&
               Utilities::MPI::sum(shared.entering.size(), MPI_COMM_WORLD) ==
                 n_entering &&
               !Utilities::MPI::logical_or(!are_stiff, MPI_COMM_WORLD));
      double all_forces = 0;
      for (const double force : contact.vertical_forces_on_body(forces))
        all_forces -= force;
      verify("  the force of the indenter is that on all of them",
             std::abs(
               Utilities::MPI::sum(all_forces, MPI_COMM_WORLD) -
               ContactEvaluation<dim>(contact, zero, forces).state().force),
             1e-12);
    }

    void
    check_expansion(const bool are_coupled) const
    {
      output() << (are_coupled ? "  coupled" : "  constrained") << std::endl;
      const auto closed = contact.closed_entries();
      using Entries     = std::vector<unsigned int>;
      const ReducedUnknowns unknowns(are_coupled ? Entries() : closed,
                                     are_coupled ? closed : Entries(),
                                     MPI_COMM_WORLD,
                                     contact.shared_forces(zero, sample(2.)));
      Vector reduced = sample(1.), forces = sample(3.);
      unknowns.set_leading_value(reduced, are_coupled ? 0.7 : 0.);
      Vector expanded = reduced, contracted = forces;
      unknowns.expand(expanded);
      unknowns.contract(contracted);
      const double work = expanded * forces;
      verify("    contraction is the transpose of the expansion",
             std::abs(reduced * contracted - work) < 1e-12 * std::abs(work));

      // (of reduced forces: nothing is left at closed nodes)
      unknowns.set_leading_value(forces, are_coupled ? 0.4 : 0.);
      Vector bound = reduced, released = forces;
      unknowns.bind_entering(bound);
      unknowns.release_entering(released);
      const double own_work = bound * forces;
      verify("    so are the two of preconditioners",
             std::abs(released * reduced - own_work) <
               1e-12 * std::abs(own_work));

      if (are_coupled)
        check_motion(unknowns);
    }

  private:
    /// A rigid motion of the indenter, and one of all.
    void
    check_motion(const ReducedUnknowns &unknowns) const
    {
      Vector moved = zero, expected = zero;
      unknowns.set_leading_value(moved, 1.);
      unknowns.expand(moved);
      for (const unsigned int i : contact.active_entries())
        expected.local_element(i) = 1.;
      moved -= expected;
      verify("    all nodes that bear force move with the indenter",
             moved.linfty_norm(),
             1e-14);

      Vector one = zero;
      one        = 1.;
      unknowns.reduce_motion(one, 1.);
      unknowns.expand(one);
      one.add(-1.);
      verify("    a rigid motion of all is one", one.linfty_norm(), 1e-14);
    }

    Vector
    sample(const double frequency) const
    {
      Vector vector = zero;
      for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
        vector.local_element(i) =
          2. +
          std::sin(frequency * vector.get_partitioner()->local_to_global(i));
      return vector;
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 no_constraints;
    ContactSet<dim>                           contact;
    Vector                                    zero;
  };



  /// For radii between one node and the next but one.
  template <int dim>
  double
  largest_error_of_area(const unsigned int degree,
                        const Kinematics   kinematics,
                        const EdgeRule     rule = EdgeRule::within_faces)
  {
    double error = 0;
    for (double radius = 0.51; radius < 0.67; radius += 0.013)
      {
        const double exact = kinematics == Kinematics::axisymmetric ?
                               numbers::PI * radius * radius :
                             dim == 2 ? radius :
                                        0.25 * numbers::PI * radius * radius;
        error              = std::max(
          error,
          std::abs(TouchedBlock<dim>(degree, radius, kinematics, rule).area() /
                     exact -
                   1.));
      }
    return error;
  }



  template <int dim>
  void
  check(const unsigned int degree, const double error_of_area)
  {
    output() << dim << "D, degree " << degree << std::endl;
    verify("  area",
           largest_error_of_area<dim>(degree, Kinematics::cartesian),
           error_of_area);
    const TouchedBlock<dim> block(degree, 0.57);
    block.check_forces();
    block.check_expansion(false);
    block.check_expansion(true);
    // (in space, the lumped areas of quadratic elements are as good)
    if (dim == 2 || degree == 1)
      verify("  closer than the area that counts nodes",
             largest_error_of_area<dim>(degree, Kinematics::cartesian),
             largest_error_of_area<dim>(degree,
                                        Kinematics::cartesian,
                                        EdgeRule::at_nodes));
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>(1, 1e-12);
  check<2>(2, 0.02);
  check<3>(1, 0.06);
  check<3>(2, 0.03);
  const double error = largest_error_of_area<2>(1, Kinematics::axisymmetric);
  verify("rings", error, 1e-12);
  verify("  closer than the area that counts nodes",
         error,
         largest_error_of_area<2>(1,
                                  Kinematics::axisymmetric,
                                  EdgeRule::at_nodes));
}
