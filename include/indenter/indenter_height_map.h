// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_height_map_h
#define indenter_indenter_height_map_h

#include <deal.II/base/function_lib.h>
#include <deal.II/base/table.h>

#include <algorithm>
#include <vector>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// An indenter given by heights on a regular grid, (bi)linear in between, but
  /// smooth for nodes that slide along it (all but those of vertical gaps).
  /// Outside the grid it does not reach.
  template <int dim>
  class IndenterHeightMap : public Indenter<dim>
  {
  public:
    /// @param heights by row and column as in a picture: the first row has the
    /// largest y, the first column the smallest x. At least two along each
    /// horizontal direction; in two dimensions a single row.
    /// @param scale multiplies the heights; a negative one turns them upside
    /// down. They are then shifted so that the lowest is zero.
    /// @param size are the distances between the centres of the first and the
    /// last pixel, one per horizontal direction; the middle of the grid is the
    /// indenter's position.
    IndenterHeightMap(const Table<2, double>    &heights,
                      const double               scale,
                      const std::vector<double> &size);

    double
    profile(const Point<dim - 1> &x) const override;

    /// On an edge of pixels, that of one of them.
    IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const override;

    /// smooth_surface() through the same heights: a node that slides would be
    /// caught in a kink, where no side has the direction of its force.
    IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const override;

    /// The larger distance of pixels.
    double
    detail() const override
    {
      return std::max(spacing[0], spacing[dim - 2]);
    }

    /// 0: a surface has no single tip.
    double
    section_area(const double) const override
    {
      return 0.;
    }

  private:
    const std::vector<double> size;
    const Tensor<1, dim - 1>  spacing; ///< of pixels
    const Functions::InterpolatedUniformGridData<dim - 1> interpolation;
  };



  /// A surface without kinks through @p heights on a regular grid with the
  /// distances @p spacing, at the point @p x seen from the first of them. Along
  /// the lines of the grid it is the monotone cubic interpolation of
  /// @cite fritsch_butland_1984: it turns in grid points only, and is straight
  /// where they are in line. Between four lines it is their Coons patch.
  template <int dim>
  IndenterSurface<dim>
  smooth_surface(const Table<dim - 1, double> &heights,
                 const Tensor<1, dim - 1>     &spacing,
                 const Point<dim - 1>         &x);
} // namespace ElastoPlastic

#endif
