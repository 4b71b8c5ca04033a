// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_rectangular_punch_h
#define indenter_indenter_rectangular_punch_h

#include <vector>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// A flat punch with a rectangular face (in two dimensions, with an edge).
  template <int dim>
  class IndenterRectangularPunch : public Indenter<dim>
  {
  public:
    /// @param half_widths of the face, one per horizontal direction.
    explicit IndenterRectangularPunch(const std::vector<double> &half_widths);

    double
    profile(const Point<dim - 1> &x) const override;

    IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const override;

    bool
    is_convex() const override;

    std::optional<std::array<double, dim - 1>>
    half_widths() const override;

    double
    depth_factor() const override;

  private:
    std::array<double, dim - 1> widths; ///< half of them
  };
} // namespace ElastoPlastic

#endif
