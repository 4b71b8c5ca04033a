// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The displacement that a guaranteed error bound in space is made of: a finite
// element solution on the tetrahedra, a gap between enclosing functions, and no
// penetration between the nodes.

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>

#include "base/largest_error.h"
#include "bounds/error/face_gap.h"
#include "space_block.h"
#include "vector_field.h"

using namespace SpaceBlock;

namespace
{
  /// The largest distance between a convex gap and the functions that enclose
  /// it, where the indenter reaches.
  void
  test_gap(const std::string &title, const Gap &gap, const double distance)
  {
    const FaceCorners<3> face = {
      {Point<3>(0., 0., 0.), Point<3>(1., 0.1, 0.2), Point<3>(0.2, 0.9, 0.1)}};
    double outside = 0., farthest = 0.;
    for (const auto &triangle : FaceGap<3>(gap, face).small_simplices)
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
          const double g =
            gap(point_of(face,
                         ElastoPlastic::interpolate(inside, triangle.corners)));
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
  clearances(const SplitBody<3> &body, const QuadraticField<3> &field)
  {
    double smallest = infinity, largest = -infinity;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_reached)
        {
          const FaceCorners<3> corners = body.mesh.corners(body.mesh.faces[f]);
          const FaceValues<3>  v       = field.values_on_face(body.mesh, f);
          for_points([&](const std::array<double, 3> &position) {
            const double clearance = body.gap(point_of(corners, position)) -
                                     depth - v.value(position)[2];
            smallest = std::min(smallest, clearance);
            if (std::isfinite(clearance))
              keep_largest(largest, clearance);
          });
        }
    return {smallest, largest};
  }



  // Linear between the vertices, all of which touch.
  void
  test_penetration(const SplitMesh<3> &mesh,
                   const std::string  &title,
                   const Gap          &gap,
                   const double        largest_clearance)
  {
    const SplitBody<3> body  = make_body(mesh, material(infinity, 0.), gap);
    QuadraticField<3>  field = make_field(mesh, [&](const Point<3> &x) {
      const double g = gap(x);
      return Tensor<1, 3>({0., 0., std::isfinite(g) ? g - depth : 0.});
    });
    for (unsigned int f = 0; f < mesh.faces.size(); ++f)
      {
        const FaceValues<3> v = field.values_on_face(mesh, f);
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
  test_interpolation(const Mesh &triangulation, const SplitMesh<3> &mesh)
  {
    const VectorField<3> quadratic(
      [](const Point<3> &x, const unsigned int component) {
        return x[component] * (1. + x[(component + 1) % 3]) -
               x[2] * x[2] * (1. + component);
      });
    const FESystem<3> fe(FE_Q<3>(2), 3);
    DoFHandler<3>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    VectorType values(dof_handler.locally_owned_dofs(),
                      relevant,
                      MPI_COMM_WORLD);
    VectorTools::interpolate(dof_handler, quadratic, values);
    const QuadraticField<3> field =
      QuadraticField<3>::interpolate_displacement(mesh, dof_handler, values);
    if (mesh.simplices.empty())
      return;

    const QuadraticField<3> exact = make_field(mesh, [&](const Point<3> &x) {
      return Tensor<1, 3>(
        {quadratic.value(x, 0), quadratic.value(x, 1), quadratic.value(x, 2)});
    });
    double                  error = 0., strain_error = 0., center_error = 0.;
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      error =
        std::max(error, (field.at_vertices[v] - exact.at_vertices[v]).norm());
    for (unsigned int e = 0; e < mesh.n_edges; ++e)
      error = std::max(error, (field.at_edges[e] - exact.at_edges[e]).norm());
    for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
      {
        const auto corners = mesh.corners(mesh.simplices[t]);
        const auto strain  = field.strains(mesh, t);
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
                   std::abs(field.value(mesh.simplices[t],
                                        {{0.25, 0.25, 0.25, 0.25}})[1] -
                            quadratic.value(center, 1)));
      }
    output() << "A finite element solution" << std::endl;
    verify("interpolated", error, 1e-13);
    verify("its strain", strain_error, 1e-12);
    verify("its value at the centre", center_error, 1e-13);
  }



  void
  test_under_indenters(const SplitMesh<3> &mesh)
  {
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
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Mesh block(MPI_COMM_WORLD);
  make_block(block);
  const SplitMesh<3> mesh = make_split_mesh(block);
  test_interpolation(block, mesh);
  if (!mesh.simplices.empty()) // on the first rank
    test_under_indenters(mesh);
}
