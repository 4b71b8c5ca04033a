// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The guaranteed error bound of bodies of revolution: a quadrature that is
// never too small, the energy of Hencky materials against its conjugate,
// stresses and displacements in uniaxial compression, and the sum of both
// energies.

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/body/hencky_material.h"
#include "bounds/error/error_bound.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "sample_mesh.h"
#include "section_body.h"
#include "verdict.h"

using namespace SectionBody;

namespace
{
  const double depth = 0.02;



  /// int (a_0 l_0^2 + a_1 l_1^2 + ... + a_5 l_2 l_0)^2 / r, relative to the
  /// area, l being barycentric coordinates, by Gauss' formula on lines from
  /// corner 0, where r is smallest.
  double
  integral(const std::array<double, 6> &a, const std::array<double, 3> &r)
  {
    static const QGauss<1> gauss(60);
    double                 sum = 0;
    for (unsigned int i = 0; i < gauss.size(); ++i)
      for (unsigned int j = 0; j < gauss.size(); ++j)
        {
          const double s = gauss.point(i)[0], t = gauss.point(j)[0];
          const double l0 = 1. - s, l1 = s * (1. - t), l2 = s * t;
          const double p = a[0] * l0 * l0 + a[1] * l1 * l1 + a[2] * l2 * l2 +
                           a[3] * l0 * l1 + a[4] * l1 * l2 + a[5] * l2 * l0;
          sum += 2. * s * gauss.weight(i) * gauss.weight(j) * p * p /
                 (r[0] * l0 + r[1] * l1 + r[2] * l2);
        }
    return sum;
  }



  double
  quadrature(const std::array<double, 6> &a, const std::array<double, 3> &r)
  {
    double sum = 0;
    for (const auto &[l, weight] : quadrature_over(r))
      {
        const double p = a[0] * l[0] * l[0] + a[1] * l[1] * l[1] +
                         a[2] * l[2] * l[2] + a[3] * l[0] * l[1] +
                         a[4] * l[1] * l[2] + a[5] * l[2] * l[0];
        sum += weight * p * p;
      }
    return sum;
  }



  void
  test_quadrature(const std::string           &title,
                  const std::array<double, 3> &r,
                  const double                 largest_excess)
  {
    double smallest = 0., largest = 0.;
    // all polynomials with coefficients from -1 to 1, and zero on the axis
    for (unsigned int code = 0; code < 729; ++code)
      {
        std::array<double, 6> a;
        for (unsigned int i = 0, rest = code; i < 6; ++i, rest /= 3)
          a[i] = rest % 3 - 1.;
        for (unsigned int i = 0; i < 3; ++i)
          {
            if (r[i] == 0.)
              a[i] = 0.;
            if (r[i] == 0. && r[(i + 1) % 3] == 0.)
              a[3 + i] = 0.;
          }
        const double exact = integral(a, r);
        if (exact == 0.)
          continue;
        const double excess = quadrature(a, r) / exact - 1.;
        smallest            = std::min(smallest, excess);
        largest             = std::max(largest, excess);
      }
    output() << title << std::endl;
    verify("quadrature never too small", smallest > -1e-12);
    verify("quadrature little too large", largest, largest_excess);
  }



  BoundaryConditions<2>
  conditions(const std::set<std::string> &fixed, std::set<std::string> rollers)
  {
    BoundaryConditionParameters parameters;
    rollers.insert("left");
    parameters.roller  = {rollers.begin(), rollers.end()};
    parameters.fixed   = {fixed.begin(), fixed.end()};
    parameters.free    = {"right"};
    parameters.contact = {"top"};
    return BoundaryConditions<2>(
      parameters, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
  }



  /// A paraboloid on a block.
  SplitBody<2>
  make_body(const SplitMesh<2>          &mesh,
            const BoundaryConditions<2> &supports,
            const Material<double>      &material)
  {
    const auto gap = [](const Point<2> &x) {
      return x[0] * x[0] / 6.;
    };
    return make_split_body<2>(
      mesh, supports, {material}, {gap}, 0., Kinematics::axisymmetric);
  }



  template <typename Displacement>
  QuadraticField<2>
  interpolate(const SplitMesh<2> &mesh, const Displacement &displacement)
  {
    QuadraticField<2> field;
    for (const Point<2> &vertex : mesh.vertices)
      field.at_vertices.push_back(displacement(vertex));
    for (const SplitMesh<2>::Face &side : mesh.faces)
      field.at_edges.push_back(
        displacement(Point<2>(0.5 * (mesh.vertices[side.vertices[0]] +
                                     mesh.vertices[side.vertices[1]]))));
    return field;
  }



  /// The same stress everywhere.
  StressField<2>
  uniform(const SplitBody<2> &body, const SymmetricTensor<2, 3> &stress)
  {
    StressField<2> field;
    field.pressure.assign(body.mesh.faces.size(), {0., 0.});
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        const auto corners = body.mesh.corners(body.mesh.simplices[t]);
        field.values.emplace_back(36);
        field.circumferential.push_back(
          {stress[2][2], stress[2][2], stress[2][2]});
        for (unsigned int p = 0; p < 9; ++p)
          {
            const double r =
              JohnsonMercier<2>::part_of(corners, p / 3)[p % 3][0];
            field.values[t][4 * p]     = r * stress[0][0];
            field.values[t][4 * p + 1] = r * stress[1][1];
            field.values[t][4 * p + 2] = r * stress[0][1];
            field.values[t][4 * p + 3] = r * stress[2][2];
          }
      }
    return field;
  }



