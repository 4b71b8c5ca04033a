// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The patch test with contact: a laterally confined block under a flat
// indenter is in uniaxial strain, exactly, on any mesh. Here the mesh is
// distorted and has hanging nodes, on the contact surface too. All stresses,
// the pressures and the force must be exact, or the depth if the force is
// given. Put together from the parts, without the big class.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include "contact/contact_evaluation.h"
#include "contact_run/contact_problem.h"
#include "material/material_parameters.h"
#include "multigrid/make_tangent_solver.h"
#include "sample_mesh.h"
#include "sample_model.h"
#include "solver/semismooth_newton.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double strain = 0.005;

  /// The axial and the lateral stress at uniaxial compression by the strain,
  /// in closed form.
  std::pair<double, double>
  exact_stress(const Material<double> &m)
  {
    const double norm = std::sqrt(2. / 3.) * strain; // of the strain deviator
    const double multiplier = (2 * m.shear_modulus * norm - m.yield_radius) /
                              (2 * m.shear_modulus + m.isotropic_modulus);
    const double deviator = 2 * m.shear_modulus * (norm - multiplier);
    return {-m.bulk_modulus * strain - std::sqrt(2. / 3.) * deviator,
            -m.bulk_modulus * strain + std::sqrt(1. / 6.) * deviator};
  }



  template <int dim>
  void
  make_mesh(parallel::distributed::Triangulation<dim> &mesh)
  {
    GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
    GridTools::transform(
      [](Point<dim> x) {
        const Point<dim> old = x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] += 0.1 * std::sin(numbers::PI * old[d]) *
                  std::cos(1. + 2. * old[(d + 1) % dim] + d);
        return x;
      },
      mesh);
    refine_corner(mesh);
  }



  template <int dim>
  void
  run(const unsigned int        degree,
      const VolumetricTreatment treatment,
      const Control             control)
  {
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh);
    const FESystem<dim> fe(FE_Q<dim>(degree), dim);
    DoFHandler<dim>     dof_handler(mesh);
    dof_handler.distribute_dofs(fe);

    BoundaryConditionParameters conditions;
    BoundaryNames               names;
    for (unsigned int id = 0; id < 2 * dim - 1; ++id)
      {
        names["side" + std::to_string(id)] = id;
        conditions.roller.push_back("side" + std::to_string(id));
      }
    names["top"]       = 2 * dim - 1;
    conditions.contact = {"top"};

    const Model<dim> model =
      sample_model(BoundaryConditions<dim>(conditions, names), treatment);
    Supports<dim> supports(model);
    supports.reinit(dof_handler, 0.);

    const auto solid =
      std::make_unique<SolidOperator<dim>>(degree, treatment, model.materials);
    solid->reinit(dof_handler, supports.constraints());
    VectorType u, residual, no_forces;
    solid->initialize_vector(u);
    solid->initialize_vector(residual);
    solid->initialize_vector(no_forces);

    ContactSet<dim> contact(vertical_bounds<dim>(
      [](const Point<dim> &x) { return 1. - x[dim - 1]; }));
    contact.reinit(dof_handler,
                   supports.constraints(),
                   {names["top"]},
                   supports.fixed_dofs(),
                   u);
    const auto [axial, lateral] = exact_stress(model.materials[0]);
    const bool by_force         = (control == Control::force);
    contact.set_load({control, by_force ? -axial : strain});

    const auto tangent_solver =
      make_tangent_solver(LinearSolverParameters(),
                          model,
                          *solid,
                          dof_handler,
                          supports.constraints(),
                          [](const std::string &warning) {
                            std::cout << warning << std::endl;
                          });
    TimerOutput timer(std::cout, TimerOutput::never, TimerOutput::wall_times);
    NewtonParameters newton;
    newton.tolerance = 1e-12;
    contact.activate_touching(u);
    ContactProblem<dim> problem(
      *solid, supports, no_forces, contact, *tangent_solver, 1., 0., timer);
    SemismoothNewton(newton, [](const NewtonStep &) {}).solve(problem, u);
    problem.compute_residual(residual, u);
    contact.settle(u);

    double stress_error = 0;
    solid->for_each_cell(u, [&](const auto &, const auto &points) {
      for (const PointResult &point : points)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const double exact =
                (i != j ? 0. : (i == dim - 1 ? axial : lateral));
              stress_error =
                std::max(stress_error, std::abs(point.stress[i][j] - exact));
            }
    });
    stress_error = Utilities::MPI::max(stress_error, MPI_COMM_WORLD);

    const ContactState state =
      ContactEvaluation<dim>(contact, u, residual).state();
    output() << dim << "D, degree " << degree
             << (treatment == VolumetricTreatment::b_bar ? ", B-bar" : "")
             << (by_force ? ", force given" : "") << std::endl;
    verify("  published values",
           std::abs(axial + 1102.1150033) < 1e-7 &&
             std::abs(lateral + 698.9424983) < 1e-7);
    verify("  stress", stress_error < 1e-9 * std::abs(axial));
    verify("  depth", std::abs(contact.depth() - strain) < 1e-10 * strain);
    verify("  force", std::abs(state.force + axial) < 1e-9 * std::abs(axial));
    verify("  pressure",
           std::abs(state.max_pressure + axial) < 1e-8 * std::abs(axial) &&
             std::abs(state.min_pressure + axial) < 1e-8 * std::abs(axial));
    verify("  all nodes in contact",
           state.active_nodes == contact.n_candidates());
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const auto treatment :
         {VolumetricTreatment::standard, VolumetricTreatment::b_bar})
      for (const auto control : {Control::depth, Control::force})
        {
          run<2>(degree, treatment, control);
          run<3>(degree, treatment, control);
        }
}
