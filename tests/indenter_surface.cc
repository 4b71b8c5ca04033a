// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Slope and curvature of all indenters, against difference quotients of their
// profiles. These, for a polynomial within and at the end of its reach. Then on
// the axis, at an end of the profile, beside it, and as the gap of a placed
// indenter. At last for nodes that sharp tips and edges hold below them.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iostream>

#include "contact/gap_function.h"
#include "indenter/indenter_parameters.h"

using namespace ElastoPlastic;

template <int dim>
void
compare(const IndenterParameters &parameters, const Point<dim - 1> &x)
{
  const auto                 indenter = make_indenter<dim>(parameters).shape;
  const IndenterSurface<dim> exact    = indenter->surface(x);
  const IndenterSurface<dim> quotient = indenter->Indenter<dim>::surface(x);
  const bool                 agrees   = exact.height == quotient.height &&
                      (exact.slope - quotient.slope).norm() < 1e-7 &&
                      (exact.curvature - quotient.curvature).norm() < 1e-6;
  std::cout << "  " << dim << "D " << parameters.type << ": "
            << (agrees ? "agrees" : "DIFFERS") << std::endl;
}



void
compare_all(IndenterParameters parameters)
{
  parameters.size        = {4};
  parameters.half_widths = {2};
  compare<2>(parameters, Point<1>(0.7));
  compare<2>(parameters, Point<1>(-0.7));
  parameters.size = {4, 4};
  if (parameters.type == "rectangular punch")
    parameters.half_widths = {2, 2};
  compare<3>(parameters, Point<2>(-0.7, 0.4));
}



template <int dim>
void
print(const std::string &where, const IndenterSurface<dim> &surface)
{
  std::cout << "  " << where << ": " << surface.height << " | " << surface.slope
            << " | " << surface.curvature << std::endl;
}



template <int dim>
std::shared_ptr<const Indenter<dim>>
shape(const std::string &type)
{
  IndenterParameters parameters;
  parameters.type            = type;
  parameters.radius          = 2;
  parameters.semi_apex_angle = 45;
  parameters.half_widths     = {2};
  parameters.expression      = "x^2 + x*y - 3*y^2 + y";
  parameters.reach           = 2;
  return make_indenter<dim>(parameters).shape;
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::cout << "Against difference quotients" << std::endl;
  IndenterParameters parameters;
  parameters.radius = 2;
  for (const std::string type : {"sphere",
                                 "paraboloid",
                                 "cylinder",
                                 "cone",
                                 "wedge",
                                 "circular punch",
                                 "strip punch",
                                 "rectangular punch",
                                 "spheroconical tip",
                                 "area function"})
    {
      parameters.type = type;
      compare_all(parameters);
    }

  parameters.type = "height matrix";
  parameters.file = "heights.txt";
  parameters.size = {4, 3};
  std::ofstream(parameters.file) << "1 4 2\n3 5 0\n";
  compare<3>(parameters, Point<2>(0.7, 0.4));
  compare<3>(parameters, Point<2>(-0.7, -0.4));

  std::cout << "On the axis" << std::endl;
  for (const std::string type : {"sphere", "cone"})
    {
      print<2>("2D " + type, shape<2>(type)->surface(Point<1>()));
      print<3>("3D " + type, shape<3>(type)->surface(Point<2>()));
    }
  print<3>("3D cylinder", shape<3>("cylinder")->surface(Point<2>(0, 1)));

  std::cout << "At the end and beside" << std::endl;
  print<2>("2D sphere", shape<2>("sphere")->surface(Point<1>(3)));
  print<3>("3D circular punch", shape<3>("circular punch")->surface({2., 0.}));
  const auto rounded = [](IndenterSurface<3> surface) {
    for (auto *const value : {&surface.slope[0], &surface.slope[1]})
      *value = std::round(1e5 * *value) / 1e5;
    for (unsigned int i = 0; i < 3; ++i)
      {
        double &value = surface.curvature.access_raw_entry(i);
        value         = std::round(1e5 * value) / 1e5;
      }
    return surface;
  };
  const auto expression = shape<3>("expression");
  print<3>("3D expression", rounded(expression->surface({0.5, 1.})));
  print<3>("3D expression", rounded(expression->surface({2., 0.})));
  print<3>("3D expression",
           rounded(expression->surface({std::sqrt(2), -std::sqrt(2)})));

  std::cout << "Gap" << std::endl;
  parameters.type        = "paraboloid";
  parameters.position    = {1, 2};
  parameters.initial_gap = 0.25;
  parameters.reach       = 3;
  const GapFunction<3> gap(make_indenter<3>(parameters), 10, 1);
  print<3>("within reach", gap.surface({2, 4, 9.5}));
  print<3>("beyond reach", gap.surface({5, 2, 9.5}));

  std::cout << "Nodes below a tip, an edge, and beside" << std::endl;
  for (const std::string type : {"sphere", "cone", "wedge"})
    for (const Point<2> &origin : {Point<2>(0, 1e-16), Point<2>(0.1, 0)})
      print<3>(type, shape<3>(type)->surface_for(origin, {0.3, 0.4}, 1.));
  parameters.type            = "pyramid";
  parameters.n_faces         = 4;
  parameters.face_angle      = 45;
  parameters.rotation        = 45;
  parameters.rounding_radius = 0;
  parameters.position        = {0, 0};
  parameters.initial_gap     = 0;
  const auto pyramid         = make_indenter<3>(parameters).shape;
  for (const Point<2> &origin :
       {Point<2>(), Point<2>(1, 1e-16), Point<2>(0.9, 0.1), Point<2>(0, -1)})
    print<3>("pyramid", pyramid->surface_for(origin, {1.1, 0.2}, 1.));
  const GapFunction<3> above(make_indenter<3>(parameters), 10, 1);
  print<3>("gap", above.surface_for({1, 0, 10}, {1.1, 0.2, 9.5}));

  // (rounding errors of coordinates are those of a body of this size)
  const GapFunction<3> large(make_indenter<3>(parameters), 10, 1e6);
  print<3>("below an edge of a large one",
           large.surface_for({1, 1e-7, 10}, {1.1, 0.2, 9.5}));
  print<3>("beside that of a small one",
           above.surface_for({1, 1e-7, 10}, {1.1, 0.2, 9.5}));
}
