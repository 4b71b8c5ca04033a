// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The area that a tip and an undeformed surface overlap, where it is known: on
// surfaces that the faces of a mesh describe exactly, and on a ball, which they
// approximate; whatever part of the body is modelled, and wherever the tip has
// moved to.

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <functional>

#include "evaluation/tip_on_curved_surface.h"
#include "indenter/indenter_parameters.h"
#include "mesh/body_size.h"
#include "verdict.h"

using namespace ElastoPlastic;
using dealii::numbers::PI;

namespace
{
  const double radius = 2., semi_apex_angle = 60., gap_of_highest_point = 0.3;

  double
  relative_error(const double value, const double exact)
  {
    return std::abs(value / exact - 1.);
  }



  /// A box of the width 1 or, on both sides of the axis, 2, whose top has been
  /// moved to a height above the horizontal coordinates.
  template <int dim>
  class CurvedBody
  {
  public:
    CurvedBody(const Point<dim - 1> &left_end,
               const unsigned int    n_refinements,
               const std::function<double(const Point<dim - 1> &)> &height)
      : mesh(MPI_COMM_WORLD)
    {
      Point<dim> lower, upper;
      lower[dim - 1] = -1.;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          lower[d] = left_end[d];
          upper[d] = 1.;
        }
      dealii::GridGenerator::hyper_rectangle(mesh, lower, upper, true);
      mesh.refine_global(n_refinements);
      dealii::GridTools::transform(
        [&](const Point<dim> &x) {
          Point<dim - 1> from_above;
          for (unsigned int d = 0; d < dim - 1; ++d)
            from_above[d] = x[d];
          Point<dim> moved = x;
          moved[dim - 1] += (1. + x[dim - 1]) * height(from_above);
          return moved;
        },
        mesh);
    }

    std::set<types::boundary_id>
    top() const
    {
      return {2 * dim - 1};
    }

