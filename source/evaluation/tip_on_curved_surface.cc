// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "evaluation/tip_on_curved_surface.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How often faces are divided, wherever the edge of an area may be: what
    /// is smaller than a face is not overlooked.
    constexpr unsigned int n_first_divisions = 2;

    /// And how often where the edge is: to the last digits in a body of
    /// revolution, to about a hundred-thousandth of the area in space.
    constexpr unsigned int
    n_divisions_at_edge(const int dim)
    {
      return dim == 2 ? 50 : 8;
    }
  } // namespace



  template <int dim>
  double
  TipOnCurvedSurface<dim>::initial_gap() const
  {
    const MPI_Comm communicator = communicator_of(triangulation);
    double         smallest     = std::numeric_limits<double>::infinity();
    rethrow_collectively(communicator, [&]() {
      for_each_face([&](const Patch &face) {
        for (const Point<dim> &vertex : face)
          smallest = std::min(smallest, gap_function.value(vertex));
      });
    });
    return Utilities::MPI::min(smallest, communicator);
  }



  template <int dim>
  double
  TipOnCurvedSurface<dim>::depth_factor() const
  {
    constexpr double of_paraboloid = 0.75;
    return std::min(of_paraboloid, tip->depth_factor());
  }



  template <int dim>
  double
  TipOnCurvedSurface<dim>::overlapped_area(const double height) const
  {
    const MPI_Comm communicator = communicator_of(triangulation);
    const double   depth        = initial_gap() + height;
    double         sum          = 0;
    rethrow_collectively(communicator, [&]() {
      for_each_face([&](const Patch &face) {
        sum += overlapped_area(face, depth, n_divisions_at_edge(dim));
      });
    });
    return Utilities::MPI::sum(sum, communicator) / part;
  }



  template <>
  std::array<TipOnCurvedSurface<2>::Patch, 2>
  TipOnCurvedSurface<2>::quarters(const Patch &patch)
  {
    const Point<2> between = middle(patch);
    return {{{{patch[0], between}}, {{between, patch[1]}}}};
  }



  template <>
  std::array<TipOnCurvedSurface<3>::Patch, 4>
  TipOnCurvedSurface<3>::quarters(const Patch &patch)
  {
    const auto between = [&](const unsigned int a, const unsigned int b) {
      return patch[a] + 0.5 * (patch[b] - patch[a]);
    };
    const Point<3> bottom = between(0, 1), left = between(0, 2),
                   right = between(1, 3), top = between(2, 3),
                   centre = middle(patch);
    return {{{{patch[0], bottom, left, centre}},
             {{bottom, patch[1], centre, right}},
             {{left, centre, patch[2], top}},
             {{centre, right, top, patch[3]}}}};
  }



  template <>
  double
  TipOnCurvedSurface<2>::area(const Patch &patch)
  {
    return numbers::PI *
           std::abs(patch[1][0] * patch[1][0] - patch[0][0] * patch[0][0]);
  }



  // By the diagonals.
  template <>
  double
  TipOnCurvedSurface<3>::area(const Patch &patch)
  {
    const Tensor<1, 3> up = patch[3] - patch[0], down = patch[2] - patch[1];
    return 0.5 * std::abs(up[0] * down[1] - up[1] * down[0]);
  }



  template <int dim>
  Point<dim>
  TipOnCurvedSurface<dim>::middle(const Patch &patch)
  {
    Tensor<1, dim> sum;
    for (const Point<dim> &corner : patch)
      sum += corner;
    return Point<dim>(sum / (1 << (dim - 1)));
  }



  template <int dim>
  double
  TipOnCurvedSurface<dim>::overlapped_area(const Patch       &patch,
                                           const double       depth,
                                           const unsigned int n_divisions) const
  {
    const auto is_overlapped = [&](const Point<dim> &point) {
      return gap_function.value(point) <= depth;
    };
    if (n_divisions == 0)
      return is_overlapped(middle(patch)) ? area(patch) : 0.;
    if (n_divisions_at_edge(dim) - n_divisions >= n_first_divisions)
      {
        const auto n_corners =
          std::count_if(patch.begin(), patch.end(), is_overlapped);
        if (n_corners == 0)
          return 0.;
        if (n_corners == static_cast<int>(patch.size()))
          return area(patch);
      }
    double sum = 0;
    for (const Patch &quarter : quarters(patch))
      sum += overlapped_area(quarter, depth, n_divisions - 1);
    return sum;
  }



  template <int dim>
  template <typename Function>
  void
  TipOnCurvedSurface<dim>::for_each_face(const Function &receive) const
  {
    for (const auto &[cell, f] : owned_faces(triangulation, boundaries))
      {
        Patch patch;
        for (const unsigned int v : cell->face(f)->vertex_indices())
          patch[v] = cell->face(f)->vertex(v);
        receive(patch);
      }
  }



  template class TipOnCurvedSurface<2>;
  template class TipOnCurvedSurface<3>;
} // namespace ElastoPlastic
