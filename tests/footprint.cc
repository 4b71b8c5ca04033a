// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What an indenter reaches, seen from above: sides and triangles on it, beside
// it, and those of which it reaches so little that few points would miss it.

#include <deal.II/base/mpi.h>

#include <limits>

#include "contact/footprint.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  const Footprint<1> punch_in_section = {std::nullopt,
                                         Rectangle<1>{Point<1>(0.3), {{0.01}}}};
  const Footprint<1> ball_in_section  = {Disc<1>{Point<1>(0.3), 0.01},
                                         std::nullopt};
  const Footprint<2> square           = {std::nullopt,
                                         Rectangle<2>{Point<2>(), {{1., 1.}}}};
  const Footprint<2> strip            = {std::nullopt,
                                         Rectangle<2>{Point<2>(), {{0.01, infinity}}}};
  const Footprint<2> round_corners    = {Disc<2>{Point<2>(), 1.2},
                                         Rectangle<2>{Point<2>(), {{1., 1.}}}};



  template <typename Shape, typename Part>
  void
  test(const std::string &title,
       const Shape       &footprint,
       const Part        &part,
       const bool         is_contained,
       const bool         is_overlapped)
  {
    verify(title,
           contains(footprint, part) == is_contained &&
             overlaps(footprint, part) == is_overlapped);
  }



  std::array<Point<2>, 2>
  side(const double begin, const double end)
  {
    return {{Point<2>(begin, 0.), Point<2>(end, 0.5)}};
  }



  std::array<Point<3>, 3>
  triangle(const Point<2> &a, const Point<2> &b, const Point<2> &c)
  {
    return {{Point<3>(a[0], a[1], 0.),
             Point<3>(b[0], b[1], 1.),
             Point<3>(c[0], c[1], 2.)}};
  }



  void
  test_sides()
  {
    for (const auto &footprint : {punch_in_section, ball_in_section})
      {
        test("a punch within a side", footprint, side(0., 1.), false, true);
        test("a side on it", footprint, side(0.29, 0.31), true, true);
        test("a side that ends on it", footprint, side(0.305, 1.), false, true);
        test("a side beside it", footprint, side(0.31, 1.), false, false);
      }
    test("upright on it", punch_in_section, side(0.3, 0.3), true, true);
    test(
      "upright at its edge", punch_in_section, side(0.31, 0.31), true, false);
  }



  void
  test_triangles()
  {
    test("on the square",
         square,
         triangle({-1., -1.}, {1., -1.}, {0., 1.}),
         true,
         true);
    test("a corner of the square inside",
         square,
         triangle({1.999, 0.}, {0., 1.999}, {3., 3.}),
         false,
         true);
    test("beside that corner",
         square,
         triangle({2.001, 0.}, {0., 2.001}, {3., 3.}),
         false,
         false);
    test("a common edge",
         square,
         triangle({1., -1.}, {1., 1.}, {2., 0.}),
         false,
         false);
    test("the square inside",
         square,
         triangle({-9., -9.}, {9., -9.}, {0., 9.}),
         false,
         true);
    test("a strip across",
         strip,
         triangle({-1., 0.}, {1., 0.3}, {0.5, 7.}),
         false,
         true);
    test("beside the strip",
         strip,
         triangle({0.01, 0.}, {1., 0.3}, {0.5, 7.}),
         false,
         false);
    test("on the square, not on the disc",
         round_corners,
         triangle({1., 1.}, {0.9, 1.}, {1., 0.9}),
         false,
         false);
    test("on both",
         round_corners,
         triangle({1., 0.}, {0., 1.}, {0., 0.}),
         true,
         true);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_sides();
  test_triangles();
}
