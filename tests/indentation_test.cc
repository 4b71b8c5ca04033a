// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The evaluation of unloadings gives back what exact curves were made from:
// Sneddon's elastic solutions, where the contact area, the stiffness 2 E* a and
// the contact depth are known; a plastic imprint; which steps of a history
// belong to an unloading; the sections of tips, and the part of them that is
// modelled.

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>

#include "evaluation/indentation_test.h"
#include "evaluation/nominal_contact.h"
#include "evaluation/tip_on_surface.h"
#include "indenter/indenter_parameters.h"
#include "verdict.h"

using namespace ElastoPlastic;
using dealii::numbers::PI;

namespace
{
  const double modulus = 219780.;

  double
  relative_error(const double value, const double exact)
  {
    return std::abs(value / exact - 1.);
  }



  IndenterParameters
  indenter(const std::string &type)
  {
    IndenterParameters parameters;
    parameters.type            = type;
    parameters.radius          = 2.;
    parameters.semi_apex_angle = 70.3;
    return parameters;
  }



  /// A tip above a level surface.
  template <int dim>
  std::shared_ptr<const TipOnSurface>
  tip(const std::string &type, const double initial_gap)
  {
    return std::make_shared<TipOnLevelSurface>(
      make_indenter<dim>(indenter(type)).shape, initial_gap, MPI_COMM_WORLD);
  }



  /// An elastic indentation: force and contact radius over depth, pushed in and
  /// pulled out again in equal steps of the depth.
  void
  check_elastic(const std::string                         &type,
                const double                               exponent,
                const std::function<double(const double)> &force,
                const std::function<double(const double)> &radius)
  {
    const double initial_gap = 0.3, largest_depth = 0.01;
    for (const double part : {1., 0.25})
      {
        IndentationTest                test(tip<3>(type, initial_gap), part);
        std::optional<UnloadingResult> result;
        for (unsigned int step = 1; step <= 39 && !result; ++step)
          {
            const double depth =
              largest_depth * (1. - std::abs(step - 20.) / 20.);
            result = test.add({step,
                               step / 20.,
                               initial_gap + depth,
                               part * force(depth),
                               part * PI * std::pow(radius(depth), 2)});
          }
        const std::string title =
          type + (part < 1. ? ", a quarter: " : ", all of it: ");
        verify(title + "has a result", result.has_value());
        if (!result)
          continue;
        verify(title + "maximum", result->maximum.step == 20);
        verify(title + "exponent",
               relative_error(result->law.exponent, exponent),
               1e-6);
        verify(title + "final depth",
               std::abs(result->law.final_depth - initial_gap),
               1e-6 * largest_depth);
        verify(title + "stiffness",
               relative_error(result->stiffness,
                              part * 2. * modulus * radius(largest_depth)),
               1e-6);
        const double area = result->maximum.contact_area;
        verify(title + "reduced modulus",
               relative_error(result->reduced_modulus(area), modulus),
               1e-6);
        verify(title + "area of the tip",
               relative_error(result->tip_area, area),
               1e-6);
        verify(title + "hardness",
               relative_error(result->hardness(area),
                              force(largest_depth) / PI /
                                std::pow(radius(largest_depth), 2)),
               1e-12);
        const UnloadingResult continuous =
          test.with_stiffness(result->maximum,
                              part * 2. * modulus * radius(largest_depth));
        verify(title + "modulus from the stiffness alone, area of the tip",
               relative_error(continuous.reduced_modulus(continuous.tip_area),
                              modulus),
               1e-9);
      }
  }



  void
  check_sneddon()
  {
    const double R       = indenter("").radius;
    const double tangent = std::tan(indenter("").semi_apex_angle * PI / 180);
    check_elastic(
      "paraboloid",
      1.5,
      [&](const double d) {
        return 4. / 3. * modulus * std::sqrt(R) * std::pow(d, 1.5);
      },
      [&](const double d) { return std::sqrt(R * d); });
    check_elastic(
      "cone",
      2.,
      [&](const double d) { return 2. / PI * modulus * tangent * d * d; },
      [&](const double d) { return 2. / PI * tangent * d; });
    check_elastic(
      "circular punch",
      1.,
      [&](const double d) { return 2. * modulus * R * d; },
      [&](const double) { return R; });
  }



