// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The contact set on meshes with hanging nodes: which nodes are candidates,
// their areas, the switching tests, projection, and what is summed up.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <limits>

#include "base/compatibility.h"
#include "contact/contact_evaluation.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  /// The unit square or cube under a paraboloid, whose rim is at @p reach.
  template <int dim>
  class Block
  {
  public:
    Block(const unsigned int degree,
          const double       reach,
          const bool         left_is_fixed = false,
          const unsigned int n_refinements = 0)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , reach(reach)
      , contact(
          vertical_bounds<dim>([this](const Point<dim> &x) { return gap(x); }))
    {
      GridGenerator::subdivided_hyper_cube(mesh, 4, 0., 1., true);
      refine_corner(mesh);
      mesh.refine_global(n_refinements);
      dof_handler.distribute_dofs(fe);
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints = empty_constraints(dof_handler);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      zero.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);

      const IndexSet fixed =
        left_is_fixed ?
          DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(), {0}) :
          IndexSet(dof_handler.n_dofs());
      contact.reinit(dof_handler, constraints, {top}, fixed, zero);
      find_nodes(fixed);
    }

    void
    check_candidates() const
    {
      const auto n        = static_cast<unsigned int>(candidates.size());
      double     smallest = std::numeric_limits<double>::infinity();
      for (const auto &dof_and_gap : candidates)
        smallest = std::min(smallest, dof_and_gap.second);
      output() << "  " << contact.n_candidates() << " candidates" << std::endl;
      verify("  all candidates are found",
             contact.n_candidates() == Utilities::MPI::sum(n, MPI_COMM_WORLD));
      verify("  smallest gap",
             contact.min_gap() ==
               Utilities::MPI::min(smallest, MPI_COMM_WORLD));
    }

    /// What hanging nodes penetrate if all candidates touch the indenter.
    double
    hanging_penetration()
    {
      Vector u = zero;
      contact.place(1.);
      contact.activate_touching(zero);
      contact.move_active(u);
      constraints.distribute(u);
      return ContactEvaluation<dim>(contact, u, zero)
        .state()
        .max_hanging_penetration;
    }

    void
    check_areas()
    {
      contact.place(1.);
      contact.activate_touching(zero);
      const ContactState state =
        ContactEvaluation<dim>(contact, zero, constant(1.)).state();
      verify("  areas add up to the surface",
             std::abs(state.contact_area - 1.),
             1e-12);
      verify("  areas are positive",
             state.active_nodes == contact.n_candidates() &&
               state.min_pressure > 0. && state.max_pressure < 1e6);
    }

    void
    check_switching()
    {
      contact.place(depth);
      contact.activate_touching(zero);
      const auto   fingerprint = contact.fingerprint();
      const auto   pressing = constant(1.), pulling = constant(-1.);
      const double n = n_below(depth);
      output() << "  " << contact.n_active() << " active" << std::endl;

      verify("  those that are reached are active", contact.n_active() == n);
      verify("  those that press stay active",
             !contact.update(zero, pressing) && contact.n_active() == n);
      verify("  those that pull leave",
             contact.update(zero, pulling) && contact.n_active() == 0);
      verify("  those that penetrate join",
             contact.update(zero, pulling) && contact.n_active() == n);
      verify("  the same set has the same fingerprint",
             contact.fingerprint() == fingerprint);

      Vector u = zero;
      contact.project(u);
      verify("  feasible set: those that touch and press",
             !contact.update_feasible(u, pressing) && contact.n_active() == n);
      verify("  feasible set: not those that pull",
             contact.update_feasible(u, pulling) && contact.n_active() == 0);
      verify("  another set has another fingerprint",
             contact.fingerprint() != fingerprint);
    }

    /// A force presses on the lowest part of the indenter at least; none at
    /// all on nothing, and the indenter then stands where it just touches.
    void
    check_force()
    {
      Vector u = zero;
      contact.place(depth);
      contact.activate_touching(u);
      contact.set_load({Control::force, 1.});
      contact.update(u, constant(-1.));
      verify("  a force finds the nearest node", contact.n_active() > 0);
      contact.set_load({Control::force, 0.});
      contact.activate_touching(u);
      verify("  without a force none is active", contact.n_active() == 0);
      contact.update(u, constant(1.));
      contact.update_feasible(u, constant(1.));
      verify("  nor later", contact.n_active() == 0);
      u = -0.25;
      contact.settle(u);
      verify("  the indenter just touches",
             std::abs(contact.depth() - contact.min_gap() - 0.25),
             1e-15);
      contact.set_load({Control::depth, depth});
    }

    void
    check_projection()
    {
      contact.place(depth);
      contact.activate_touching(zero);
      Vector expected = zero, projected = zero, moved = zero, marked = zero;
      for (const auto &[dof, gap] : candidates)
        expected(dof) = std::min(0., gap - depth);
      contact.project(projected);
      contact.move_active(moved);
      for (const unsigned int i : contact.active_entries())
        marked.local_element(i) = 1.;
      projected -= expected;
      moved -= expected;
      verify("  projection moves those that penetrate",
             projected.linfty_norm(),
             1e-15);
      verify("  active nodes are moved to the indenter",
             moved.linfty_norm(),
             1e-15);
      verify("  active entries are marked",
             marked.l1_norm() == contact.n_active());
    }

    void
    check_state()
    {
      contact.place(depth);
      contact.activate_touching(zero);
      const Vector       force = constant(2.);
      const ContactState state =
        ContactEvaluation<dim>(contact, zero, force).state();
      output() << "  contact area " << state.contact_area << std::endl;
      verify("  force is the sum of nodal forces",
             std::abs(state.force - 2. * contact.n_active()),
             1e-12);
      verify("  penetration",
             std::abs(state.max_penetration - (depth - contact.min_gap())),
             1e-15);

      Vector u = zero;
      contact.project(u);
      const ContactState projected =
        ContactEvaluation<dim>(contact, u, zero).state();
      verify("  no penetration after projection",
             projected.max_penetration,
             1e-15);

      Vector gap = zero, pressure = zero, active = zero;
      ContactEvaluation<dim>(contact, u, force)
        .surface_fields(gap, pressure, active);
      verify("  fields: no gap where active", std::abs(gap * active), 1e-13);
      verify("  fields: pressure only where active",
             std::abs(pressure.l1_norm() - pressure * active),
             1e-12 * pressure.l1_norm());
      verify("  fields: as many active nodes",
             active.l1_norm() == state.active_nodes);
    }

  private:
    static constexpr types::boundary_id top   = 2 * dim - 1;
    static constexpr double             depth = 0.03;

    double
    gap(const Point<dim> &x) const
    {
      double distance_square = 0;
      for (unsigned int d = 0; d < dim - 1; ++d)
        distance_square += Utilities::fixed_power<2>(x[d] - 0.6);
      return distance_square <= reach * reach ?
               0.2 * distance_square :
               std::numeric_limits<double>::infinity();
    }

    Vector
    constant(const double value) const
    {
      Vector vector = zero;
      vector        = value;
      return vector;
    }

    /// Finds the candidates that this rank owns by looking at all nodes.
    void
    find_nodes(const IndexSet &fixed)
    {
      ComponentMask vertical(dim, false);
      vertical.set(dim - 1, true);
      const IndexSet dofs = DoFTools::extract_dofs(dof_handler, vertical);
      std::map<types::global_dof_index, Point<dim>> points;
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                           dof_handler,
                                           points);
      for (const auto dof : dofs)
        if (points[dof][dim - 1] > 1. - 1e-12 &&
            !constraints.is_constrained(dof) && !fixed.is_element(dof) &&
            std::isfinite(gap(points[dof])))
          candidates[dof] = gap(points[dof]);
    }

    /// The number of candidates on all ranks with a gap below @p distance.
    unsigned int
    n_below(const double distance) const
    {
      const unsigned int n =
        std::count_if(candidates.begin(),
                      candidates.end(),
                      [=](const auto &dof_and_gap) {
                        return dof_and_gap.second < distance;
                      });
      return Utilities::MPI::sum(n, MPI_COMM_WORLD);
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    const double                              reach;
    ContactSet<dim>                           contact;
    Vector                                    zero;

    std::map<types::global_dof_index, double> candidates;
  };



  /// Under a paraboloid, linear interpolation penetrates by h^2/(8R);
  /// quadratic interpolation is exact.
  void
  check_hanging_penetration()
  {
    output() << "Hanging nodes" << std::endl;
    const auto penetration = [](const unsigned int degree,
                                const unsigned int n_refinements) {
      return Block<3>(degree, 2., false, n_refinements).hanging_penetration();
    };
    const double coarse = penetration(1, 0);
    verify("  penetrate", coarse > 1e-4);
    verify("  by a quarter if h is halved",
           std::abs(penetration(1, 1) / coarse - 0.25),
           1e-10);
    verify("  not if p = 2", penetration(2, 0), 1e-14);
  }



  template <int dim>
  void
  check_blocks()
  {
    for (const unsigned int degree : {1, 2})
      {
        output() << dim << "D, p = " << degree << ", wide indenter"
                 << std::endl;
        Block<dim> whole_surface(degree, 2.);
        whole_surface.check_candidates();
        whole_surface.check_areas();

        output() << dim << "D, p = " << degree << ", fixed on the left"
                 << std::endl;
        Block<dim>(degree, 2., /* left_is_fixed = */ true).check_candidates();

        output() << dim << "D, p = " << degree << ", narrow indenter"
                 << std::endl;
        Block<dim> part(degree, 0.43);
        part.check_candidates();
        part.check_switching();
        part.check_force();
        part.check_projection();
        part.check_state();
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_blocks<2>();
  check_blocks<3>();
  check_hanging_penetration();
}
