// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Spots of contact: a round one in a corner between planes of symmetry, and a
// small one that is apart; their radii, their forces, how many elements they
// are wide, what is said of them, and how large elements around them should be.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <cmath>

#include "adaptivity/contact_zone.h"
#include "base/compatibility.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  constexpr double       radius = 0.5, small_radius = 0.15, side = 1.;
  constexpr unsigned int n_cells = 40;

  /// The distance from the edges of the two spots.
  template <int dim>
  double
  gap(const Point<dim> &x)
  {
    Point<dim> corner, apart;
    for (unsigned int d = 0; d < dim - 1; ++d)
      apart[d] = 0.8;
    corner[dim - 1] = apart[dim - 1] = side;
    return std::min(x.distance(corner) - radius,
                    x.distance(apart) - small_radius);
  }



  /// The unit square or cube, with symmetry on the sides where a horizontal
  /// coordinate vanishes.
  template <int dim>
  void
  check(const unsigned int degree)
  {
    output() << dim << "D, degree " << degree << std::endl;
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    make_columns(mesh, n_cells / degree);
    const FESystem<dim> fe(FE_Q<dim>(degree), dim);
    DoFHandler<dim>     dof_handler(mesh);
    dof_handler.distribute_dofs(fe);
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    AffineConstraints<double> none = empty_constraints(dof_handler);
    none.close();
    IndexSet fixed(dof_handler.n_dofs());
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        ComponentMask component(dim, false);
        component.set(d, true);
        fixed.add_indices(
          DoFTools::extract_boundary_dofs(dof_handler, component, {2 * d}));
      }

    Vector zero(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
    ContactSet<dim> contact(vertical_bounds<dim>(gap<dim>));
    contact.reinit(
      dof_handler, none, {2 * dim - 1}, IndexSet(fixed.size()), zero);
    contact.place(0.);
    const auto zone = [&](const Vector &residual) {
      return ContactZone<dim>(
        dof_handler, none, fixed, {2 * dim - 1}, contact, zero, residual);
    };
    const Point<dim> middle;
    verify("  no contact, no size",
           std::isinf(zone(zero).element_size(middle, 0., 10, 0.)));

    contact.activate_touching(zero);
    Vector forces = zero;
    for (const unsigned int i : contact.active_entries())
      forces.local_element(i) = 1.;
    const ContactZone<dim> found = zone(forces);
    verify("  two spots", found.spots().size() == 2);
    const auto &corner =
      found.spots()[0].center[0] < 0.5 ? found.spots()[0] : found.spots()[1];
    const auto &apart =
      found.spots()[0].center[0] < 0.5 ? found.spots()[1] : found.spots()[0];
    const double h = side / n_cells;
    verify("  radius of the whole of a quarter",
           std::abs(corner.radius - radius) < 0.6 * h * degree);
    verify("  radius of a spot apart",
           std::abs(apart.radius - small_radius) < 0.6 * h * degree);
    verify("  its place", std::abs(apart.center[0] - 0.8), 1e-12);
    verify("  elements over a diameter",
           std::abs(apart.elements_across * degree - 2. * small_radius / h) <
             2.);
    verify("  all forces are on a spot",
           std::abs(corner.force + apart.force - contact.n_active()) < 1e-9);

    Point<dim> at_edge;
    at_edge[0]       = radius;
    at_edge[dim - 1] = side;
    Point<dim> inside;
    inside[dim - 1]   = side;
    const double size = corner.radius / 10.;
    verify("  size under the contact",
           std::abs(found.element_size(inside, 0., 10, 0.) - size) <
             1e-12 * size);
    verify("  size at its edge, which will move",
           std::abs(found.element_size(at_edge, 0., 10, 0.1) -
                    size / (dim == 2 ? 4. : 2.)) < 1e-12 * size);
    verify("  size away from it",
           found.element_size(middle, 0., 10, 0.) -
             found.element_size(middle, 0.25, 10, 0.) -
             (dim == 2 ? 0.15 : 0.25) * 0.25,
           1e-12);

    verify("  enough elements", degree > 1 || found.warning(0.).empty());
    verify("  pixels that are not resolved",
           degree > 1 ||
             found.warning(0.5 * h).find("pixels") != std::string::npos);
    verify("  few elements",
           degree == 1 ||
             found.warning(0.).find("fewer than 8") != std::string::npos);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>(1);
  check<2>(2);
  check<3>(1);
}
