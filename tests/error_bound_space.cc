// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The guaranteed error bound in space: the energy of Hencky materials against
// its conjugate, the sum of both energies, and stresses that are exact.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bounds/body/hencky_material.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "space_block.h"

using namespace SpaceBlock;

namespace
{
  StressField<3>
  uniform(const SplitBody<3> &body, const SymmetricTensor<2, 3> &stress)
  {
    StressField<3> field;
    field.pressure.assign(body.mesh.faces.size(), {0., 0., 0.});
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        auto &values =
          field.values.emplace_back(JohnsonMercier<3>::n_values(1));
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i] =
            stress.access_raw_entry(i % JohnsonMercier<3>::n_components);
      }
    return field;
  }



  // The stress of a strain makes W + W* - tau : eps vanish; any other one that
  // is admissible makes it positive.
  void
  test_conjugate(const SplitMesh<3>     &mesh,
                 const std::string      &title,
                 const Material<double> &material)
  {
    BoundaryConditionParameters parameters;
    for (const auto &name : names_of_box)
      parameters.free.push_back(name.first);
    const SplitBody<3> body =
      make_split_body<3>(mesh,
                         BoundaryConditions<3>(parameters, names_of_box),
                         {material},
                         {flat},
                         0.);
    const QuadraticField<3> field = make_field(mesh, [](const Point<3> &x) {
      return Tensor<1, 3>({0.01 * x[0] - 0.003 * x[1],
                           -0.004 * x[1] + 0.002 * x[2],
                           0.001 * x[2] + 0.005 * x[0]});
    });
    const auto [elastic, plastic] =
      HenckyMaterial::split_strain(material, field.strains(mesh, 0)[0]);
    const SymmetricTensor<2, 3> stress =
      material.bulk_modulus * trace(elastic) * unit_symmetric_tensor<3>() +
      2. * material.shear_modulus * deviator(elastic);
    const double energy = stress * (elastic + plastic);
    output() << title << std::endl;
    verify("yields",
           (plastic.norm() > 1e-3) == HenckyMaterial::yields(material));
    verify("no gap",
           std::abs(
             bound_error(body, field, 0., uniform(body, stress)).total()) /
             energy,
           1e-12);
    verify("gap",
           bound_error(body, field, 0., uniform(body, 0.9 * stress)).total() >
             1e-4 * energy);
  }



  // Without displacement, the sum of both energies is the complementary one, in
  // which the gap is integrated by Gauss' formula.
  void
  test_sum(const SplitMesh<3>     &mesh,
           const std::string      &title,
           const Material<double> &material)
  {
    const SplitBody<3>   body   = make_body(mesh, material, paraboloid);
    const StressField<3> stress = equilibrate_with_depth(body, depth);
    const ErrorBound     bound =
      bound_error(body,
                  make_field(mesh, [](const auto &) { return Tensor<1, 3>(); }),
                  depth,
                  stress);
    const auto   parts  = bound.indicators(mesh);
    const double excess = (bound.total() - stress.cost) / std::abs(stress.cost);
    output() << "Sum of the energies, " << title << std::endl;
    verify("presses", stress.force > 0.2);
    verify("admissible", require_admissible(body, stress), 1e-9);
    verify("complementary energy from above", excess > -1e-9);
    // (from the chords of a 32nd of a face to the paraboloid)
    verify("complementary energy", excess, 2e-3);
    verify("sum of the parts",
           std::abs(std::accumulate(parts.begin(), parts.end(), 0.) /
                      bound.total() -
                    1.),
           1e-12);

    const StressField<3> by_force = equilibrate_with_force(body, stress.force);
    verify("depth under that force",
           std::abs(by_force.depth / depth - 1.),
           1e-5);
    verify("complementary energy under it",
           std::abs((by_force.cost - depth * stress.force) / stress.cost - 1.),
           1e-7);
  }



  // A block between plates, and one whose top is moved as much: beyond the
  // yield stress if there is one.
  void
  test_compression(const SplitMesh<3>     &mesh,
                   const std::string      &title,
                   const Material<double> &material)
  {
    const double k = material.bulk_modulus, g = material.shear_modulus;
    const double young        = 9. * k * g / (3. * k + g);
    const double poisson      = (3. * k - 2. * g) / (6. * k + 2. * g);
    const double yield_stress = std::sqrt(1.5) * material.yield_radius;
    const double hardening    = 1.5 * material.isotropic_modulus;
    const double plastic =
      std::max(0., (young * depth - yield_stress) / (young + hardening));
    const double stress           = young * (depth - plastic);
    const double expansion        = poisson * stress / young + 0.5 * plastic;
    const QuadraticField<3> field = make_field(mesh, [&](const Point<3> &x) {
      return Tensor<1, 3>(
        {expansion * x[0], expansion * x[1], -depth * (x[2] + 1.)});
    });

    const std::vector<std::string> rollers = {"left", "front", "bottom"};
    const SplitBody<3>   pressed = make_body(mesh, material, flat, rollers, {});
    const StressField<3> by_depth = equilibrate_with_depth(pressed, depth);
    const double         energy   = stress * depth;
    output() << "Compression, " << title << std::endl;
    verify("yields", (plastic > 0.) == HenckyMaterial::yields(material));
    verify("force", std::abs(by_depth.force / stress - 1.), 1e-8);
    verify("largest pressure",
           std::abs(by_depth.max_pressure() / stress - 1.),
           1e-3);
    verify("contact area",
           std::abs(by_depth.contact_area(pressed) - 1.),
           1e-12);
    const double bound =
      bound_error(pressed, field, depth, by_depth).total() / energy;
    verify("nothing left of the bound", std::abs(bound), 1e-8);

    const SplitBody<3> moved =
      make_body(mesh, material, flat, rollers, {}, "top: free; free; -0.02*t");
    const StressField<3> by_plate = equilibrate_with_depth(moved, 0.);
    const double         rest =
      bound_error(moved, field, 0., by_plate).total() / energy;
    verify("nor with a prescribed displacement", std::abs(rest), 1e-8);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Mesh block(MPI_COMM_WORLD);
  make_block(block);
  const SplitMesh<3> mesh = make_split_mesh(block);
  for (const auto &[title, material] : materials)
    {
      test_conjugate(mesh, title, material);
      test_sum(mesh, title, material);
      test_compression(mesh, title, material);
    }
  print_error("A displacement that the supports do not allow", [&]() {
    const SplitBody<3> body = make_body(mesh, material(infinity, 0.), flat);
    bound_error(body,
                make_field(mesh,
                           [](const auto &) {
                             return Tensor<1, 3>({1., 0., 0.});
                           }),
                0.,
                uniform(body, SymmetricTensor<2, 3>()));
  });
}
