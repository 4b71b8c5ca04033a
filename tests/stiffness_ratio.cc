// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The P-wave modulus of the tangent over its smallest shear modulus: exact
// values of elastic bodies, of two materials, and of simple shear beyond yield,
// in plane strain, in sheets and in space.

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>

#include "material/material_parameters.h"
#include "mechanics/solid_operator.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double young = 2., yield_stress = 0.1;

  double
  shear_modulus(const double poisson)
  {
    return young / (2. * (1. + poisson));
  }



  double
  bulk_modulus(const double poisson)
  {
    return young / (3. * (1. - 2. * poisson));
  }



  /// The ratio in a cube under the simple shear @p gamma. Its cells have the
  /// materials with these @p poisson_ratios, half of the cells each.
  template <int dim>
  double
  ratio(const std::vector<double> &poisson_ratios,
        const StrainModel         &strain_model,
        const double               hardening_modulus,
        const double               gamma)
  {
    MaterialParameters materials;
    materials.laws             = {MaterialLaw::isotropic_hardening};
    materials.young_moduli     = {young};
    materials.poisson_ratios   = poisson_ratios;
    materials.yield_stresses   = {yield_stress};
    materials.isotropic_moduli = {hardening_modulus};

    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh);
    mesh.refine_global(2);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(poisson_ratios.size() > 1 &&
                            cell->center()[0] > 0.5);
    const FESystem<dim> fe(FE_Q<dim>(1), dim);
    DoFHandler<dim>     dof_handler(mesh);
    dof_handler.distribute_dofs(fe);
    AffineConstraints<double> constraints;
    constraints.close();
    SolidOperator<dim> solid(1, strain_model, materials.materials());
    solid.reinit(dof_handler, constraints);

    VectorType u;
    solid.initialize_vector(u);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (const auto i = cell->vertex_dof_index(v, 0); u.in_local_range(i))
            u(i) = gamma * cell->vertex(v)[1];
    solid.predict_flow(u, u);
    solid.linearize(u);
    return solid.stiffness_ratio(MPI_COMM_WORLD);
  }



  void
  compare(const std::string &name, const double found, const double expected)
  {
    verify("  " + name, std::abs(found / expected - 1.), 1e-5);
  }



  // Far beyond yield, in the first step: the flow stress in shear is that of
  // the trial stress, reduced by theta; along the flow, the slope of the curve
  // remains.
  template <int dim>
  void
  check_flow()
  {
    const double gamma = 1., poisson = 0.3, hardening = 0.05;
    const double G = shear_modulus(poisson), K = bulk_modulus(poisson);
    const double yield = yield_stress / std::sqrt(3.);
    const double slope = G * hardening / (3. * G + hardening);
    const double theta = (yield + slope * (gamma - yield / G)) / (G * gamma);
    const double perfect_theta         = yield / (G * gamma);
    const VolumetricTreatment standard = VolumetricTreatment::standard;
    compare("hardening",
            ratio<dim>({poisson}, standard, hardening, gamma),
            (K + 4. / 3. * G * theta) / slope);
    compare("perfectly plastic: a fiftieth is left",
            ratio<dim>({poisson}, standard, 0., gamma),
            (K + 4. / 3. * G * perfect_theta) / (0.02 * G * perfect_theta));
  }



  template <int dim>
  void
  check_body()
  {
    output() << dim << "D" << std::endl;
    const VolumetricTreatment standard = VolumetricTreatment::standard;
    const auto                elastic  = [](const double poisson) {
      return 2. * (1. - poisson) / (1. - 2. * poisson);
    };
    compare("elastic", ratio<dim>({0.3}, standard, 0., 0.), elastic(0.3));
    compare("two materials",
            ratio<dim>({0.3, 0.}, standard, 0., 0.),
            std::sqrt(elastic(0.3) * elastic(0.)));
    check_flow<dim>();
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_body<2>();
  check_body<3>();
  output() << "Sheet" << std::endl;
  compare("elastic",
          ratio<2>({0.3},
                   {VolumetricTreatment::standard, Kinematics::plane_stress},
                   0.,
                   0.),
          2. / (1. - 0.3));
}
