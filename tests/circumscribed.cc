// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What an indenter reaches if that is a disc: triangles on it and beside it;
// the polygons inside and around it that the two bounds of limit loads have;
// and when there is only the one inside.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>

#include "bounds/body/split_body.h"
#include "box_names.h"
#include "mesh/ready_meshes.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Mesh = parallel::distributed::Triangulation<3>;

  const Disc<2> unit_disc = {Point<2>(), 1.};



  /// The whole box, with cells of two sizes along the circle. Collective.
  void
  make_mesh(Mesh &mesh)
  {
    BoxParameters box;
    box.lower_corner  = {-2., -2., -2.};
    box.upper_corner  = {2., 2., 0.};
    box.repetitions   = {2, 2, 1};
    box.circle_radius = 1.;
    make_box(box, mesh);
    for (unsigned int i = 0; i < 2; ++i)
      refine_where(mesh, [&](const auto &cell) {
        return i == 0 || cell->center().distance({1, 0, 0}) < 0.7;
      });
  }



  Material<double>
  material(const double yield_radius)
  {
    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = yield_radius;
    material.isotropic_modulus = 0.;
    return material;
  }



  SplitBody<3>
  make_body(const SplitMesh<3>                  &mesh,
            const Disc<2>                       &disc,
            const std::vector<Material<double>> &materials = {material(1.)})
  {
    BoundaryConditionParameters parameters;
    parameters.free    = {"left", "right", "front", "back"};
    parameters.fixed   = {"bottom"};
    parameters.contact = {"top"};
    return make_split_body<3>(mesh,
                              BoundaryConditions<3>(parameters, names_of_box),
                              materials,
                              {[](const Point<3> &) { return 0.; },
                               SurfaceFinish::smooth,
                               ContactGeometry::vertical,
                               {disc, {}}},
                              0.);
  }



  void
  test_triangle(const std::string             &title,
                const std::array<Point<3>, 3> &triangle,
                const bool                     is_contained,
                const bool                     is_overlapped)
  {
    verify(title,
           contains(unit_disc, triangle) == is_contained &&
             overlaps(unit_disc, triangle) == is_overlapped);
  }



  void
  test_triangles()
  {
    const auto on_circle = [](const double angle) {
      return Point<3>(std::cos(angle), std::sin(angle), 0.);
    };
    const Point<3> center;
    test_triangle("inside, corners on the circle",
                  {{center, on_circle(0.3), on_circle(0.7)}},
                  true,
                  true);
    test_triangle("beside an edge between points of the circle",
                  {{Point<3>(2, 1, 0), on_circle(0.3), on_circle(0.7)}},
                  false,
                  true);
    test_triangle("one corner on the circle",
                  {{Point<3>(2, 0, 0), Point<3>(2, 1, 0), on_circle(0.2)}},
                  false,
                  false);
    test_triangle(
      "around the disc",
      {{Point<3>(-5, -5, 1), Point<3>(5, -5, 2), Point<3>(0, 9, 3)}},
      false,
      true);
    test_triangle(
      "an edge through the disc",
      {{Point<3>(-2, 0.9, 0), Point<3>(2, 0.9, 0), Point<3>(0, 3, 0)}},
      false,
      true);
    test_triangle("an edge along a tangent",
                  {{Point<3>(-2, 1, 0), Point<3>(2, 1, 0), Point<3>(0, 3, 0)}},
                  false,
                  false);
    test_triangle("upright, beyond the circle",
                  {{Point<3>(1.1, 0, 0), Point<3>(2, 0, 0), Point<3>(2, 0, 1)}},
                  false,
                  false);
  }



  bool
  lies_on(const FaceCorners<3> &triangle, const Point<3> &x)
  {
    double sum = 0;
    for (unsigned int i = 0; i < 3; ++i)
      sum += area(FaceCorners<3>{{x, triangle[i], triangle[(i + 1) % 3]}});
    return sum <= (1. + 1e-12) * area(triangle);
  }



  void
  test_polygons(const SplitBody<3> &body, const SplitBody<3> &around)
  {
    std::vector<FaceCorners<3>> reached;
    double                      inside = 0, outside = 0;
    unsigned int                n_whole = 0;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      {
        const auto &face = body.mesh.faces[f];
        if (body.conditions[f].is_pressed())
          {
            ++n_whole;
            inside += area(body.mesh.corners(face));
          }
        if (around.conditions[f].is_reached)
          {
            reached.push_back(around.mesh.corners(face));
            outside += area(reached.back());
          }
      }
    // of 16 sides, some of them halved
    verify("polygon inside",
           inside < numbers::PI && inside > 8. * std::sin(numbers::PI / 8.));
    verify("polygon around",
           outside > numbers::PI &&
             outside < 16. * std::tan(numbers::PI / 16.));
    verify("of the same faces", reached.size() == n_whole);

    bool is_covered = true;
    for (unsigned int i = 0; i < 1000; ++i)
      {
        const double angle = 2. * numbers::PI * i / 1000.;
        is_covered =
          is_covered &&
          std::any_of(
            reached.begin(), reached.end(), [&](const auto &triangle) {
              return lies_on(triangle,
                             Point<3>(std::cos(angle), std::sin(angle), 0.));
            });
      }
    verify("which covers the circle", is_covered);
  }



  void
  test_volume(const SplitMesh<3> &mesh)
  {
    double sum = 0, surface = 0;
    for (const auto &tetrahedron : mesh.simplices)
      sum += volume(mesh.corners(tetrahedron));
    for (const auto &face : mesh.faces)
      if (!face.is_inside())
        surface += area(mesh.corners(face));
    verify("volume", std::abs(sum - 32.), 1e-10);
    verify("surface", std::abs(surface - 64.), 1e-10);
  }



  void
  test_unmoved(const std::string &title, const SplitBody<3> &body)
  {
    verify(title, circumscribe(body).mesh.vertices == body.mesh.vertices);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Mesh mesh(MPI_COMM_WORLD);
  make_mesh(mesh);
  const SplitMesh<3> tetrahedra = make_split_mesh(mesh);

  test_triangles();
  const SplitBody<3> body = make_body(tetrahedra, unit_disc);
  test_polygons(body, circumscribe(body));
  test_volume(circumscribe(body).mesh);

  test_unmoved("no vertices on the circle",
               make_body(tetrahedra, {Point<2>(), 0.97}));
  test_unmoved("centre beside that of the vertices",
               make_body(tetrahedra, {Point<2>(0.01, 0.), 1.}));
  SplitMesh<3> layers = tetrahedra;
  for (auto &tetrahedron : layers.simplices)
    {
      Point<3> center;
      for (const Point<3> &x : layers.corners(tetrahedron))
        center += 0.25 * x;
      layers.cells[tetrahedron.cell].material_id =
        from_above(center).norm() > 1.;
    }
  test_unmoved("another material beside the disc",
               make_body(layers, unit_disc, {material(1.), material(2.)}));
  SplitMesh<3> half = tetrahedra;
  for (auto &face : half.faces)
    if (face.boundary_id == 5 && half.corners(face)[0][1] +
                                     half.corners(face)[1][1] +
                                     half.corners(face)[2][1] <
                                   0.)
      face.boundary_id = 4;
  test_unmoved("another boundary beside the disc", make_body(half, unit_disc));
}
