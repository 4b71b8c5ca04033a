// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The parts of the guaranteed error bound: no penetration between the nodes, a
// gap that is not smooth, the energy of Hencky materials against its conjugate,
// and the sum of both energies.

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "base/tensors.h"
#include "bounds/body/hencky_material.h"
#include "bounds/error/error_bound.h"
#include "bounds/error/support_check.h"
#include "bounds/stress/stress_field.h"
#include "sample_mesh.h"
#include "section_body.h"
#include "verdict.h"

using namespace SectionBody;

namespace
{
  const double radius = 3., depth = 0.02;



  BoundaryConditionParameters
  held()
  {
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left"};
    parameters.free    = {"right"};
    parameters.fixed   = {"bottom"};
    parameters.contact = {"top"};
    return parameters;
  }



  BoundaryConditionParameters
  free_to_move()
  {
    BoundaryConditionParameters parameters;
    parameters.free    = {"left", "right", "bottom"};
    parameters.contact = {"top"};
    return parameters;
  }



  /// A parabolic indenter over a block with a hanging node.
  SplitBody<2>
  make_body(const SplitMesh<2>                &mesh,
            const BoundaryConditionParameters &supports,
            const Material<double>            &material,
            const Kinematics kinematics = Kinematics::cartesian)
  {
    const BoundaryConditions<2> conditions(
      supports, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
    const auto gap = [](const Point<2> &x) {
      return x[0] * x[0] / (2. * radius);
    };
    return make_split_body<2>(
      mesh, conditions, {material}, {gap}, 0., kinematics);
  }



  QuadraticField<2>
  zero(const SplitMesh<2> &mesh)
  {
    QuadraticField<2> field;
    field.at_vertices.resize(mesh.vertices.size());
    field.at_edges.resize(mesh.faces.size());
    return field;
  }



  // A displacement that touches the indenter at all vertices of the surface
  // penetrates it everywhere else.
  QuadraticField<2>
  touch_at_vertices(const SplitBody<2> &body)
  {
    QuadraticField<2> field = zero(body.mesh);
    for (unsigned int v = 0; v < body.mesh.vertices.size(); ++v)
      field.at_vertices[v][1] = body.gap(body.mesh.vertices[v]) - depth;
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      field.at_edges[s] =
        0.5 * (field.at_vertices[body.mesh.faces[s].vertices[0]] +
               field.at_vertices[body.mesh.faces[s].vertices[1]]);
    return field;
  }



  /// The smallest and the largest distance from the indenter on the sides that
  /// it reaches.
  std::pair<double, double>
  clearances(const SplitBody<2> &body, const QuadraticField<2> &field)
  {
    double smallest = 1., largest = 0.;
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      if (body.conditions[s].is_reached)
        for (unsigned int i = 0; i <= 100000; ++i)
          {
            const double t    = 1e-5 * i;
            const auto  &ends = body.mesh.faces[s].vertices;
            const auto  &a    = body.mesh.vertices[ends[0]],
                       &b     = body.mesh.vertices[ends[1]];
            const double v =
              (1. - t) * (1. - 2. * t) * field.at_vertices[ends[0]][1] +
              t * (2. * t - 1.) * field.at_vertices[ends[1]][1] +
              4. * t * (1. - t) * field.at_edges[s][1];
            const double clearance =
              body.gap(Point<2>(a + t * (b - a))) - depth - v;
            smallest = std::min(smallest, clearance);
            largest  = std::max(largest, clearance);
          }
    return {smallest, largest};
  }



  void
  test_penetration(const SplitBody<2> &body)
  {
    QuadraticField<2> field = touch_at_vertices(body);
    remove_penetration(field, body, depth);
    const auto [smallest, largest] = clearances(body, field);
    output() << "Penetration" << std::endl;
    verify("none", smallest > -1e-14);
    // (the parabola is up to 0.0026 below its chords)
    verify("no more clearance than needed", largest, 1e-7);
  }



  // The tip of a wedge is between all points where one might look, and Gauss'
  // formula does not see it.
  void
  test_wedge(SplitBody<2> body)
  {
    const double tip = 0.3071;
    body.gap         = [tip](const Point<2> &x) {
      return 0.5 * std::abs(x[0] - tip);
    };
    QuadraticField<2> field = touch_at_vertices(body);
    remove_penetration(field, body, depth);
    output() << "Wedge with its tip inside a side" << std::endl;
    verify("no penetration", clearances(body, field).first > -1e-14);

    // the pressure 1 on the whole surface
    StressField<2> stress;
    stress.values.assign(body.mesh.simplices.size(), Vector<double>(36));
    stress.pressure.assign(body.mesh.faces.size(), {1., 1.});
    const double exact = 0.25 * (tip * tip + (1. - tip) * (1. - tip));
    const double computed =
      bound_error(body, zero(body.mesh), 0., stress).of_contact();
    verify("gap not too small", computed > exact * (1. - 1e-14));
    verify("hardly too large", computed / exact - 1., 1e-6);
  }



  // The stress of a strain makes W + W* - tau : eps vanish; any other one that
  // is admissible makes it positive.
  void
  test_conjugate(const SplitBody<2> &body, const std::string &title)
  {
    QuadraticField<2> field        = zero(body.mesh);
    const auto        displacement = [](const Point<2> &x) {
      return Tensor<1, 2>({0.01 * x[0] - 0.003 * x[1], -0.004 * x[1]});
    };
    for (unsigned int v = 0; v < body.mesh.vertices.size(); ++v)
      field.at_vertices[v] = displacement(body.mesh.vertices[v]);
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      field.at_edges[s] =
        0.5 * (field.at_vertices[body.mesh.faces[s].vertices[0]] +
               field.at_vertices[body.mesh.faces[s].vertices[1]]);

    const Material<double> &material = body.materials.front();
    auto strain = in_space<2>(field.strains(body.mesh, 0)[0], 0.);
    if (!body.initial_strains.empty())
      strain += body.initial_strains[0][0];
    const auto [elastic, plastic] = HenckyMaterial::split_strain(
      material,
      HenckyMaterial::strain_of_section(material, strain, body.kinematics));
    const SymmetricTensor<2, 3> stress =
      material.bulk_modulus * trace(elastic) * unit_symmetric_tensor<3>() +
      2. * material.shear_modulus * deviator(elastic);

    StressField<2> stresses;
    stresses.pressure.assign(body.mesh.faces.size(), {0., 0.});
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        stresses.values.emplace_back(36);
        for (unsigned int p = 0; p < 9; ++p)
          {
            stresses.values[t][4 * p]     = stress[0][0];
            stresses.values[t][4 * p + 1] = stress[1][1];
            stresses.values[t][4 * p + 2] = stress[0][1];
            stresses.values[t][4 * p + 3] = stress[2][2];
          }
      }
    const double energy = stress * (elastic + plastic);
    output() << title << std::endl;
    verify("yields",
           (plastic.norm() > 1e-3) == HenckyMaterial::yields(material));
    verify("no stress out of plane",
           body.kinematics == Kinematics::plane_stress ?
             std::abs(stress[2][2]) :
             0.,
           1e-10);
    verify("no gap",
           std::abs(bound_error(body, field, 0., stresses).total()) / energy,
           1e-12);

    for (auto &values : stresses.values)
      values *= 0.9;
    verify("gap",
           bound_error(body, field, 0., stresses).total() > 1e-4 * energy);
  }



