// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_symmetric_h
#define indenter_indenter_symmetric_h

#include "indenter/indenter.h"
#include "indenter/sections.h"

namespace ElastoPlastic
{
  /// How a section becomes a body in three dimensions. In two dimensions the
  /// two are the same.
  enum class Symmetry
  {
    revolution, ///< about the vertical axis: sphere, cone, circular punch
    translation ///< along y: cylinder, wedge, strip punch
  };

  /// An indenter whose height depends on one distance only.
  template <int dim>
  class IndenterSymmetric : public Indenter<dim>
  {
  public:
    IndenterSymmetric(const Symmetry symmetry, const Section &section);

    double
    profile(const Point<dim - 1> &x) const override;

    /// On the axis of revolution, the slope is zero and the curvature
    /// isotropic, that of a cone zero.
    IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const override;

    IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const override;

    bool
    is_convex() const override;

    std::optional<double>
    disc_radius() const override;

    std::optional<std::array<double, dim - 1>>
    half_widths() const override;

    double
    depth_factor() const override;

    /// In two dimensions of the body of revolution, 0 for a cylinder in three.
    double
    section_area(const double height) const override;

  private:
    /// The component of @p x on which the height depends.
    Tensor<1, dim - 1>
    across(const Point<dim - 1> &x) const;

    /// Whether it ends at two parallel edges.
    bool
    is_strip() const;

    const Symmetry symmetry;
    const Section  section;
  };
} // namespace ElastoPlastic

#endif
