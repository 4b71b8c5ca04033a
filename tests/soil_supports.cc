// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What holds soil: rollers that are plane but for the digits of a mesh file
// change no bound, in the plane, in revolution and in space. In a body of
// revolution, soil slides along rollers that are oblique to the axis: a cone
// under the same tension everywhere, and a section that stands oblique, have
// exact limit loads, and the bounds of one that is squeezed through a funnel
// converge.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

#include "box_names.h"
#include "soil_bounds.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  const BoundaryNames &
  names()
  {
    if constexpr (dim == 3)
      return names_of_box;
    else
      return SectionBody::names;
  }

  /// With the angle of friction 20 degrees. The indenter presses everywhere.
  template <int dim>
  LimitLoad<dim>
  checked_bounds(const SplitMesh<dim>              &mesh,
                 const BoundaryConditionParameters &parameters,
                 const Kinematics                   kinematics,
                 const double                       rounding = 1e-12)
  {
    return SoilBounds::checked_bounds(
      SoilBounds::make_body<dim>(mesh,
                                 names<dim>(),
                                 parameters,
                                 {[](const Point<dim> &) {
                                   return 0.;
                                 }},
                                 {20.},
                                 kinematics),
      /* degree = */ kinematics == Kinematics::axisymmetric ? 2 : 1,
      rounding);
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
    SplitMesh<dim> mesh  = make_cube<dim>();
    const auto     exact = checked_bounds(mesh, parameters, kinematics);
    round_planes(mesh, kinematics == Kinematics::axisymmetric ? 1 : 0);
    const auto rounded = checked_bounds(mesh, parameters, kinematics);
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
    const auto   bounds =
      checked_bounds(make_cone(2), parameters, Kinematics::axisymmetric);
    verify("lower bound", std::abs(bounds.lower_bound / limit - 1.), 2e-5);
    verify("upper bound", std::abs(bounds.upper_bound / limit - 1.), 2e-5);
  }

  /// A ring around a wide hole deforms as its section, a square that stands at
  /// an angle to the axis between rollers: it bears what its condition in plane
  /// strain admits, 2 c tan(45 degrees + phi / 2), but for what its radii
  /// differ by.
  void
  test_turned_square()
  {
    output() << "Section between oblique rollers" << std::endl;
    constexpr double radius = 1e3;
    SplitMesh<2>     mesh   = make_cube<2>();
    const double     cosine = std::cos(0.4), sine = std::sin(0.4);
    for (Point<2> &x : mesh.vertices)
      x = Point<2>(radius + cosine * x[0] - sine * x[1],
                   sine * x[0] + cosine * x[1]);
    BoundaryConditionParameters parameters;
    parameters.roller = {"left", "bottom"};
    parameters.free   = {"right"};
    parameters.traction =
      "top: " + std::to_string(sine) + "*t; " + std::to_string(-cosine) + "*t";
    const double limit  = 2. * std::tan((45. + 10.) / 180. * numbers::PI);
    const auto   bounds = checked_bounds(mesh,
                                       parameters,
                                       Kinematics::axisymmetric,
                                       /* rounding = */ 1e-8);
    verify("lower bound", std::abs(bounds.lower_bound / limit - 1.), 2e-3);
    verify("upper bound", std::abs(bounds.upper_bound / limit - 1.), 2e-3);
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
    const auto bounds   = [&](const unsigned int n) {
      return checked_bounds(make_cone(n), parameters, Kinematics::axisymmetric);
    };
    const auto coarse = bounds(4), fine = bounds(8);
    verify("bounds of smaller cells are inside",
           coarse.lower_bound < fine.lower_bound &&
             fine.upper_bound < coarse.upper_bound);
    verify("and half as far apart",
           (fine.upper_bound - fine.lower_bound) /
             (coarse.upper_bound - coarse.lower_bound),
           0.5);
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
  test_turned_square();
  test_funnel();
}