  /// With an initial stress, whose strain this is.
  SplitBody<2>
  stressed(SplitBody<2> body)
  {
    SymmetricTensor<2, 3> strain;
    strain[0][0] = 0.002;
    strain[1][1] = -0.001;
    strain[2][2] = 0.0015;
    strain[0][1] = -0.0007;
    std::array<SymmetricTensor<2, 3>, 3> at_corners;
    at_corners.fill(strain);
    body.initial_strains.assign(body.mesh.simplices.size(), at_corners);
    return body;
  }



  /// With Hill's criterion, in axes turned by 30 degrees in the plane.
  Material<double>
  rolled(Material<double> material)
  {
    Tensor<2, 3> axes;
    axes[0][0] = axes[1][1] = std::cos(numbers::PI / 6.);
    axes[1][0]              = std::sin(numbers::PI / 6.);
    axes[0][1]              = -axes[1][0];
    axes[2][2]              = 1.;
    material.is_linear      = false;
    material.criteria[0]    = std::make_shared<GeneralCriterion>(
      HillCriterion({{1., 1.2, 0.9, 0.8, 1., 1.}}, axes));
    return material;
  }



  // A block compressed by a flat indenter, free to expand, in plane stress: the
  // displacement u_h is the exact one, which is linear, beyond the yield stress
  // as well.
  void
  test_displacement(const SplitMesh<2> &mesh)
  {
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "bottom"};
    parameters.free    = {"right"};
    parameters.contact = {"top"};
    const BoundaryConditions<2> conditions(
      parameters, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
    const auto flat = [](const Point<2> &) {
      return 0.;
    };
    const Material<double> steel     = material(1.4, 20.);
    const double           hardening = 1.5 * steel.isotropic_modulus;
    const SplitBody<2>     body      = make_split_body<2>(
      mesh, conditions, {steel}, {flat}, 0., Kinematics::plane_stress);
    const StressField<2> field = equilibrate_with_depth(body, depth);

    const double k = steel.bulk_modulus, g = steel.shear_modulus;
    const double young        = 9. * k * g / (3. * k + g);
    const double poisson      = (3. * k - 2. * g) / (6. * k + 2. * g);
    const double yield_stress = std::sqrt(1.5) * steel.yield_radius;
    const double plastic = (young * depth - yield_stress) / (young + hardening);
    const double stress  = yield_stress + hardening * plastic;
    const double expansion = poisson * stress / young + 0.5 * plastic;

    double error = 0;
    for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<2>     x = mesh.corners(mesh.simplices[t])[i];
          const Tensor<1, 2> exact({expansion * x[0], -depth * (x[1] + 1.)});
          error = std::max(error, (field.displacement[t][i] - exact).norm());
        }
    output() << "Compression" << std::endl;
    verify("yields", plastic > 0.5 * depth);
    verify("force", std::abs(field.force / stress - 1.), 1e-8);
    // (the square root of the duality gap is 3e-5)
    verify("displacement of the equilibrium method", error / depth, 1e-5);
  }



  // Without displacement, the sum of both energies is the complementary one.
  void
  test_sum(const SplitBody<2> &body)
  {
    const StressField<2> stress = equilibrate_with_depth(body, depth);
    const ErrorBound bound = bound_error(body, zero(body.mesh), depth, stress);
    const auto       parts = bound.indicators(body.mesh);
    output() << "Sum of the energies" << std::endl;
    verify("presses", stress.force > 1.);
    // (in which the gap is integrated exactly, here from above)
    const double excess = (bound.total() - stress.cost) / std::abs(stress.cost);
    verify("complementary energy from above", excess > -1e-9);
    verify("complementary energy", excess, 1e-6);
    verify("sum of the parts",
           std::abs(std::accumulate(parts.begin(), parts.end(), 0.) /
                      bound.total() -
                    1.),
           1e-12);
  }



  // At the vertices and in the middle of all sides, where the displacement
  // method has its nodes, the prescribed displacement is zero.
  void
  test_supports(const SplitMesh<2> &mesh, const Material<double> &material)
  {
    BoundaryConditionParameters waves = free_to_move();
    waves.free                        = {"right", "bottom"};
    waves.prescribed_displacement     = "left: 3e-2*sin(32*pi*y); free";
    const SplitBody<2> roller         = make_body(mesh, held(), material),
                       wavy           = make_body(mesh, waves, material);
    const StressField<2> stress       = equilibrate_with_depth(roller, depth);
    QuadraticField<2>    lifted       = zero(mesh);
    for (Tensor<1, 2> &u : lifted.at_edges)
      u[0] = depth;
    print_error("Through a roller",
                [&]() { bound_error(roller, lifted, depth, stress); });
    print_error("Waves between the nodes",
                [&]() { require_quadratic_supports(wavy); });
    print_error("None of the waves",
                [&]() { bound_error(wavy, zero(mesh), depth, stress); });
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize        mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_half_space_mesh(triangulation);

  const SplitMesh<2> mesh     = make_split_mesh(triangulation);
  const double       infinity = std::numeric_limits<double>::infinity();
  const SplitBody<2> elastic  = make_body(mesh, held(), material(infinity, 0.));
  test_penetration(elastic);
  test_wedge(elastic);
  test_sum(elastic);
  test_displacement(mesh);
  test_supports(mesh, material(infinity, 0.));
  test_conjugate(make_body(mesh, free_to_move(), material(infinity, 0.)),
                 "Elastic");
  for (const double hardening : {0., 20.})
    {
      const auto        law = material(1.4, hardening);
      const std::string name =
        hardening > 0 ? "Hardening" : "Perfectly plastic";
      for (const auto kinematics :
           {Kinematics::cartesian, Kinematics::plane_stress})
        {
          const std::string title =
            name + (kinematics == Kinematics::plane_stress ? ", plane stress" :
                                                             ", plane strain");
          const auto body = make_body(mesh, free_to_move(), law, kinematics);
          test_conjugate(body, title);
          test_conjugate(stressed(body), title + ", initial stress");
        }
      test_conjugate(make_body(mesh, free_to_move(), rolled(law)),
                     name + ", Hill's criterion");
    }
}