  /// An elastic half-space and an elastic indenter: the stiffnesses 2 E a add
  /// up as springs in a row, whatever part is modelled.
  void
  check_elastic_indenter()
  {
    UnloadingResult result;
    result.modelled_part      = 0.25;
    result.stiffness          = 0.25 * 2. * modulus * 3.;
    const double         area = 0.25 * PI * 9.;
    EvaluationParameters constants;
    verify("a rigid indenter has no compliance",
           constants.indenter_compliance() == 0.);
    constants.indenter_modulus = 1141e3;
    result.indenter_compliance = constants.indenter_compliance();
    verify("reduced modulus with a diamond",
           relative_error(1. / result.reduced_modulus(area),
                          1. / modulus + (1. - 0.07 * 0.07) / 1141e3),
           1e-14);
  }



  /// The steps of an imprint: force = 1e6 (depth - 0.006)^1.4 between the given
  /// shares of the force at the depth 0.01.
  std::vector<IndentationPoint>
  unloading(const double from, const double to, const unsigned int n_steps)
  {
    const double                  largest_force = 1e6 * std::pow(0.004, 1.4);
    std::vector<IndentationPoint> points;
    for (unsigned int i = 0; i <= n_steps; ++i)
      {
        const double force = largest_force * (from + (to - from) * i / n_steps);
        points.push_back(
          {i, 1. * i, 0.006 + std::pow(force / 1e6, 1 / 1.4), force, 1e-3});
      }
    return points;
  }



  /// Adds the points and prints which of them ended an unloading, counted from
  /// 0, and with which exponent.
  void
  print_results(const std::string                                &title,
                const std::vector<std::vector<IndentationPoint>> &parts)
  {
    output() << title << ":";
    const auto print = [](const std::optional<UnloadingResult> &result) {
      if (result)
        output() << " maximum at step " << result->maximum.step << ", exponent "
                 << result->law.exponent;
    };
    IndentationTest test(tip<2>("sphere", 0.), 1.);
    unsigned int    n_points = 0;
    for (const auto &part : parts)
      for (const IndentationPoint &point : part)
        {
          if (const auto result = test.add(point))
            {
              output() << " (after point " << n_points << ")";
              print(result);
            }
          ++n_points;
        }
    output() << " (at the end)";
    print(test.finish());
    output() << std::endl;
  }



  void
  check_histories()
  {
    const std::vector<IndentationPoint> all       = unloading(1., 0., 20);
    const std::vector<IndentationPoint> short_one = unloading(1., 0.6, 8);
    const std::vector<IndentationPoint> again     = {
          {100, 100., 0.011, 500., 1e-3}};
    print_results("unloaded completely", {all});
    print_results("unloaded to 60 per cent, then deeper", {short_one, again});
    print_results("unloaded to 60 per cent", {short_one});
    print_results("unloaded twice", {all, again, short_one});
    print_results("too few steps", {unloading(1., 0., 4)});
    print_results("never unloaded", {again});
    print_results("softens: less force, but deeper",
                  {{{1, 1., 0.010, 500., 1.},
                    {2, 2., 0.011, 450., 1.},
                    {3, 3., 0.012, 400., 1.},
                    {4, 4., 0.013, 350., 1.},
                    {5, 5., 0.014, 100., 1.}}});
  }



  /// The same imprint, while every step of a softer and softer mesh presses the
  /// indenter deeper, or loses force.
  void
  check_mesh_changes(const std::string &title,
                     const double       deeper,
                     const double       softer)
  {
    IndentationTest                test(tip<2>("sphere", 0.), 1.);
    std::optional<UnloadingResult> result;
    double                         depth_shift = 0, force_scale = 1;
    const auto                     on_mesh = [&](IndentationPoint point) {
      point.depth += depth_shift;
      point.force *= force_scale;
      return point;
    };
    const std::vector<IndentationPoint> points = unloading(1., 0., 20);
    test.add({0, 0., 0.0099, 0.9 * points[0].force, 1e-3});
    for (const IndentationPoint &point : points)
      {
        if (!result)
          result = test.add(on_mesh(point));
        const IndentationPoint before = on_mesh(point);
        depth_shift += deeper;
        force_scale *= softer;
        test.change_mesh(before, on_mesh(point));
      }
    verify(title + ": has a result", result.has_value());
    if (!result)
      return;
    verify(title + ": from the largest force",
           relative_error(result->maximum.force, points[0].force),
           1e-14);
    verify(title + ": largest depth",
           relative_error(result->maximum.depth, points[0].depth),
           1e-14);
    verify(title + ": exponent",
           relative_error(result->law.exponent, 1.4),
           1e-6);
    verify(title + ": final depth",
           relative_error(result->law.final_depth, 0.006),
           1e-6);
  }



