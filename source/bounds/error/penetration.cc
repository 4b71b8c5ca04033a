// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>
#include <utility>

#include "base/largest_error.h"
#include "bounds/error/error_bound.h"
#include "bounds/error/face_gap.h"

// By how much a displacement is lowered so that it does not penetrate.

namespace ElastoPlastic
{
  namespace
  {
    /// By how much the middle of a side must go down until no point of it
    /// penetrates; the ends do not. The displacement is linear but for 4 t (1 -
    /// t) times a factor c, the largest of which is looked for. In an interval,
    /// what is left above the linear part is linear. If at both ends that is r
    /// times 4 t (1 - t), it is not less than r times the chord of this
    /// function, which is above (1 - 2 / n_intervals) times the function
    /// itself, and below the function.
    double
    necessary_lowering(const FaceGap<2>    &gap,
                       const FaceValues<2> &v,
                       const double         depth)
    {
      const double a = v.at_corners[0][1], b = v.at_corners[1][1];
      double       ratio = std::numeric_limits<double>::max();
      for (const auto &interval : gap.small_simplices)
        for (unsigned int i = 0; i < 2; ++i)
          if (const auto &[s, t] = interval.corners[i]; t > 0. && t < 1.)
            ratio = std::min(ratio,
                             (interval.lower[i] - depth - (s * a + t * b)) /
                               (4. * t * s));
      const double largest =
        ratio * (ratio > 0. ? 1. - 2. / FaceGap<2>::n_intervals : 1.);
      return std::max(0., v.at_edges[0][1] - 0.5 * (a + b) - largest);
    }



    /// By how much the middles of the edges of a face must go down until no
    /// point of it penetrates; the corners do not. In terms of the barycentric
    /// coordinates l_i of the face, the displacement is linear plus the sum of
    /// 4 l_i l_j b over its edges. On a small triangle this sum, less the
    /// distance that is left, less t times that with b = 1, is a quadratic
    /// function; it is not positive if its coefficients in Bernstein's basis,
    /// the values at the corners and 2 f(middle) less the mean of f at its ends
    /// for each edge, are not.
    double
    necessary_lowering(const FaceGap<3>    &gap,
                       const FaceValues<3> &v,
                       const double         depth)
    {
      std::array<double, 3> vertical, bubbles;
      for (unsigned int i = 0; i < 3; ++i)
        {
          vertical[i] = v.at_corners[i][2];
          bubbles[i]  = v.at_edges[i][2] - 0.5 * (v.at_corners[i][2] +
                                                 v.at_corners[(i + 1) % 3][2]);
        }
      const auto bubble = [](const std::array<double, 3> &l,
                             const std::array<double, 3> &b) {
        return 4. *
               (l[0] * l[1] * b[0] + l[1] * l[2] * b[1] + l[2] * l[0] * b[2]);
      };
      double result = 0;
      for (const auto &triangle : gap.small_simplices)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            {
              const auto &a = triangle.corners[i], &b = triangle.corners[j];
              const auto  bernstein = [&](const std::array<double, 3> &size) {
                std::array<double, 3> middle;
                for (unsigned int k = 0; k < 3; ++k)
                  middle[k] = 0.5 * (a[k] + b[k]);
                return 2. * bubble(middle, size) -
                       0.5 * (bubble(a, size) + bubble(b, size));
              };
              const double left =
                0.5 * (triangle.lower[i] + triangle.lower[j]) - depth -
                0.5 * (interpolate(a, vertical) + interpolate(b, vertical));
              const double unit = bernstein({{1., 1., 1.}});
              if (unit > 0.) // else it is a corner of the face
                keep_largest(result, (bernstein(bubbles) - left) / unit);
            }
      return result;
    }
  } // namespace



  // First the corners of the faces, if the indenter reaches them, then the
  // middles of their edges, whose quadratic functions are zero at the corners.
  template <int dim>
  void
  remove_penetration(QuadraticField<dim>  &displacement,
                     const SplitBody<dim> &body,
                     const double          depth)
  {
    std::vector<std::pair<unsigned int, FaceGap<dim>>> gaps;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_reached)
        gaps.emplace_back(f, FaceGap<dim>(body.gap, body.corners_of_face(f)));

    for (const auto &[f, gap] : gaps)
      for (unsigned int i = 0; i < dim; ++i)
        {
          double &v =
            displacement.at_vertices[body.mesh.faces[f].vertices[i]][dim - 1];
          v = std::min(v, gap.lower_at_corners[i] - depth);
        }

    std::vector<double> lowering(body.mesh.n_edges);
    for (const auto &[f, gap] : gaps)
      {
        const auto   v         = displacement.values_on_face(body.mesh, f);
        const double necessary = necessary_lowering(gap, v, depth);
        for (const unsigned int edge : v.edges)
          keep_largest(lowering[edge], necessary);
      }
    for (unsigned int edge = 0; edge < lowering.size(); ++edge)
      displacement.at_edges[edge][dim - 1] -= lowering[edge];
  }



  template void
  remove_penetration(QuadraticField<2> &, const SplitBody<2> &, const double);
  template void
  remove_penetration(QuadraticField<3> &, const SplitBody<3> &, const double);
} // namespace ElastoPlastic