  // The stress of a strain makes W + W* - tau : eps vanish; any other one that
  // is admissible makes it positive, and known if the material is elastic.
  void
  test_conjugate(const SplitBody<2> &body, const std::string &title)
  {
    const QuadraticField<2> field =
      interpolate(body.mesh, [](const Point<2> &x) {
        return Tensor<1, 2>({0.006 * x[0], -0.01 * (x[1] + 1.)});
      });
    const Material<double> &material = body.materials.front();
    SymmetricTensor<2, 3>   strain;
    strain[0][0] = strain[2][2] = 0.006;
    strain[1][1]                = -0.01;
    const auto [elastic, plastic] =
      HenckyMaterial::split_strain(material, strain);
    const SymmetricTensor<2, 3> stress =
      material.bulk_modulus * trace(elastic) * unit_symmetric_tensor<3>() +
      2. * material.shear_modulus * deviator(elastic);

    const double volume = numbers::PI, energy = stress * strain * volume;
    const bool   yields = HenckyMaterial::yields(material);
    output() << title << std::endl;
    verify("yields", (plastic.norm() > 1e-3) == yields);
    verify("no gap",
           std::abs(
             bound_error(body, field, 0., uniform(body, stress)).total()) /
             energy,
           1e-12);
    const double gap =
      bound_error(body, field, 0., uniform(body, 0.9 * stress)).total();
    verify("gap", gap > 1e-4 * energy);
    if (!yields)
      verify("size of the gap", std::abs(gap / (0.005 * energy) - 1.), 1e-12);
  }



  // A cylinder compressed by a flat indenter, free to expand: the stress is
  // uniaxial, the displacement u_h linear, beyond the yield stress as well.
  void
  test_compression(const SplitMesh<2> &mesh, const double hardening)
  {
    static const BoundaryConditions<2> smooth = conditions({}, {"bottom"});
    const auto                         flat   = [](const Point<2> &) {
      return 0.;
    };
    const Material<double> steel = material(1.4, hardening);
    const SplitBody<2>     body  = make_split_body<2>(
      mesh, smooth, {steel}, {flat}, 0., Kinematics::axisymmetric);
    const StressField<2> field = equilibrate_with_depth(body, depth);

    const double k = steel.bulk_modulus, g = steel.shear_modulus;
    const double young        = 9. * k * g / (3. * k + g);
    const double poisson      = (3. * k - 2. * g) / (6. * k + 2. * g);
    const double yield_stress = std::sqrt(1.5) * steel.yield_radius;
    const double plastic =
      (young * depth - yield_stress) / (young + 1.5 * hardening);
    const double stress    = yield_stress + 1.5 * hardening * plastic;
    const double expansion = poisson * stress / young + 0.5 * plastic;

    const auto exact = [&](const Point<2> &x) {
      return Tensor<1, 2>({expansion * x[0], -depth * (x[1] + 1.)});
    };
    double error = 0;
    for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        error = std::max(error,
                         (field.displacement[t][i] -
                          exact(mesh.corners(mesh.simplices[t])[i]))
                           .norm());
    output() << "Compression, modulus " << hardening << std::endl;
    verify("force", std::abs(field.force / (numbers::PI * stress) - 1.), 1e-7);
    verify("pressure", std::abs(field.max_pressure() / stress - 1.), 1e-4);
    verify("contact area",
           std::abs(field.contact_area(body) / numbers::PI - 1.),
           1e-12);
    verify("equilibrium and yield condition",
           check_stress(body, field).largest(),
           1e-9);
    // (without hardening, the strain may be anywhere; else the square root of
    // the duality gap is 3e-5)
    if (hardening > 0)
      verify("displacement of the equilibrium method", error / depth, 1e-4);
    const ErrorBound bound =
      bound_error(body, interpolate(mesh, exact), depth, field);
    verify("bound",
           std::abs(bound.total()) / (numbers::PI * stress * depth),
           1e-8);
  }



