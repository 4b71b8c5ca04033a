// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Tips of laboratories: sections against closed formulas and against
// quadrature, transitions without a jump in height and slope, and the body of
// an area function.

#include <algorithm>
#include <cmath>

#include "indenter/indenter_parameters.h"
#include "verdict.h"

using namespace ElastoPlastic;
using dealii::numbers::PI;

namespace
{
  double
  relative_error(const double value, const double exact)
  {
    return std::abs(value / exact - 1.);
  }



  IndenterParameters
  pyramid(const unsigned int n_faces, const double face_angle)
  {
    IndenterParameters parameters;
    parameters.type       = "pyramid";
    parameters.n_faces    = n_faces;
    parameters.face_angle = face_angle;
    return parameters;
  }



  std::shared_ptr<const Indenter<3>>
  make(const IndenterParameters &parameters)
  {
    parameters.check(3);
    return make_indenter<3>(parameters).shape;
  }



  void
  verify_value(const std::string &name,
               const double       value,
               const double       exact,
               const double       tolerance)
  {
    verify(name, std::abs(value - exact), tolerance);
  }



  void
  verify_section(const std::string        &name,
                 const IndenterParameters &parameters,
                 const double              height,
                 const double              area)
  {
    verify("section, " + name,
           relative_error(make(parameters)->section_area(height), area),
           1e-12);
  }



  void
  check_sharp_pyramids()
  {
    const double h = 0.3;
    verify_section("Vickers",
                   pyramid(4, 68),
                   h,
                   4 * std::pow(h * std::tan(68 * PI / 180), 2));
    verify_value("Vickers, 24.504 h^2",
                 make(pyramid(4, 68))->section_area(1.),
                 24.504,
                 5e-4);
    verify_value("Berkovich, 23.96 h^2",
                 make(pyramid(3, 65.03))->section_area(1.),
                 23.96,
                 5e-3);
    verify_value("modified Berkovich, 24.494 h^2",
                 make(pyramid(3, 65.27))->section_area(1.),
                 24.494,
                 5e-3);
    verify_value("corner of a cube, 2.598 h^2",
                 make(pyramid(3, 35.2644))->section_area(1.),
                 2.598,
                 5e-4);

    IndenterParameters cut = pyramid(4, 68);
    cut.truncation         = 0.1;
    verify_section("truncated",
                   cut,
                   h,
                   4 * std::pow((h + 0.1) * std::tan(68 * PI / 180), 2));
    verify("truncated, flat", make(cut)->profile({0.2, 0.1}) == 0.);
    verify_value("truncated, face",
                 make(cut)->profile({0.3, 1.}),
                 1. / std::tan(68 * PI / 180) - 0.1,
                 1e-15);
  }



  /// A cube stands on its corner: three edges of equal length meet at right
  /// angles.
  void
  check_rotation()
  {
    IndenterParameters cube = pyramid(3, 35.2643896827546);
    cube.rotation           = 15;
    const double edge       = (15 + 60) * PI / 180;
    const double r          = std::sqrt(2. / 3);
    verify_value("edge of a cube rises by 1/sqrt(3)",
                 make(cube)->profile({r * std::cos(edge), r * std::sin(edge)}),
                 1 / std::sqrt(3.),
                 1e-12);
  }



  /// Slope and curvature against difference quotients.
  void
  verify_derivatives(const std::string &name,
                     const Indenter<3> &indenter,
                     const Point<2>    &x)
  {
    const auto exact     = indenter.surface(x);
    const auto quotients = indenter.Indenter<3>::surface(x);
    verify(name + ", slope", (exact.slope - quotients.slope).norm(), 1e-7);
    verify(name + ", curvature",
           (exact.curvature - quotients.curvature).norm(),
           1e-6);
  }



  /// Many points on a spiral up to r = 3: heights follow from slopes, and
  /// slopes from curvatures.
  void
  verify_smooth(const std::string &name, const Indenter<3> &indenter)
  {
    const unsigned int n_points        = 300000;
    double             error_of_height = 0, error_of_slope = 0;
    Point<2>           last_point;
    auto               last = indenter.surface(last_point);
    for (unsigned int i = 1; i <= n_points; ++i)
      {
        const double   r = 3 * std::sqrt(i / (1. * n_points));
        const Point<2> point(r * std::cos(20 * r), r * std::sin(20 * r));
        const auto     next      = indenter.surface(point);
        const auto     way       = point - last_point;
        const auto     slope     = 0.5 * (last.slope + next.slope);
        const auto     curvature = 0.5 * (last.curvature + next.curvature);
        error_of_height =
          std::max(error_of_height,
                   std::abs(next.height - last.height - slope * way));
        error_of_slope =
          std::max(error_of_slope,
                   (next.slope - last.slope - curvature * way).norm());
        last       = next;
        last_point = point;
      }
    verify(name + ", height is continuous", error_of_height, 1e-6);
    verify(name + ", slope is continuous", error_of_slope, 2e-3);
  }



