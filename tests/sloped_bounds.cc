// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact along the normal of the indenter, above the present places of the
// nodes or on its tangent planes above the undeformed ones, with finite
// strains: on the nodes that touch a paraboloid, and those that its edge is on
// its way to, the tangent with slopes, curvature and the changes of shares is
// the derivative of the forces along the bounds. In two and three dimensions,
// with a given depth and with a given force, without and with friction.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>

#include "base/compatibility.h"
#include "contact/contact_set.h"
#include "material/material_parameters.h"
#include "mechanics/solid_operator.h"
#include "sample_mesh.h"
#include "solver/reduced_unknowns.h"
#include "vector_field.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// A paraboloid over the origin, with the axes x and y, y with half the
  /// curvature and something of both.
  template <int dim>
  IndenterSurface<dim>
  gap(const Point<dim> & /*origin*/, const Point<dim> &x)
  {
    IndenterSurface<dim> surface{-x[dim - 1], {}, {}};
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        surface.curvature[d][d] = 1. / (1. + d);
        for (unsigned int e = 0; e < d; ++e)
          surface.curvature[d][e] = 0.2;
      }
    for (unsigned int d = 0; d < dim - 1; ++d)
      for (unsigned int e = 0; e < dim - 1; ++e)
        {
          surface.slope[d] += surface.curvature[d][e] * x[e];
          surface.height += 0.5 * surface.curvature[d][e] * x[d] * x[e];
        }
    return surface;
  }



  MaterialParameters
  material()
  {
    MaterialParameters parameters;
    parameters.laws             = {MaterialLaw::isotropic_hardening};
    parameters.young_moduli     = {2.};
    parameters.yield_stresses   = {0.02};
    parameters.isotropic_moduli = {0.1};
    return parameters;
  }



  /// A tenth of the height, the same everywhere.
  template <int dim>
  double
  compression(const Point<dim> &x, const unsigned int component)
  {
    return component == dim - 1 ? -0.1 * (1. + x[dim - 1]) : 0.;
  }



  template <int dim>
  class PressedBlock
  {
  public:
    PressedBlock(const Control         control,
                 const ContactGeometry geometry,
                 const double          friction_coefficient)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(1), dim)
      , dof_handler(mesh)
      , solid(1,
              {VolumetricTreatment::b_bar,
               Kinematics::cartesian,
               Strain::logarithmic},
              material().materials())
      , contact(ContactBounds<dim>(gap<dim>, geometry),
                Kinematics::cartesian,
                EdgeRule::within_faces,
                CoulombFriction<dim>(friction_coefficient, 2.))
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = -1.;
          upper[d] = d < dim - 1 ? 1. : 0.;
        }
      std::vector<unsigned int> n_cells(dim, 16);
      n_cells[dim - 1] = 2;
      GridGenerator::subdivided_hyper_rectangle(
        mesh, n_cells, lower, upper, true);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      constraints.close();
      solid.reinit(dof_handler, constraints);
      solid.initialize_vector(u);
      solid.initialize_vector(residual);
      contact.reinit(dof_handler,
                     constraints,
                     {2 * dim - 1},
                     IndexSet(dof_handler.n_dofs()),
                     u);
      touch(control);
    }

    void
    check()
    {
      compute_residual(residual, u);
      const ReducedUnknowns here = unknowns(u, residual);
      VectorType            step = sample(1.);
      here.set_leading_value(step, contact.is_force_driven() ? 0.3 : 0.);

      VectorType product(step), expanded = step;
      here.expand(expanded);
      solid.predict_flow(u, u);
      solid.linearize(u);
      solid.vmult(product, expanded);
      here.reduce_product(product, expanded, step);

      const double h        = 1e-7;
      const auto   set      = contact.fingerprint();
      VectorType   quotient = reduced_forces(expanded, -h);
      quotient -= reduced_forces(expanded, h);
      quotient /= 2. * h;
      quotient -= product;
      verify("  the same nodes are entering", contact.fingerprint() == set);
      verify("  tangent is the derivative of the forces",
             quotient.l2_norm() / product.l2_norm(),
             PackedDeviator<dim>::largest_turn);

      if (!here.is_symmetric())
        return;
      VectorType forces = sample(2.), contracted = forces;
      here.contract(contracted);
      verify("  contraction is the transpose of the expansion",
             std::abs(step * contracted - expanded * forces) /
               std::abs(expanded * forces),
             1e-12);
    }

  private:
    /// Presses the paraboloid into the block, which is compressed around it, so
    /// that the edge of the contact is between nodes.
    void
    touch(const Control control)
    {
      contact.set_load({Control::depth, 0.37});
      VectorTools::interpolate(dof_handler,
                               VectorField<dim>(compression<dim>),
                               u);
      contact.activate_touching(u);
      u.add(0.002, sample(3.));
      contact.move_active(u);
      contact.find_entering(u);
      if (control == Control::force)
        contact.set_load({Control::force, 1.});
      if (contact.has_friction())
        let_slip();
      check_entering();
    }

    /// Nodes that are entering from inside are at their bound, where the
    /// tangent has a jump.
    void
    leave_bounds()
    {
      const auto closed = contact.closed_entries();
      for (const unsigned int i : contact.active_entries())
        if (std::find(closed.begin(), closed.end(), i) == closed.end())
          u.local_element(i) -= 0.008;
      contact.return_to_bounds(u);
      contact.find_entering(u);
    }

    /// (Nodes that pull share nothing.)
    void
    check_entering()
    {
      compute_residual(residual, u);
      bool are_pressed = true, are_stiff = true;
      for (const unsigned int i : contact.active_entries())
        are_pressed = are_pressed && residual.local_element(i) > 0.;
      for (const EnteringUnknown &unknown :
           contact.shared_forces(u, residual).entering)
        are_stiff = are_stiff && unknown.stiffness > 0.;
      verify("  some nodes touch, others are entering",
             contact.n_closed() > 0 && contact.n_active() > contact.n_closed());
      verify("  all press, and what enters has a stiffness",
             !Utilities::MPI::logical_or(!are_pressed || !are_stiff,
                                         MPI_COMM_WORLD));
    }

    /// Some nodes slip. (In an update that follows, those whose slip is against
    /// their force would stick: this is no equilibrium.)
    void
    let_slip()
    {
      contact.begin_step(VectorType(u.get_partitioner()), 0., {});
      compute_residual(residual, u);
      contact.update(u, residual);
      contact.move_active(u);
      contact.find_entering(u);
      leave_bounds();
      const unsigned int n_held =
        Utilities::MPI::sum(contact.stuck_entries().size(), MPI_COMM_WORLD);
      verify("  some nodes stick, others slip",
             n_held > 0 && n_held < (dim - 1) * contact.n_active());
    }

    void
    compute_residual(VectorType &forces, const VectorType &displacement) const
    {
      solid.internal_forces(forces, displacement);
      forces *= -1.;
    }

    ReducedUnknowns
    unknowns(const VectorType &displacement, const VectorType &forces) const
    {
      const auto closed          = contact.closed_entries();
      const bool is_force_driven = contact.is_force_driven();
      auto       held            = contact.stuck_entries();
      if (!is_force_driven)
        held.insert(held.end(), closed.begin(), closed.end());
      ReducedUnknowns result(held,
                             is_force_driven ? closed :
                                               std::vector<unsigned int>(),
                             MPI_COMM_WORLD,
                             contact.shared_forces(displacement, forces));
      result.set_sloped_bounds(contact.sloped_bounds(displacement, forces));
      return result;
    }

    /// Where @p direction and the bounds lead.
    VectorType
    reduced_forces(const VectorType &direction, const double way)
    {
      VectorType moved = u, forces(u);
      moved.add(way, direction);
      contact.return_to_bounds(moved);
      contact.find_entering(moved);
      compute_residual(forces, moved);
      unknowns(moved, forces).contract(forces);
      return forces;
    }

    VectorType
    sample(const double frequency) const
    {
      VectorType vector;
      solid.initialize_vector(vector);
      for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
        vector.local_element(i) =
          std::sin(frequency * vector.get_partitioner()->local_to_global(i));
      return vector;
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    SolidOperator<dim>                        solid;
    ContactSet<dim>                           contact;
    VectorType                                u, residual;
  };



  template <int dim>
  void
  check()
  {
    for (const auto geometry :
         {ContactGeometry::present, ContactGeometry::normal})
      for (const Control control : {Control::depth, Control::force})
        for (const double friction : {0., 0.2})
          {
            output() << dim << "D, "
                     << (geometry == ContactGeometry::present ?
                           "present places" :
                           "tangent planes")
                     << ", given "
                     << (control == Control::force ? "force" : "depth")
                     << (friction > 0. ? ", friction" : "") << std::endl;
            PressedBlock<dim>(control, geometry, friction).check();
          }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>();
  check<3>();
}
