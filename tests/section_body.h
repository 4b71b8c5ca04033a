// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_section_body_h
#define tests_section_body_h

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bounds/body/split_body.h"
#include "refine_where.h"

// Small bodies for tests of the equilibrium method.

namespace SectionBody
{
  using namespace ElastoPlastic;

  using Gap = std::function<double(const Point<2> &)>;

  inline const Gap everywhere = [](const Point<2> &) {
    return 0.;
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

  /// Its yield stress is 1.
  inline Material<double>
  material()
  {
    return material(std::sqrt(2. / 3.), 0.);
  }



  enum class MeshKind
  {
    regular,
    refined,  ///< around (1, 0), with hanging nodes
    distorted ///< inside
  };

  inline const std::map<MeshKind, std::string> kinds = {
    {MeshKind::regular, ", regular mesh"},
    {MeshKind::refined, ", refined mesh"},
    {MeshKind::distorted, ", distorted mesh"}};

  /// Boundaries 0 to 3: left, right, bottom, top. The top is at z = 0.
  inline void
  make_rectangle(Triangulation<2>  &mesh,
                 const MeshKind     kind,
                 const unsigned int n,
                 const double       inner_radius,
                 const double       outer_radius,
                 const double       height)
  {
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              {n, n},
                                              Point<2>(inner_radius, -height),
                                              Point<2>(outer_radius, 0.),
                                              /* colorize = */ true);
    if (kind == MeshKind::distorted)
      GridTools::distort_random(0.25, mesh, /* keep_boundary = */ true);
    for (unsigned int k = 0; k < (kind == MeshKind::refined ? 3 : 0); ++k)
      refine_where(mesh, [&](const auto &cell) {
        return cell->center().distance({1., 0.}) < 1.5 * cell->diameter();
      });
  }



  inline const BoundaryNames names = {{"left", 0},
                                      {"right", 1},
                                      {"bottom", 2},
                                      {"top", 3}};

  /// Under a plate.
  inline BoundaryConditions<2>
  on_rollers(const std::vector<std::string> &rollers,
             const std::vector<std::string> &free)
  {
    BoundaryConditionParameters parameters;
    parameters.roller  = rollers;
    parameters.free    = free;
    parameters.contact = {"top"};
    return {parameters, names};
  }



  inline SplitBody<2>
  make_body(const Triangulation<2>      &mesh,
            const BoundaryConditions<2> &conditions,
            const Gap                   &gap,
            const SurfaceFinish          surface    = SurfaceFinish::smooth,
            const Kinematics             kinematics = Kinematics::axisymmetric)
  {
    return make_split_body<2>(make_split_mesh(mesh),
                              conditions,
                              {material()},
                              {gap, surface},
                              /* time = */ 0.,
                              kinematics);
  }



  /// Puts a @p pressure on a boundary, normal to its sides.
  inline void
  press(SplitBody<2>            &body,
        const types::boundary_id boundary,
        const double             pressure)
  {
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      if (body.mesh.faces[s].boundary_id == boundary)
        {
          const Tensor<1, 2> load =
            -pressure * normal(body.mesh.corners(body.mesh.faces[s]));
          for (unsigned int d = 0; d < 2; ++d)
            body.conditions[s].components[d] = {Point<2>::unit_vector(d),
                                                ConditionType::traction,
                                                {[load_d = load[d]](
                                                   const FacePoint<2> &) {
                                                  return load_d;
                                                }}};
        }
  }



  /// A quarter of a ring inside the shell between the radii 1 and 2, whose
  /// sides are chords outside and tangents inside, below the plane z = 0.
  inline void
  make_shell(Triangulation<2> &mesh, const unsigned int n)
  {
    GridGenerator::subdivided_hyper_cube(
      mesh, n, 0., 1., /* colorize = */ true);
    const double step = 0.5 * numbers::PI / n;
    GridTools::transform(
      [step](const Point<2> &x) {
        const double inner  = 1. / std::cos(0.5 * step);
        const double radius = inner * std::pow(2. / inner, x[0]);
        const double angle  = 0.5 * numbers::PI * (x[1] - 1.);
        return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
      },
      mesh);
  }
} // namespace SectionBody

#endif
