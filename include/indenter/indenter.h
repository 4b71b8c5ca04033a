// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_h
#define indenter_indenter_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <memory>
#include <optional>

namespace ElastoPlastic
{
  using namespace dealii;

  /// What the evaluation of an indentation test needs to know of the indenter,
  /// in three dimensions or as an axisymmetric body.
  class TipShape
  {
  public:
    virtual ~TipShape() = default;

    /// epsilon of @cite oliver_pharr_1992, equation (4): 1 for a flat face,
    /// 2 - 4/pi (there rounded to 0.72) for a cone, 0.75 for all others, as is
    /// exact for a paraboloid.
    virtual double
    depth_factor() const = 0;

    /// The area of the horizontal section at a @p height > 0 above the tip, of
    /// the whole indenter; 0 if it is not bounded, or if there is no single
    /// tip.
    virtual double
    section_area(const double height) const = 0;
  };



  /// The surface of an indenter above a point, to second order in the
  /// horizontal coordinates.
  template <int dim>
  struct IndenterSurface
  {
    double                      height;
    Tensor<1, dim - 1>          slope;     ///< first derivatives
    SymmetricTensor<2, dim - 1> curvature; ///< second derivatives
  };



  /// The shape of a rigid indenter, seen from its lowest point: the function
  /// phi of Johnson's paper @cite johnson_1978. It knows points only: where the
  /// indenter stands and how far it is pushed is up to GapFunction and to the
  /// loading.
  template <int dim>
  class Indenter : public TipShape
  {
  public:
    /// Height of the indenter's surface above its tip (or face) at the
    /// horizontal offset @p x from its position; +infinity where the indenter
    /// does not reach.
    virtual double
    profile(const Point<dim - 1> &x) const = 0;

    /// The profile and its derivatives at @p x. On an edge or at the tip, the
    /// shapes give those of one side, or a mean of the sides; slope and
    /// curvature are zero where the height is infinite. By
    /// difference_quotients() over 1e-4 units of length, unless a shape knows
    /// better.
    virtual IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const
    {
      return difference_quotients(x, 1e-4);
    }

    /// The surface at @p x for a node that is below @p origin in the undeformed
    /// body: surface(@p x), unless a sharp tip or edge is above @p origin. Such
    /// a node stays below it, as symmetry demands: to the sides, the height is
    /// that of the tip or edge itself. Otherwise rounding errors would decide
    /// to which side the node slides; those of its coordinates are up to
    /// rounding_of_coordinates times @p body_size.
    virtual IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const;

    /// Whether the profile is certainly a convex function where it is finite:
    /// false, unless a shape knows better.
    virtual bool
    is_convex() const
    {
      return false;
    }

    /// The radius of the disc around the tip in which the profile is finite,
    /// and outside of which it is not; +infinity if it is finite everywhere.
    /// None if that is no disc, or not known, which it is not unless a shape
    /// knows better.
    virtual std::optional<double>
    disc_radius() const
    {
      return {};
    }

    /// The half widths of the rectangle around the tip, parallel to the axes,
    /// in which the profile is finite, and outside of which it is not; they may
    /// be infinite. None if that is no rectangle, or not known, which it is not
    /// unless a shape knows better.
    virtual std::optional<std::array<double, dim - 1>>
    half_widths() const
    {
      return {};
    }

    /// The length below which the profile is smooth, which a mesh should
    /// resolve: the distance of the pixels of a height map. 0, unless a shape
    /// knows better.
    virtual double
    detail() const
    {
      return 0.;
    }

    /// 0.75, unless a shape knows better.
    double
    depth_factor() const override
    {
      return 0.75;
    }

    /// The area is found by quadrature over all directions (in two dimensions,
    /// of the body of revolution), unless a shape knows better: sections are
    /// taken to be star-shaped about the tip, and the profile to grow along
    /// each direction.
    double
    section_area(const double height) const override;

  protected:
    /// The part of the size of a body that rounding errors of its coordinates
    /// are up to.
    static constexpr double rounding_of_coordinates = 1e-12;

    /// The surface at @p x by quotients over @p step, one-sided where the
    /// profile ends.
    IndenterSurface<dim>
    difference_quotients(const Point<dim - 1> &x, const double step) const;
  };



  /// An indenter and where it stands.
  template <int dim>
  struct PlacedIndenter
  {
    /// Null if there is no indenter.
    std::shared_ptr<const Indenter<dim>> shape;
    /// Horizontal coordinates of the tip.
    Point<dim - 1> position;
    /// From the highest point of the contact surface up to the tip,
    /// undisplaced.
    double initial_gap = 0;
    /// The horizontal distance from the tip up to which contact is looked for.
    double reach = 0;

    /// By what factor the contact grows in each direction from one @p depth to
    /// the @p next if it keeps its shape: by that of the indenter where the
    /// undeformed surface cuts it. 3 at most; 1 if the contact does not grow,
    /// is no bounded one, or that of an indenter that is not convex.
    double
    growth_of_contact(const double depth, const double next) const;
  };



  /// Whether a distance from the middle is at most the half width, the edge
  /// included. The tolerance keeps mesh nodes that lie on an edge there, though
  /// their coordinates are rounded.
  inline bool
  within(const double distance, const double half_width)
  {
    return distance <= (1 + 1e-10) * half_width;
  }
} // namespace ElastoPlastic

#endif
