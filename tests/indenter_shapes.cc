// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Profiles of all indenters that are not read from a file, against exact
// values: a Pythagorean triple for the circles, 45 degrees for the flanks. Then
// place, gap and reach, how their contact grows, and what the parameters
// refuse.

#include <deal.II/base/mpi.h>

#include <iostream>

#include "contact/gap_function.h"
#include "indenter/indenter_parameters.h"
#include "refused_indenter.h"

using namespace ElastoPlastic;

IndenterParameters
shape(const std::string &type)
{
  IndenterParameters parameters;
  parameters.type            = type;
  parameters.radius          = 5;
  parameters.semi_apex_angle = 45;
  parameters.expression      = "x^2 + 10*y";
  return parameters;
}



template <int dim>
void
print_profile(const std::string                 &name,
              const IndenterParameters          &parameters,
              const std::vector<Point<dim - 1>> &points)
{
  parameters.check(dim);
  const GapFunction<dim> gap(make_indenter<dim>(parameters), 0, 1);

  std::cout << "  " << name << ":";
  for (const auto &x : points)
    {
      Point<dim> p;
      for (unsigned int d = 0; d < dim - 1; ++d)
        p[d] = x[d];
      std::cout << ' ' << gap.value(p);
    }
  std::cout << std::endl;
}



template <int dim>
void
print_profiles(const std::vector<Point<dim - 1>> &points)
{
  std::cout << dim << " dimensions, at";
  for (const auto &x : points)
    std::cout << " (" << x << ")";
  std::cout << std::endl;

  for (const std::string type : {"sphere",
                                 "paraboloid",
                                 "cylinder",
                                 "cone",
                                 "wedge",
                                 "circular punch",
                                 "expression",
                                 "none"})
    print_profile<dim>(type, shape(type), points);

  IndenterParameters punch = shape("strip punch");
  punch.half_widths        = {3};
  print_profile<dim>("strip punch", punch, points);

  punch.type = "rectangular punch";
  if (dim == 3)
    punch.half_widths = {3, 4};
  print_profile<dim>("rectangular punch", punch, points);
}



template <int dim>
void
print_gap(const IndenterParameters &parameters, const Point<dim> &p)
{
  parameters.check(dim);
  const GapFunction<dim> gap(make_indenter<dim>(parameters),
                             /* surface_height = */ 10,
                             /* body_size = */ 1);
  std::cout << "  " << gap.has_indenter() << ' ' << gap.value(p) << std::endl;
}



void
print_gaps()
{
  std::cout << "Place, gap and reach" << std::endl;
  IndenterParameters moved = shape("paraboloid");
  moved.position           = {1, 2};
  moved.initial_gap        = 0.25;
  moved.reach              = 0.1 * 3;
  print_gap(moved, Point<3>(1, 2, 10));
  print_gap(moved, Point<3>(1, 2, 9.5));
  print_gap(moved, Point<3>(1, 2.3, 10));
  print_gap(moved, Point<3>(1.3, 2.3, 10));

  moved.position = {1};
  print_gap(moved, Point<2>(1.25, 10));
  print_gap(moved, Point<2>(2, 10));
  moved.type = "none";
  print_gap(moved, Point<2>(1, 10));

  // R - sqrt(R^2 - r^2) would lose all digits here.
  IndenterParameters large = shape("sphere");
  large.radius             = 1e8;
  std::cout << "Huge sphere: "
            << GapFunction<3>(make_indenter<3>(large), 0, 1)
                   .value(Point<3>(0.6, 0.8, 0)) *
                 2e8
            << std::endl;
}



template <int dim>
void
print_growth(const std::string &type, const double initial_gap = 0)
{
  PlacedIndenter<dim> indenter;
  indenter.shape       = make_indenter<dim>(shape(type)).shape;
  indenter.initial_gap = initial_gap;
  std::cout << "  " << type << ", gap " << initial_gap << ":";
  for (const auto &[depth, next] : {std::pair(1., 2.),
                                    std::pair(2., 1.),
                                    std::pair(0., 1.),
                                    std::pair(6., 7.)})
    std::cout << ' ' << indenter.growth_of_contact(depth, next);
  std::cout << std::endl;
}



template <int dim>
void
print_growths()
{
  std::cout << "Growth of the contact in " << dim
            << " dimensions, depth 1 to 2, 2 to 1, 0 to 1, 6 to 7" << std::endl;
  for (const std::string type :
       {"sphere", "paraboloid", "cylinder", "cone", "circular punch", "none"})
    print_growth<dim>(type);
  print_growth<dim>("cone", 0.5);
  print_growth<dim>("cone", 0.9);
}



void
print_errors()
{
  std::cout << "Errors" << std::endl;
  const auto changed = [](const auto &change) {
    IndenterParameters parameters = shape("sphere");
    change(parameters);
    return parameters;
  };
  using P = IndenterParameters;
  print_refusal(changed([](P &p) { p.radius = 0; }), 3);
  print_refusal(changed([](P &p) { p.semi_apex_angle = 90; }), 3);
  print_refusal(changed([](P &p) { p.half_widths = {1, -1}; }), 3);
  print_refusal(changed([](P &p) { p.size = {0}; }), 2);
  print_refusal(changed([](P &p) { p.height_scale = -2; }), 3);
  print_refusal(changed([](P &p) { p.initial_gap = -0.5; }), 3);
  print_refusal(changed([](P &p) { p.reach = -1; }), 3);
  print_refusal(changed([](P &p) { p.position = {1}; }), 3);
  print_refusal(changed([](P &p) { p.position = {1, 2}; }), 2);
  print_refusal(changed([](P &p) { p.type = "rectangular punch"; }), 3);
  print_refusal(changed([](P &p) {
                  p.type        = "strip punch";
                  p.half_widths = {1, 2};
                }),
                2);
  print_refusal(changed([](P &p) { p.type = "image"; }), 2);
}



void
print_defaults()
{
  ParameterHandler   prm;
  IndenterParameters parameters;
  parameters.add_parameters(prm);
  prm.parse_input_from_string(
    "subsection Indenter\n"
    "  set Type = rectangular punch\n"
    "  set Half width = 0.5, 0.25\n"
    "  set Position = 1, 2\n"
    "end\n");
  std::cout << "Parsed: " << parameters.type << ' ' << parameters.half_widths[1]
            << ' ' << parameters.position[1] << ' ' << parameters.size.size()
            << std::endl;
  parameters.check(3);
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print_profiles<2>({Point<1>(0.), Point<1>(-3.), Point<1>(4.), Point<1>(6.)});
  print_profiles<3>({Point<2>(0, 0),
                     Point<2>(-3, 0),
                     Point<2>(0, -4),
                     Point<2>(3, 4),
                     Point<2>(4, 4)});
  print_gaps();
  print_growths<2>();
  print_growths<3>();
  print_errors();
  print_defaults();
}
