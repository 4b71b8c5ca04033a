// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_shapes_h
#define indenter_indenter_shapes_h

#include <memory>
#include <string>
#include <vector>

#include "base/expression.h"
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
    IndenterSymmetric(const Symmetry symmetry, const Section &section)
      : symmetry(symmetry)
      , section(section)
    {}


    double
    profile(const Point<dim - 1> &x) const override
    {
      return section.at(across(x).norm()).height;
    }

    /// On the axis of revolution, the slope is zero and the curvature
    /// isotropic, that of a cone zero.
    IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const override;

    IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const override;

    bool
    is_convex() const override
    {
      return section.is_convex;
    }

    std::optional<double>
    disc_radius() const override
    {
      return is_strip() ? std::nullopt : std::make_optional(section.edge);
    }

    std::optional<std::array<double, dim - 1>>
    half_widths() const override;

    double
    depth_factor() const override
    {
      return section.depth_factor;
    }

    /// In two dimensions of the body of revolution, 0 for a cylinder in three.
    double
    section_area(const double height) const override;

  private:
    /// The component of @p x on which the height depends.
    Tensor<1, dim - 1>
    across(const Point<dim - 1> &x) const;

    /// Whether it ends at two parallel edges.
    bool
    is_strip() const
    {
      return dim == 3 && symmetry == Symmetry::translation &&
             !std::isinf(section.edge);
    }

    const Symmetry symmetry;
    const Section  section;
  };



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
    surface(const Point<dim - 1> &x) const override
    {
      return {profile(x), {}, {}};
    }

    bool
    is_convex() const override
    {
      return true;
    }

    std::optional<std::array<double, dim - 1>>
    half_widths() const override
    {
      return widths;
    }

    double
    depth_factor() const override
    {
      return 1.;
    }

  private:
    std::array<double, dim - 1> widths; ///< half of them
  };



  /// An indenter whose profile a user has typed in the horizontal coordinates
  /// x and y. In two dimensions it is the section y = 0.
  template <int dim>
  class IndenterExpression : public Indenter<dim>
  {
  public:
    /// @param path is the entry the text comes from. A text that does not parse
    /// is an InputError.
    /// @param reach is where the indenter ends, a distance from the tip; it may
    /// be infinite.
    IndenterExpression(const std::string &path,
                       const std::string &text,
                       const double       reach)
      : expression(path, text, ExpressionVariables::position)
      , reach(reach)
    {}


    /// Throws InputError where the value is not finite within the reach.
    double
    profile(const Point<dim - 1> &x) const override;

    /// The derivatives are difference quotients over 1e-4 of the reach, or 1e-5
    /// of the size of the body if that is smaller.
    IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const override;

  private:
    const Expression<2> expression;
    const double        reach;
  };



  /// A regular pyramid: those of Vickers, Berkovich and the corner of a cube.
  /// Its tip is sharp, rounded, or cut off.
  ///
  /// The rounded pyramid is what a ball reaches from inside the sharp one: its
  /// tip is a part of the ball, its edges are parts of cylinders of the same
  /// radius, and both are tangent to the faces, which are plane as before.
  struct PyramidShape
  {
    unsigned int n_faces    = 4;  ///< at least 3
    double       face_angle = 68; ///< between axis and face, in degrees
    /// From the x axis to the horizontal normal of the first face, about the
    /// vertical axis, in degrees.
    double rotation        = 0;
    double rounding_radius = 0; ///< 0: not rounded
    /// The height of what is cut off the sharp tip; 0 if it is rounded.
    double truncation = 0;
  };

  std::unique_ptr<Indenter<3>>
  make_pyramid(const PyramidShape &shape);

  /// Between axis and flank of the cone that displaces the same volume as the
  /// sharp pyramid, in degrees.
  double
  semi_apex_angle_of_cone(const PyramidShape &shape);
} // namespace ElastoPlastic

#endif
