// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The parts of the guaranteed error bound in space: a gap between enclosing
// functions, no penetration between the nodes, a finite element solution on
// the tetrahedra, the energy of Hencky materials against its conjugate, the
// sum of both energies, and stresses that are exact.

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "equilibrium/error_bound.h"
#include "equilibrium/evaluated_bounds.h"
#include "equilibrium/face_gap.h"
#include "equilibrium/hencky_material.h"
#include "equilibrium/largest_error.h"
#include "equilibrium/stress_problem.h"
#include "equilibrium/tetrahedron_stress.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double depth    = 0.02;

  using Gap  = std::function<double(const Point<3> &)>;
  using Mesh = parallel::distributed::Triangulation<3>;

  const BoundaryNames names = {{"left", 0},
                               {"right", 1},
                               {"front", 2},
                               {"back", 3},
                               {"bottom", 4},
                               {"top", 5}};

  const Gap flat = [](const Point<3> &) {
    return 0.;
  };

  const Gap paraboloid = [](const Point<3> &x) {
    return (x[0] * x[0] + x[1] * x[1]) / 6.;
  };



  Material<double>
  material(const double yield_radius, const double hardening)
  {
    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = yield_radius;
    material.isotropic_modulus = hardening;
    return material;
  }

  const std::vector<std::pair<std::string, Material<double>>> materials = {
    {"Elastic", material(infinity, 0.)},
    {"Hardening", material(1.4, 20.)},
    {"Perfectly plastic", material(1.4, 0.)}};



  SpaceBody
  make_body(const TetrahedralMesh          &mesh,
            const Material<double>         &material,
            const Gap                      &gap,
            const std::vector<std::string> &rollers,
            const std::vector<std::string> &fixed,
            const std::string              &displacement = "")
  {
    BoundaryConditionParameters parameters;
    parameters.roller                  = rollers;
    parameters.fixed                   = fixed;
    parameters.prescribed_displacement = displacement;
    parameters.free                    = {"right", "back"};
    if (displacement.empty())
      parameters.contact = {"top"};
    return make_space_body(mesh,
                           BoundaryConditions<3>(parameters, names),
                           {material},
                           gap,
                           /* time = */ 1.);
  }

  SpaceBody
  make_body(const TetrahedralMesh  &mesh,
            const Material<double> &material,
            const Gap              &gap)
  {
    return make_body(mesh, material, gap, {"left", "front"}, {"bottom"});
  }



  SpaceQuadraticField
  make_field(const TetrahedralMesh                               &mesh,
             const std::function<Tensor<1, 3>(const Point<3> &)> &displacement)
  {
    SpaceQuadraticField field;
    field.at_edges.resize(mesh.n_edges);
    for (const Point<3> &vertex : mesh.vertices)
      field.at_vertices.push_back(displacement(vertex));
    for (const auto &tetrahedron : mesh.tetrahedra)
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = i + 1; j < 4; ++j)
          field.at_edges[tetrahedron.edges[mesh.edge_between(i, j)]] =
            displacement(
              Point<3>(0.5 * (mesh.vertices[tetrahedron.vertices[i]] +
                              mesh.vertices[tetrahedron.vertices[j]])));
    return field;
  }



  /// Runs @p action on many points of a triangle, in barycentric coordinates.
  template <typename Action>
  void
  for_points(const Action &action)
  {
    constexpr unsigned int n = 300;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; i + j <= n; ++j)
        {
          const double a = i / double(n), b = j / double(n);
          action(std::array<double, 3>{{1. - a - b, a, b}});
        }
  }



  Point<3>
  point_of(const TriangleFace &corners, const std::array<double, 3> &position)
  {
    return Point<3>(position[0] * corners[0] + position[1] * corners[1] +
                    position[2] * corners[2]);
  }



  /// The largest distance between a convex gap and the functions that enclose
  /// it, where the indenter reaches.
  void
  test_gap(const std::string &title, const Gap &gap, const double distance)
  {
    const TriangleFace face = {
      {Point<3>(0., 0., 0.), Point<3>(1., 0.1, 0.2), Point<3>(0.2, 0.9, 0.1)}};
    double outside = 0., farthest = 0.;
    for (const auto &triangle : FaceGap(gap, face).small_triangles())
      for (const std::array<double, 3> inside :
           {std::array<double, 3>{{1., 0., 0.}},
            std::array<double, 3>{{0.5, 0.25, 0.25}},
            std::array<double, 3>{{0., 0.7, 0.3}},
            std::array<double, 3>{{1. / 3., 1. / 3., 1. / 3.}}})
        {
          double lower = 0., upper = 0.;
          for (unsigned int k = 0; k < 3; ++k)
            if (inside[k] > 0.)
              {
                lower += inside[k] * triangle.lower[k];
                upper += inside[k] * triangle.upper[k];
              }
          const double g = gap(point_of(face, triangle.position(inside)));
          if (!std::isfinite(g))
            continue;
          outside  = std::max({outside, lower - g, g - upper});
          farthest = std::max(farthest, g - lower);
          if (std::isfinite(upper))
            farthest = std::max(farthest, upper - g);
        }
    output() << title << std::endl;
    verify("enclosed", outside, 1e-14);
    verify("closely", farthest, distance);
  }



  void
  test_gaps()
  {
    test_gap("Paraboloid", paraboloid, 1e-3);
    // (its slope by the size of the small triangles)
    test_gap(
      "Cone with its tip inside a face",
      [](const Point<3> &x) {
        return 0.5 * std::hypot(x[0] - 0.31, x[1] - 0.3);
      },
      0.03);
    test_gap(
      "Sphere that reaches a part of the face",
      [](const Point<3> &x) {
        const double r = std::hypot(x[0] - 0.8, x[1]);
        return r < 0.5 ? 2. - std::sqrt(4. - r * r) - x[2] : infinity;
      },
      2e-3);
    print_error("Indenter that reaches hardly anything", []() {
      test_gap(
        "",
        [](const Point<3> &x) { return x.norm() < 0.001 ? 0. : infinity; },
        0.);
    });
  }



  /// The smallest and the largest distance from the indenter on the faces that
  /// it reaches.
  std::pair<double, double>
  clearances(const SpaceBody &body, const SpaceQuadraticField &field)
  {
    double smallest = infinity, largest = -infinity;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_reached)
        {
          const TriangleFace corners = body.mesh.corners(body.mesh.faces[f]);
          const FaceValues   v       = values_on_face(body.mesh, field, f);
          for_points([&](const std::array<double, 3> &position) {
            const double clearance = body.gap(point_of(corners, position)) -
                                     depth - v.value(position)[2];
            smallest = std::min(smallest, clearance);
            if (std::isfinite(clearance))
              enlarge(largest, clearance);
          });
        }
    return {smallest, largest};
  }



  // Linear between the vertices, all of which touch.
  void
  test_penetration(const TetrahedralMesh &mesh,
                   const std::string     &title,
                   const Gap             &gap,
                   const double           largest_clearance)
  {
    const SpaceBody     body  = make_body(mesh, material(infinity, 0.), gap);
    SpaceQuadraticField field = make_field(mesh, [&](const Point<3> &x) {
      const double g = gap(x);
      return Tensor<1, 3>({0., 0., std::isfinite(g) ? g - depth : 0.});
    });
    for (unsigned int f = 0; f < mesh.faces.size(); ++f)
      {
        const FaceValues v = values_on_face(mesh, field, f);
        for (unsigned int i = 0; i < 3; ++i)
          field.at_edges[v.edges[i]] =
            0.5 * (v.at_corners[i] + v.at_corners[(i + 1) % 3]);
      }
    const double before = clearances(body, field).first;
    remove_penetration(field, body, depth);
    const auto [smallest, largest] = clearances(body, field);
    output() << title << std::endl;
    verify("penetrates first", before < -1e-4);
    verify("no penetration", smallest > -1e-14);
    verify("no more clearance than needed", largest, largest_clearance);
  }



  // Polynomials of degree 2 are what they were on cells that are cubes.
  void
  test_interpolation(const Mesh &triangulation, const TetrahedralMesh &mesh)
  {
    class Quadratic : public Function<3>
    {
    public:
      Quadratic()
        : Function<3>(3)
      {}

      double
      value(const Point<3> &x, const unsigned int component) const override
      {
        return x[component] * (1. + x[(component + 1) % 3]) -
               x[2] * x[2] * (1. + component);
      }
    };
    const FESystem<3> fe(FE_Q<3>(2), 3);
    DoFHandler<3>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    VectorType values(dof_handler.locally_owned_dofs(),
                      relevant,
                      MPI_COMM_WORLD);
    VectorTools::interpolate(dof_handler, Quadratic(), values);
    const SpaceQuadraticField field =
      interpolate_displacement(mesh, dof_handler, values);
    if (mesh.tetrahedra.empty())
      return;

    const SpaceQuadraticField exact = make_field(mesh, [](const Point<3> &x) {
      return Tensor<1, 3>({Quadratic().value(x, 0),
                           Quadratic().value(x, 1),
                           Quadratic().value(x, 2)});
    });
    double                    error = 0., strain_error = 0., center_error = 0.;
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      error =
        std::max(error, (field.at_vertices[v] - exact.at_vertices[v]).norm());
    for (unsigned int e = 0; e < mesh.n_edges; ++e)
      error = std::max(error, (field.at_edges[e] - exact.at_edges[e]).norm());
    for (unsigned int t = 0; t < mesh.tetrahedra.size(); ++t)
      {
        const auto corners = mesh.corners(mesh.tetrahedra[t]);
        const auto strain  = strains(mesh, field, t);
        for (unsigned int i = 0; i < 4; ++i)
          {
            const Point<3> &x = corners[i];
            // (e_11, e_33, 2 e_12)
            strain_error =
              std::max({strain_error,
                        std::abs(strain[i][0][0] - 1. - x[1]),
                        std::abs(strain[i][2][2] - 1. - x[0] + 6. * x[2]),
                        std::abs(2. * strain[i][0][1] - x[0])});
          }
        const Point<3> center(
          0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
        center_error =
          std::max(center_error,
                   std::abs(
                     values_at_vertices(field, mesh.tetrahedra[t])[4][1] -
                     Quadratic().value(center, 1)));
      }
    output() << "A finite element solution" << std::endl;
    verify("interpolated", error, 1e-13);
    verify("its strain", strain_error, 1e-12);
    verify("its value at the centre", center_error, 1e-13);
  }



  SpaceStressField
  uniform(const SpaceBody &body, const SymmetricTensor<2, 3> &stress)
  {
    SpaceStressField field;
    field.pressure.resize(body.mesh.faces.size());
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        auto &values = field.values.emplace_back(TetrahedronStress::n_values);
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i] =
            stress.access_raw_entry(i % TetrahedronStress::n_components);
      }
    return field;
  }



  // The stress of a strain makes W + W* - tau : eps vanish; any other one that
  // is admissible makes it positive.
  void
  test_conjugate(const TetrahedralMesh  &mesh,
                 const std::string      &title,
                 const Material<double> &material)
  {
    BoundaryConditionParameters parameters;
    for (const auto &name : names)
      parameters.free.push_back(name.first);
    const SpaceBody body = make_space_body(
      mesh, BoundaryConditions<3>(parameters, names), {material}, flat, 0.);
    const SpaceQuadraticField field = make_field(mesh, [](const Point<3> &x) {
      return Tensor<1, 3>({0.01 * x[0] - 0.003 * x[1],
                           -0.004 * x[1] + 0.002 * x[2],
                           0.001 * x[2] + 0.005 * x[0]});
    });
    const auto [elastic, plastic] =
      HenckyMaterial::split_strain(material, strains(mesh, field, 0)[0]);
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
  test_sum(const TetrahedralMesh  &mesh,
           const std::string      &title,
           const Material<double> &material)
  {
    const SpaceBody        body   = make_body(mesh, material, paraboloid);
    const SpaceStressField stress = equilibrate_with_depth(body, depth);
    const ErrorBound       bound =
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

    const SpaceStressField by_force =
      equilibrate_with_force(body, stress.force);
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
  test_compression(const TetrahedralMesh  &mesh,
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
    const double stress             = young * (depth - plastic);
    const double expansion          = poisson * stress / young + 0.5 * plastic;
    const SpaceQuadraticField field = make_field(mesh, [&](const Point<3> &x) {
      return Tensor<1, 3>(
        {expansion * x[0], expansion * x[1], -depth * (x[2] + 1.)});
    });

    const std::vector<std::string> rollers = {"left", "front", "bottom"};
    const SpaceBody pressed = make_body(mesh, material, flat, rollers, {});
    const SpaceStressField by_depth = equilibrate_with_depth(pressed, depth);
    const double           energy   = stress * depth;
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

    const SpaceBody moved =
      make_body(mesh, material, flat, rollers, {}, "top: free; free; -0.02*t");
    const SpaceStressField by_plate = equilibrate_with_depth(moved, 0.);
    const double           rest =
      bound_error(moved, field, 0., by_plate).total() / energy;
    verify("nor with a prescribed displacement", std::abs(rest), 1e-8);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Mesh block(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    block, {2, 2, 2}, Point<3>(0, 0, -1), Point<3>(1, 1, 0), true);
  for (const auto &cell : block.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center().norm() < 0.5)
      cell->set_refine_flag();
  block.execute_coarsening_and_refinement();

  const TetrahedralMesh mesh = make_split_mesh(block);
  test_interpolation(block, mesh);
  if (mesh.tetrahedra.empty())
    return 0; // not the first rank
  test_gaps();
  test_penetration(mesh, "Paraboloid on the block", paraboloid, 0.01);
  test_penetration(
    mesh,
    "Part of a sphere on the block",
    [](const Point<3> &x) {
      const double r = std::hypot(x[0], x[1]);
      return r < 0.6 ? 2. - std::sqrt(4. - r * r) : infinity;
    },
    0.07);
  for (const auto &[title, material] : materials)
    {
      test_conjugate(mesh, title, material);
      test_sum(mesh, title, material);
      test_compression(mesh, title, material);
    }
  print_error("A displacement that the supports do not allow", [&]() {
    const SpaceBody body = make_body(mesh, material(infinity, 0.), flat);
    bound_error(body,
                make_field(mesh,
                           [](const auto &) {
                             return Tensor<1, 3>({1., 0., 0.});
                           }),
                0.,
                uniform(body, SymmetricTensor<2, 3>()));
  });
}