  void
  check_sections()
  {
    const double h    = 0.1;
    const auto   area = [&](const IndenterParameters &parameters) {
      return make_indenter<3>(parameters).shape->section_area(h);
    };
    verify("section of the sphere",
           relative_error(area(indenter("sphere")), PI * h * (4. - h)),
           1e-12);
    verify("section of the same in two dimensions",
           relative_error(
             make_indenter<2>(indenter("sphere")).shape->section_area(h),
             PI * h * (4. - h)),
           1e-12);
    auto punch        = indenter("rectangular punch");
    punch.half_widths = {1., 3.};
    verify("section of the rectangular punch",
           relative_error(area(punch), 12.),
           1e-4);
    auto berkovich = indenter("expression");
    berkovich.expression =
      "max(x, max(-x/2 + sqrt(3)/2*y, -x/2 - sqrt(3)/2*y)) / tan(65.27*_pi/180)";
    verify("section of Berkovich's pyramid",
           relative_error(area(berkovich),
                          3 * std::sqrt(3.) *
                            std::pow(h * std::tan(65.27 * PI / 180), 2)),
           1e-4);
    verify("the cylinder has no bounded section",
           area(indenter("cylinder")) == 0.);
  }



  void
  check_modelled_part()
  {
    dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {4, 5, 2}, Point<3>(), Point<3>(4, 5, 2), true);
    mesh.refine_global(1);
    const auto verify_part = [&](const Point<2> &position, const double part) {
      verify("modelled part",
             std::abs(
               modelled_part(mesh, {5}, position, Kinematics::cartesian) -
               part),
             1e-12);
    };
    verify_part({0, 0}, 0.25);
    verify_part({4, 5}, 0.25);
    verify_part({1, 0}, 0.5);
    verify_part({1.1, 0}, 0.5);
    verify_part({1.1, 1.2}, 1);
    verify_part({1.5, 1.2}, 1);
    verify_part({2, 3}, 1);
    verify_part({-0.1, 3}, 0);
  }



  /// Of a plane body, one side or both.
  void
  check_modelled_part_of_plane()
  {
    dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {4, 2}, Point<2>(), Point<2>(4, 2), true);
    const auto part = [&](const double x, const Kinematics kinematics) {
      return modelled_part(mesh, {3}, Point<1>(x), kinematics);
    };
    verify("half of a plane body",
           part(0., Kinematics::cartesian) == 0.5 &&
             part(4., Kinematics::plane_stress) == 0.5);
    verify("all of it",
           part(1., Kinematics::cartesian) == 1. &&
             part(1.5, Kinematics::cartesian) == 1.);
    verify("beside it", part(4.5, Kinematics::cartesian) == 0.);
    verify("whole rings", part(0., Kinematics::axisymmetric) == 1.);
  }



  /// A curve that only a law with an exponent near 2000 follows, whose
  /// coefficient is no number of the machine.
  void
  check_exponential()
  {
    std::vector<std::pair<double, double>> points;
    for (double depth = 1.; depth < 2.; depth += 0.1)
      points.emplace_back(depth, std::exp(2. * depth));
    verify("exponential unloading: stiffness",
           relative_error(fit_power_law(points).stiffness(2.),
                          2. * std::exp(4.)),
           0.01);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_sneddon();
  check_elastic_indenter();
  check_histories();
  check_mesh_changes("deeper on each mesh", 2e-4, 1.);
  check_mesh_changes("less force on each mesh", 0., 0.9);
  check_sections();
  check_modelled_part();
  check_modelled_part_of_plane();
  check_exponential();
}
