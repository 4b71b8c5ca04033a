// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_space_block_h
#define tests_space_block_h

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <functional>
#include <limits>

#include "bounds/error/error_bound.h"
#include "box_names.h"
#include "refine_where.h"
#include "verdict.h"

// A cube under an indenter, cut into tetrahedra, for what the error bound in
// space is made of.

namespace SpaceBlock
{
  using namespace ElastoPlastic;

  const double infinity = std::numeric_limits<double>::infinity();
  const double depth    = 0.02;

  using Gap  = std::function<double(const Point<3> &)>;
  using Mesh = parallel::distributed::Triangulation<3>;

  const Gap flat = [](const Point<3> &) {
    return 0.;
  };

  const Gap paraboloid = [](const Point<3> &x) {
    return (x[0] * x[0] + x[1] * x[1]) / 6.;
  };



  inline Material<double>
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



  inline SplitBody<3>
  make_body(const SplitMesh<3>             &mesh,
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
    return make_split_body<3>(mesh,
                              BoundaryConditions<3>(parameters, names_of_box),
                              {material},
                              {gap},
                              /* time = */ 1.);
  }

  inline SplitBody<3>
  make_body(const SplitMesh<3>     &mesh,
            const Material<double> &material,
            const Gap              &gap)
  {
    return make_body(mesh, material, gap, {"left", "front"}, {"bottom"});
  }



  inline QuadraticField<3>
  make_field(const SplitMesh<3>                                  &mesh,
             const std::function<Tensor<1, 3>(const Point<3> &)> &displacement)
  {
    QuadraticField<3> field;
    field.at_edges.resize(mesh.n_edges);
    for (const Point<3> &vertex : mesh.vertices)
      field.at_vertices.push_back(displacement(vertex));
    for (const auto &tetrahedron : mesh.simplices)
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = i + 1; j < 4; ++j)
          field.at_edges[tetrahedron.edges[edge_between<3>(i, j)]] =
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



  inline Point<3>
  point_of(const FaceCorners<3> &corners, const std::array<double, 3> &position)
  {
    return Point<3>(position[0] * corners[0] + position[1] * corners[1] +
                    position[2] * corners[2]);
  }



  /// Eight cells, of which one is refined. Collective.
  inline void
  make_block(Mesh &block)
  {
    GridGenerator::subdivided_hyper_rectangle(
      block, {2, 2, 2}, Point<3>(0, 0, -1), Point<3>(1, 1, 0), true);
    refine_where(block,
                 [&](const auto &cell) { return cell->center().norm() < 0.5; });
  }
} // namespace SpaceBlock

#endif