  /// The radial displacement of a hollow elastic sphere between the radii 1 and
  /// 2 under the pressure 1 inside (Lame).
  double
  expansion(const Material<double> &steel, const double r)
  {
    return (1. / (3. * steel.bulk_modulus) * r +
            8. / (4. * steel.shear_modulus) / (r * r)) /
           7.;
  }



  // The displacement is interpolated, the mesh a polygon inside the sphere.
  void
  test_hollow_sphere()
  {
    BoundaryConditionParameters parameters;
    parameters.roller = {"bottom", "top"};
    parameters.free   = {"left", "right"};
    const BoundaryConditions<2> symmetric(parameters, names);
    // (which does not yield)
    const Material<double> steel = material(100., 0.);
    const double           exact = numbers::PI * expansion(steel, 1.);

    std::vector<double> errors, bounds;
    for (const unsigned int n : {6, 12})
      {
        Triangulation<2> mesh;
        make_shell(mesh, n);
        SplitBody<2> body = make_split_body<2>(make_split_mesh(mesh),
                                               symmetric,
                                               {steel},
                                               {everywhere},
                                               0.,
                                               Kinematics::axisymmetric);
        press(body, 0, 1.);
        const StressField<2>    stress = equilibrate_with_depth(body, 0.);
        const QuadraticField<2> displacement =
          interpolate(body.mesh, [&](const Point<2> &x) {
            return x / x.norm() * expansion(steel, x.norm());
          });
        errors.push_back(std::abs(stress.cost / exact - 1.));
        bounds.push_back(bound_error(body, displacement, 0., stress).total() /
                         exact);
      }
    output() << "Hollow sphere" << std::endl;
    verify("energy", errors.back(), 0.005);
    verify("order of the energy", std::log2(errors[0] / errors[1]) > 1.9);
    verify("bound", bounds.back() > 0. && bounds.back() < 1e-3);
    verify("order of the bound", std::log2(bounds[0] / bounds[1]) > 1.9);
  }



  // Without displacement, the sum of both energies is the complementary one.
  void
  test_sum(const SplitBody<2> &body)
  {
    const QuadraticField<2> zero =
      interpolate(body.mesh, [](const Point<2> &) { return Tensor<1, 2>(); });
    const StressField<2> stress = equilibrate_with_depth(body, depth);
    const ErrorBound     bound  = bound_error(body, zero, depth, stress);
    output() << "Sum of the energies" << std::endl;
    verify("presses", stress.force > 1.);
    // (in which the gap is integrated exactly, here from above)
    const double excess = (bound.total() - stress.cost) / std::abs(stress.cost);
    verify("complementary energy from above", excess > -1e-9);
    verify("complementary energy", excess, 1e-6);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize        mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> regular(MPI_COMM_WORLD);
  make_half_space_mesh(regular);
  Triangulation<2> distorted;
  GridGenerator::subdivided_hyper_rectangle(
    distorted, {4, 4}, Point<2>(0, -1), Point<2>(1, 0), true);
  GridTools::distort_random(0.2, distorted, /* keep_boundary = */ true);

  test_quadrature("Far from the axis", {{10., 10.5, 11.}}, 1e-4);
  test_quadrature("Near the axis", {{1., 2., 3.}}, 1e-2);
  test_quadrature("Next to the axis", {{0.1, 2., 1.}}, 1e-1);
  test_quadrature("A corner on the axis", {{0., 1., 2.}}, 2e-2);
  test_quadrature("A side on the axis", {{0., 2., 0.}}, 1e-12);

  const SplitMesh<2> mesh     = make_split_mesh(regular);
  const double       infinity = std::numeric_limits<double>::infinity();
  const auto         held     = conditions({"bottom"}, {});
  const auto         rolling  = conditions({}, {"bottom"});
  test_sum(make_body(mesh, held, material(infinity, 0.)));
  test_sum(make_body(mesh, held, material(1.4, 0.)));
  test_conjugate(make_body(mesh, rolling, material(infinity, 0.)), "Elastic");
  test_conjugate(make_body(mesh, rolling, material(1.4, 0.)),
                 "Perfectly plastic");
  test_conjugate(make_body(mesh, rolling, material(1.4, 20.)), "Hardening");
  test_hollow_sphere();
  for (const double hardening : {0., 20.})
    {
      test_compression(mesh, hardening);
      test_compression(make_split_mesh(distorted), hardening);
    }
}
