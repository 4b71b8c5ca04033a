// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_stl_surface_h
#define indenter_indenter_stl_surface_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

#include "indenter/height_file.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// An indenter given by triangles. Its height above a point is that of the
  /// lowest of them, in two dimensions above the line y = 0; where there is
  /// none, it does not reach.
  template <int dim>
  class IndenterStlSurface : public Indenter<dim>
  {
  public:
    /// @param facets at least one, none of them vertical. They are shifted
    /// vertically so that the lowest corner is at height zero.
    explicit IndenterStlSurface(const std::vector<Facet> &facets);

    double
    profile(const Point<dim - 1> &x) const override
    {
      return surface(x).height;
    }

    /// Height and slope are those of the lowest triangle, the curvature is
    /// zero.
    IndenterSurface<dim>
    surface(const Point<dim - 1> &x) const override;

    /// In three dimensions, exactly and of all tips together: the horizontal
    /// projection of what is below. The triangles must be oriented alike.
    double
    section_area(const double height) const override;

  private:
    using Box = std::pair<BoundingBox<2>, unsigned int>;

    const std::vector<Facet> facets;
    /// Points that are no farther from a triangle count as its own.
    const double     tolerance;
    const RTree<Box> boxes; ///< of the triangles from above, with their indices
  };
} // namespace ElastoPlastic

#endif