    parallel::distributed::Triangulation<dim> mesh;
  };



  /// An indenter above a body.
  template <int dim>
  struct Test
  {
    Test(const std::string     &type,
         const CurvedBody<dim> &body,
         const double           part)
      : gap_function(placed(type),
                     range_of_heights(body.mesh, body.top()).second,
                     body_size(body.mesh))
      , tip(placed(type).shape, gap_function, body.mesh, body.top(), part)
    {}

    static PlacedIndenter<dim>
    placed(const std::string &type)
    {
      IndenterParameters parameters;
      parameters.type              = type;
      parameters.radius            = radius;
      parameters.semi_apex_angle   = semi_apex_angle;
      PlacedIndenter<dim> indenter = make_indenter<dim>(parameters);
      indenter.initial_gap         = gap_of_highest_point;
      return indenter;
    }

    GapFunction<dim>        gap_function;
    TipOnCurvedSurface<dim> tip;
  };



  /// In space, a paraboloid on z = c x y: an ellipse with the principal
  /// curvatures 1 / R -+ c.
  void
  check_saddle()
  {
    const double        c = 0.3, h = 0.05;
    const CurvedBody<3> body(Point<2>(0., -1.), 4, [&](const Point<2> &x) {
      return c * x[0] * x[1];
    });
    const Test<3>       test("paraboloid", body, 0.5);
    // (the highest point is a corner)
    verify("first contact on the saddle",
           relative_error(test.tip.initial_gap(), gap_of_highest_point + c),
           1e-12);
    verify("overlap with the saddle",
           relative_error(test.tip.overlapped_area(h),
                          2 * PI * h /
                            std::sqrt(1 / (radius * radius) - c * c)),
           1e-4);
  }



  /// A ball on a ball, with the sum of both curvatures (K. L. Johnson, Contact
  /// Mechanics, section 4.1). The faces, of a given @p size, cut off s^2 / 6 of
  /// the curvature of the body, in the mean.
  double
  overlap_of_balls(const double curvature_of_tip,
                   const double curvature_of_body,
                   const double size,
                   const double height)
  {
    return 2 * PI * (height - curvature_of_body * size * size / 6) /
           (curvature_of_tip + curvature_of_body);
  }



  /// Also in a hollow of a larger one.
  void
  check_balls(const std::string &title, const double radius_of_body)
  {
    const double        h = 0.05;
    const CurvedBody<3> body(Point<2>(), 5, [&](const Point<2> &x) {
      return -0.5 * x.norm_square() / radius_of_body;
    });
    const Test<3>       test("paraboloid", body, 0.25);
    verify(title + ": contact at once",
           relative_error(test.tip.initial_gap(),
                          gap_of_highest_point +
                            range_of_heights(body.mesh, body.top()).second),
           1e-12);
    verify(title + ": overlap",
           relative_error(
             test.tip.overlapped_area(h),
             overlap_of_balls(1 / radius, 1 / radius_of_body, 1. / 32, h)),
           2e-4);
  }



  /// Straight flanks, in a body of revolution: a cone on a blunter one and in a
  /// pit, where it touches the rim, or in the middle.
  void
  check_cones()
  {
    const double h = 0.05, flank = 1 / std::tan(semi_apex_angle * PI / 180);
    const auto   test_on = [&](const double rise, const auto &check) {
      const CurvedBody<2> body(Point<1>(), 3, [&](const Point<1> &x) {
        return rise * x[0];
      });
      check(Test<2>("cone", body, 1.).tip);
    };
    test_on(-0.2, [&](const TipOnSurface &tip) {
      verify("cone on a cone: first contact",
             relative_error(tip.initial_gap(), gap_of_highest_point),
             1e-12);
      verify("cone on a cone: overlap",
             relative_error(tip.overlapped_area(h),
                            PI * std::pow(h / (flank + 0.2), 2)),
             1e-12);
      verify("a cone remains one", tip.depth_factor() == 2. - 4. / PI);
    });
    test_on(0.2, [&](const TipOnSurface &tip) {
      verify("cone in a blunt pit: first contact at the bottom",
             relative_error(tip.initial_gap(), gap_of_highest_point + 0.2),
             1e-12);
      verify("cone in a blunt pit: overlap",
             relative_error(tip.overlapped_area(h),
                            PI * std::pow(h / (flank - 0.2), 2)),
             1e-12);
    });
    test_on(0.8, [&](const TipOnSurface &tip) {
      verify("cone in a sharp pit: first contact at the rim",
             relative_error(tip.initial_gap(), gap_of_highest_point + flank),
             1e-12);
      const double inner = 1. - h / (0.8 - flank);
      verify("cone in a sharp pit: overlap at the rim",
             relative_error(tip.overlapped_area(h), PI * (1. - inner * inner)),
             1e-12);
    });
  }



  /// A flat face on a ball is like a paraboloid on a plane; and a tip that has
  /// moved to the side overlaps another part.
  void
  check_face_and_motion()
  {
    const CurvedBody<3> body(Point<2>(-1., -1.), 5, [&](const Point<2> &x) {
      return -0.25 * x.norm_square();
    });
    const Test<3>       face("circular punch", body, 1.);
    verify("flat face: factor of a paraboloid",
           face.tip.depth_factor() == 0.75);
    verify("flat face: overlap",
           relative_error(face.tip.overlapped_area(0.1),
                          overlap_of_balls(0., 0.5, 1. / 16, 0.1)),
           5e-4);

    // (both curvatures are 1/2: they touch in the middle)
    Test<3>      moved("paraboloid", body, 1.);
    Tensor<1, 2> motion;
    motion[0] = 0.25;
    moved.gap_function.move_to(motion);
    verify("moved: first contact",
           relative_error(moved.tip.initial_gap(),
                          gap_of_highest_point + 2 * 0.25 * 0.125 * 0.125),
           1e-12);
    // (as for a ball on a ball, on faces twice as large)
    verify("moved: overlap",
           relative_error(moved.tip.overlapped_area(0.05),
                          overlap_of_balls(0.5, 0.5, 1. / 16, 0.05)),
           8e-4);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_saddle();
  check_balls("ball on a ball", 1.);
  check_balls("ball in a hollow", -4.);
  check_cones();
  check_face_and_motion();
}