  /// The rounded pyramid is the lower surface of all balls whose centres are
  /// inside a pyramid: of many of them, n in a radius.
  double
  height_of_balls(const double    radius,
                  const double    slope,
                  const unsigned  n_faces,
                  const int       n,
                  const Point<2> &x)
  {
    double lowest = 1e300;
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        {
          const Point<2> y = x + radius / n * Point<2>(i, j);
          if ((x - y).norm() > radius)
            continue;
          double centre = 0;
          for (unsigned int f = 0; f < n_faces; ++f)
            {
              const double angle = 2 * PI * f / n_faces;
              centre             = std::max(centre,
                                slope * (y[0] * std::cos(angle) +
                                         y[1] * std::sin(angle)));
            }
          lowest =
            std::min(lowest,
                     centre + radius -
                       std::sqrt(radius * radius - (x - y).norm_square()));
        }
    return lowest;
  }



  void
  check_rounded_pyramids()
  {
    for (const auto &[n_faces, angle] :
         std::vector<std::pair<unsigned int, double>>{{4, 68.}, {3, 35.2644}})
      {
        IndenterParameters parameters = pyramid(n_faces, angle);
        parameters.rounding_radius    = 0.7;
        const auto        indenter    = make(parameters);
        const std::string name =
          "rounded, " + std::to_string(n_faces) + " faces";
        verify_smooth(name, *indenter);

        const double slope = 1 / std::tan(angle * PI / 180);
        const int    n     = 300;
        for (const Point<2> &x : {Point<2>(0.1, 0.05),
                                  Point<2>(-0.3, 0.35),
                                  Point<2>(0.2, 0.5),
                                  Point<2>(1., 1.1),
                                  Point<2>(-1.5, 0.2)})
          {
            const double above =
              height_of_balls(0.7, slope, n_faces, n, x) - indenter->profile(x);
            verify(name + ", lowest of the balls",
                   above > -1e-12 && above < slope * 0.7 / n);
            verify_derivatives(name, *indenter, x);
          }
        for (const double h : {0.01, 0.04, 0.15, 0.3, 1., 3.})
          verify(name + ", section",
                 relative_error(indenter->section_area(h),
                                indenter->Indenter<3>::section_area(h)),
                 1e-4);
      }
  }



  void
  check_spheroconical_tip()
  {
    IndenterParameters parameters;
    parameters.type            = "spheroconical tip";
    parameters.radius          = 0.5;
    parameters.semi_apex_angle = 60;
    const auto   indenter      = make(parameters);
    const double end           = 0.5 * (1 - std::sin(PI / 3));
    verify_smooth("spheroconical tip", *indenter);
    verify_value("height of the transition",
                 indenter->profile({0.25, 0.}),
                 end,
                 1e-15);
    verify_section("cap",
                   parameters,
                   0.5 * end,
                   PI * 0.5 * end * (1 - 0.5 * end));
    verify_section("cone",
                   parameters,
                   end + 0.4,
                   PI * std::pow(0.25 + 0.4 * std::sqrt(3.), 2));
    verify("section in two dimensions",
           make_indenter<2>(parameters).shape->section_area(0.2) ==
             indenter->section_area(0.2));
  }



  void
  check_area_functions()
  {
    IndenterParameters parameters;
    parameters.type              = "area function";
    parameters.area_coefficients = {24.5};
    const auto cone              = make(parameters);
    verify_value("cone of the area 24.5 h^2",
                 cone->profile({0.3, 0.4}),
                 0.5 * std::sqrt(PI / 24.5),
                 1e-15);

    parameters.area_coefficients = {0, 8 * PI};
    const auto paraboloid        = make(parameters);
    verify_value("paraboloid, height",
                 paraboloid->profile({0., 1.}),
                 1. / 8,
                 1e-15);
    verify_value("paraboloid, curvature in the tip",
                 paraboloid->surface({0., 0.}).curvature[1][1],
                 1. / 4,
                 1e-15);
    verify_smooth("paraboloid", *paraboloid);

    parameters.area_coefficients = {-PI, 4 * PI};
    bool refused                 = false;
    try
      {
        make(parameters);
      }
    catch (const InputError &)
      {
        refused = true;
      }
    verify("sphere: ends at its equator, refused", refused);

    parameters.area_coefficients = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    const auto needle            = make(parameters);
    verify("section h^(1/128): flat, then a wall",
           needle->profile({0.05, 0.}) == 0. &&
             std::isinf(needle->profile({2000., 0.})));
    verify_section("of h^(1/128)", parameters, 1., 1.);

    parameters.area_coefficients = {24.5, -0.1, 0.03, 0, 0.02};
    const auto   calibrated      = make(parameters);
    const double h               = 0.2,
                 r = std::sqrt((24.5 * h * h - 0.1 * h + 0.03 * std::sqrt(h) +
                                0.02 * std::pow(h, 0.125)) /
                               PI);
    verify_value("calibrated, height", calibrated->profile({0., r}), h, 1e-14);
    verify_section("calibrated", parameters, h, PI * r * r);
    verify("calibrated, not known to be convex", !calibrated->is_convex());
    verify_derivatives("calibrated", *calibrated, {0.3, 0.4});
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_sharp_pyramids();
  check_rotation();
  check_rounded_pyramids();
  check_spheroconical_tip();
  check_area_functions();
}
