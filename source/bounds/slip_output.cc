// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/mechanism/side_view.h"
#include "bounds/slip_output.h"
#include "output/patches.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Parts of a side, on which the velocity may be a polynomial of degree 4.
    constexpr unsigned int n_side_parts = 4;

    /// Less slip counts as none, relative to the largest velocity.
    constexpr double smallest_slip = 1e-3;



    /// Sets the slip at a point of a @p patch.
    template <typename Patch, int dim>
    void
    set_slip(Patch &patch, const unsigned int point, const Tensor<1, dim> &slip)
    {
      for (unsigned int d = 0; d < dim; ++d)
        patch.data(d, point) = slip[d];
    }



    template <int dim, int spacedim>
    Patches<dim, spacedim>
    make_patches()
    {
      return Patches<dim, spacedim>({{"slip", 3}});
    }
  } // namespace



  SlipOutput::SlipOutput(const OutputParameters &parameters)
    : series(parameters, "slip_lines")
  {}



  // On the axis, nothing slides.
  void
  SlipOutput::write(const PlaneBody                     &body,
                    const std::vector<TriangleVelocity> &velocity,
                    const unsigned int                   cycle)
  {
    const double threshold = smallest_slip * largest_velocity(body, velocity);
    auto         lines     = make_patches<1, 2>();
    for (const SideView &view : views_of_sides(body))
      {
        if (!(view.is_inside() || view.support.resists_slip))
          continue;
        const auto              &ends = body.mesh.sides[view.side].vertices;
        DataOutBase::Patch<1, 2> patch;
        patch.reference_cell = ReferenceCells::Line;
        patch.n_subdivisions = n_side_parts;
        for (unsigned int end = 0; end < 2; ++end)
          patch.vertices[end] = body.mesh.vertices[ends[end]];
        patch.data.reinit(3, n_side_parts + 1);
        double largest = 0;
        for (unsigned int i = 0; i <= n_side_parts; ++i)
          {
            const double   t = i / static_cast<double>(n_side_parts);
            const Point<2> x(patch.vertices[0] +
                             t * (patch.vertices[1] - patch.vertices[0]));
            if (body.is_on_axis(x))
              continue;
            const double slip =
              view.jump(velocity, t) * view.tangent / body.weight(x);
            set_slip(patch, i, slip * view.tangent);
            largest = std::max(largest, std::abs(slip));
          }
        if (largest > threshold)
          lines.add(patch);
      }
    series.write(lines, cycle);
  }



  void
  SlipOutput::write(const SpaceBody                     &body,
                    const std::vector<CornerVelocities> &velocity,
                    const unsigned int                   cycle)
  {
    const double threshold = smallest_slip * largest_velocity(body, velocity);
    auto         faces     = make_patches<2, 3>();
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      {
        if (!slip_takes_work(body, f))
          continue;
        const auto         corners = body.mesh.corners(body.mesh.faces[f]);
        const Tensor<1, 3> n       = normal(corners);
        const auto         jumps   = velocity_jumps(body, velocity, f);
        DataOutBase::Patch<2, 3> patch;
        patch.reference_cell = ReferenceCells::Triangle;
        patch.n_subdivisions = 1;
        patch.data.reinit(3, 3);
        double largest = 0;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Tensor<1, 3> slip = jumps[i] - (jumps[i] * n) * n;
            patch.vertices[i]       = corners[i];
            set_slip(patch, i, slip);
            largest = std::max(largest, slip.norm());
          }
        if (largest > threshold)
          faces.add(patch);
      }
    series.write(faces, cycle);
  }
} // namespace ElastoPlastic
