// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_nested_shells_h
#define mesh_nested_shells_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <array>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A sector of the unit disc around the origin that begins at the x axis,
  /// divided into quadrilaterals.
  struct DividedSector
  {
    /// Into @p n_triangles with a corner at the origin, and each of these into
    /// three around a point from which edges go out at 120 degrees. @p angle is
    /// in radians.
    DividedSector(const double angle, const unsigned int n_triangles);

    std::vector<Point<2>>                    vertices;
    std::vector<std::array<unsigned int, 4>> cells; ///< numbered as in deal.II
    std::vector<unsigned int> arc; ///< the vertices of the circle in order
  };



  /// Hexahedra below a sector of a disc at z = 0: a core at the axis, and
  /// shells around it, from one surface to the next. A surface has a round
  /// wall, on the circle through the arc of the sector, and a floor with the
  /// vertices of the sector. Between two surfaces there is one layer of cells.
  class NestedShells
  {
  public:
    /// Radius of a surface at the top, and its depth on the axis. In a section
    /// through the axis, the edge between wall and floor is at @p corner times
    /// both: 1 stands for a cylinder, less for an edge that is less sharp.
    struct Surface
    {
      double radius;
      double depth;
      double corner;
    };

    /// From the innermost surface outwards.
    NestedShells(const DividedSector        &sector,
                 const std::vector<Surface> &surfaces);

    const std::vector<Point<3>> &
    vertices() const
    {
      return all_vertices;
    }

    const std::vector<CellData<3>> &
    cells() const
    {
      return all_cells;
    }

  private:
    using Numbers = std::vector<unsigned int>; ///< of vertices

    struct SurfaceVertices
    {
      Numbers floor; ///< one for each of the sector
      Numbers rim;   ///< at the top, one for each of the arc
    };

    unsigned int
    add_vertex(const double x, const double y, const double z);

    Numbers
    add_floor(const Surface &surface);

    SurfaceVertices
    add_core(const Surface &surface);

    SurfaceVertices
    add_shell(const SurfaceVertices &inside, const Surface &surface);

    Numbers
    on_arc(const Numbers &of_sector) const;

    /// Those between two floors, or between the innermost one and the top.
    void
    add_cells_between(const Numbers &lower, const Numbers &upper);

    void
    add_ring(const SurfaceVertices &inside, const SurfaceVertices &outside);

    const DividedSector      sector;
    std::vector<Point<3>>    all_vertices;
    std::vector<CellData<3>> all_cells;
  };
} // namespace ElastoPlastic

#endif
