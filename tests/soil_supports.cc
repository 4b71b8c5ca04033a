// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What holds soil: rollers that are plane but for the digits of a mesh file
// change no bound, in the plane, in revolution and in space. In a body of
// revolution, soil slides along rollers that are oblique to the axis: a cone
// under the same tension everywhere has an exact limit load, and one that is
// squeezed through a funnel has close bounds.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "box_names.h"
#include "section_body.h"
#include "soil_bounds.h"

using namespace ElastoPlastic;

namespace
{
  /// With the cohesion 1.
  template <int dim>
  SplitBody<dim>
  make_body(const SplitMesh<dim>              &mesh,
            const BoundaryConditionParameters &parameters,
            const double                       degrees,
            const Kinematics kinematics = Kinematics::cartesian)
  {
    SoilParameters soil;
    soil.cohesions       = {1.};
    soil.friction_angles = {degrees};
    const bool is_plane  = dim == 2 && kinematics == Kinematics::cartesian;
    const auto [radius, slope] =
      is_plane ? soil.mohr_coulomb(0) : soil.drucker_prager(0);
    const BoundaryNames names = [] {
      if constexpr (dim == 3)
        return names_of_box;
      else
        return SectionBody::names;
    }();
    const BoundaryConditions<dim> conditions(parameters, names);
    const BodyForce<dim>          no_force(dim == 2 ? "0; 0" : "0; 0; 0");
    auto                          body =
      make_split_body<dim>(mesh,
                           conditions,
                           {SectionBody::material(radius, 0.)},
                           {[](const Point<dim> &) {
                             return 0.;
                           }},
                           parameters.contact.empty() ?
                             growing_loads(mesh, conditions, no_force) :
                             Loads<dim>(/* time = */ 0., no_force),
                           kinematics);
    set_friction(body, {slope});
    return body;
  }



  /// A cube or square, or half the section of a cylinder.
  template <int dim>
  SplitMesh<dim>
  make_cube()
  {
    Triangulation<dim> cube;
    GridGenerator::subdivided_hyper_cube(
      cube, 3, 0., 1., /* colorize = */ true);
    return make_split_mesh(cube);
  }

  /// Moves the vertices on the planes between which the body stands, but those
  /// on the @p first planes, by what is lost in seven digits.
  template <int dim>
  void
  round_planes(SplitMesh<dim> &mesh, const unsigned int first)
  {
    double phase = 0.;
    for (Point<dim> &vertex : mesh.vertices)
      for (unsigned int d = first; d < dim; ++d)
        if (std::abs(vertex[d]) < 1e-9)
          vertex[d] += 1e-7 * std::sin(phase += 1.7);
  }

  template <int dim>
  void
  test_rounded_planes(const std::string                 &title,
                      const BoundaryConditionParameters &parameters,
                      const Kinematics kinematics = Kinematics::cartesian)
  {
    output() << title << std::endl;
    SplitMesh<dim>     mesh   = make_cube<dim>();
    const unsigned int degree = kinematics == Kinematics::axisymmetric ? 2 : 1;
    const auto         exact =
      SoilBounds::checked_bounds(make_body(mesh, parameters, 20., kinematics),
                                 degree);
    round_planes(mesh, kinematics == Kinematics::axisymmetric ? 1 : 0);
    const auto rounded =
      SoilBounds::checked_bounds(make_body(mesh, parameters, 20., kinematics),
                                 degree);
    verify("same lower bound",
           std::abs(rounded.lower_bound / exact.lower_bound - 1.),
           1e-5);
    verify("same upper bound",
           std::abs(rounded.upper_bound / exact.upper_bound - 1.),
           1e-5);
  }



  /// Half the section of a truncated cone, which is as wide as it is high above
  /// its tip: from z = 1 to z = 2.
  SplitMesh<2>
  make_cone(const unsigned int n)
  {
    Triangulation<2> section;
    GridGenerator::subdivided_hyper_rectangle(
      section, {n, n}, Point<2>(0., 1.), Point<2>(1., 2.), true);
    GridTools::transform(
      [](const Point<2> &x) { return Point<2>(x[0] * x[1], x[1]); }, section);
    return make_split_mesh(section);
  }

  /// The velocity v = x works at the apex of the yield condition, and slides
  /// along the cone.
  void
  test_cone_under_tension()
  {
    output() << "Cone under tension" << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller   = {"left", "right"};
    parameters.traction = "top: 0; t | bottom: 0; -t";
    const double limit  = 1. / std::tan(20. / 180. * numbers::PI);
    const auto   bounds = SoilBounds::checked_bounds(
      make_body(make_cone(2), parameters, 20., Kinematics::axisymmetric),
      /* degree = */ 2);
    verify("lower bound", std::abs(bounds.lower_bound / limit - 1.), 2e-5);
    verify("upper bound", std::abs(bounds.upper_bound / limit - 1.), 2e-5);
  }

  // (The stress is singular at the lip: the bounds approach each other in
  // proportion to the size of the cells.)
  void
  test_funnel()
  {
    output() << "Funnel" << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller   = {"left", "right"};
    parameters.free     = {"bottom"};
    parameters.traction = "top: 0; -t";
    const auto bounds   = SoilBounds::checked_bounds(
      make_body(make_cone(12), parameters, 20., Kinematics::axisymmetric),
      /* degree = */ 2);
    verify("bounds", bounds.upper_bound / bounds.lower_bound - 1., 0.15);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  BoundaryConditionParameters      plane;
  plane.roller  = {"left", "bottom"};
  plane.free    = {"right"};
  plane.contact = {"top"};
  test_rounded_planes<2>("Plane strain", plane);
  test_rounded_planes<2>("Revolution", plane, Kinematics::axisymmetric);
  BoundaryConditionParameters space = plane;
  space.roller                      = {"left", "front", "bottom"};
  space.free                        = {"right", "back"};
  test_rounded_planes<3>("Space", space);
  test_cone_under_tension();
  test_funnel();
}
