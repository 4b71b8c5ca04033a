// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The smooth surface through heights on a grid: it has these heights, no kinks,
// slopes and curvatures that are derivatives, nothing above and below the
// heights along the lines of the grid, and a plane for a plane.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "indenter/indenter_height_map.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int n_x = 5, n_y = 4;
  const Tensor<1, 2>     spacing(Point<2>(0.5, 0.25));

  template <typename Function>
  Table<2, double>
  table(const Function &height)
  {
    Table<2, double> result(n_x, n_y);
    for (unsigned int i = 0; i < n_x; ++i)
      for (unsigned int j = 0; j < n_y; ++j)
        result(i, j) = height(i, j);
    return result;
  }



  double
  rough(const unsigned int i, const unsigned int j)
  {
    return std::sin(12.9 * i + 78.2 * j);
  }



  Point<2>
  grid_point(const double i, const double j)
  {
    return {i * spacing[0], j * spacing[1]};
  }



  void
  check_heights(const Table<2, double> &heights)
  {
    double error = 0;
    for (unsigned int i = 0; i < n_x; ++i)
      for (unsigned int j = 0; j < n_y; ++j)
        error = std::max(
          error,
          std::abs(
            smooth_surface<3>(heights, spacing, grid_point(i, j)).height -
            heights(i, j)));
    verify("heights at the points of the grid", error, 1e-14);
  }



  /// Just before and behind lines of the grid, away from its points.
  void
  check_lines(const Table<2, double> &heights)
  {
    constexpr double tiny = 1e-9;
    double           jump = 0, outside = 0;
    for (unsigned int d = 0; d < 2; ++d)
      for (double along = 0.1; along < n_y - 1; along += 0.3)
        {
          Point<2>     x = d == 0 ? grid_point(2, along) : grid_point(along, 2);
          const double height = smooth_surface<3>(heights, spacing, x).height;
          const auto   i      = static_cast<unsigned int>(along);
          const double a      = d == 0 ? heights(2, i) : heights(i, 2);
          const double b      = d == 0 ? heights(2, i + 1) : heights(i + 1, 2);
          outside             = std::max(
            {outside, height - std::max(a, b), std::min(a, b) - height});
          x[d] -= tiny;
          const auto before = smooth_surface<3>(heights, spacing, x);
          x[d] += 2 * tiny;
          const auto behind = smooth_surface<3>(heights, spacing, x);
          jump = std::max(jump, (behind.slope - before.slope).norm());
        }
    verify("no kinks in the lines of the grid", jump, 1e-6);
    verify("there between the heights at their ends", outside, 1e-14);
  }



  void
  check_derivatives(const Table<2, double> &heights)
  {
    constexpr double step           = 1e-5;
    double           error_of_slope = 0, error_of_curvature = 0;
    for (double i = 0.3; i < n_x - 1; i += 0.5)
      for (double j = 0.4; j < n_y - 1; j += 0.5)
        {
          const Point<2> x     = grid_point(i, j);
          const auto     exact = smooth_surface<3>(heights, spacing, x);
          for (unsigned int d = 0; d < 2; ++d)
            {
              Tensor<1, 2> direction;
              direction[d] = step;
              const auto after =
                smooth_surface<3>(heights, spacing, x + direction);
              const auto before =
                smooth_surface<3>(heights, spacing, x - direction);
              error_of_slope =
                std::max(error_of_slope,
                         std::abs((after.height - before.height) / (2 * step) -
                                  exact.slope[d]));
              const Tensor<1, 2> curvature =
                (after.slope - before.slope) / (2 * step);
              for (unsigned int e = 0; e < 2; ++e)
                error_of_curvature =
                  std::max(error_of_curvature,
                           std::abs(curvature[e] - exact.curvature[d][e]));
            }
        }
    verify("slopes are those of the height", error_of_slope, 1e-6);
    verify("curvatures those of the slopes", error_of_curvature, 1e-6);
  }



  void
  check_plane()
  {
    const auto heights = table(
      [](const unsigned int i, const unsigned int j) { return 2. * i - j; });
    const auto surface =
      smooth_surface<3>(heights, spacing, grid_point(2.3, 1.6));
    verify("a plane: height", std::abs(surface.height - 3.), 1e-13);
    verify("  slope",
           (surface.slope - Tensor<1, 2>(Point<2>(4., -4.))).norm(),
           1e-12);
    verify("  curvature", surface.curvature.norm(), 1e-10);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Table<2, double> heights = table(rough);
  check_heights(heights);
  check_lines(heights);
  check_derivatives(heights);
  check_plane();
}
