// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/exceptions.h"
#include "mesh/nested_shells.h"
#include "mesh/ready_meshes.h"

namespace ElastoPlastic
{
  namespace
  {
    enum class Side : types::boundary_id
    {
      top,
      bottom,
      round,
      front,
      back
    };

    types::boundary_id
    id(const Side side)
    {
      return static_cast<types::boundary_id>(side);
    }



    constexpr types::manifold_id cylindrical = 0;

    /// A single triangle at the axis for angles up to this one, in degrees.
    constexpr double largest_angle_of_triangle = 100;

    /// In a section through the axis, the corner of a shell of unit radius and
    /// depth: 1 of a square, sqrt(1/2) of a circle. In between, cells on both
    /// sides of the diagonal have better angles.
    constexpr double rounded_corner = 0.85;

    /// Cores that are smaller are a mistake.
    constexpr double largest_ratio = 1e6;



    /// @p n_steps geometric steps between two positive values, both included.
    std::vector<double>
    geometric_sequence(const double       first,
                       const double       last,
                       const unsigned int n_steps)
    {
      std::vector<double> values(n_steps + 1);
      for (unsigned int i = 0; i <= n_steps; ++i)
        values[i] =
          first * std::pow(last / first, static_cast<double>(i) / n_steps);
      values.back() = last;
      return values;
    }



    /// Each shell is about twice as large as the one inside.
    std::vector<NestedShells::Surface>
    surfaces_of_shells(const SectorParameters &p)
    {
      const unsigned int n_shells =
        std::lround(std::log2(p.radius / p.core_radius));
      const auto radii  = geometric_sequence(p.core_radius, p.radius, n_shells);
      const auto depths = geometric_sequence(p.core_radius, p.height, n_shells);
      std::vector<NestedShells::Surface> surfaces;
      for (unsigned int i = 0; i <= n_shells; ++i)
        surfaces.push_back(
          {radii[i], depths[i], i < n_shells ? rounded_corner : 1.});
      return surfaces;
    }



    using FaceOfSector = Triangulation<3>::face_iterator;



    bool
    all_vertices(const FaceOfSector                          &face,
                 const std::function<bool(const Point<3> &)> &condition)
    {
      for (const unsigned int v : face->vertex_indices())
        if (!condition(face->vertex(v)))
          return false;
      return true;
    }



    Side
    side_of(const FaceOfSector &face, const SectorParameters &p)
    {
      if (all_vertices(face, [](const auto &x) { return x[2] == 0; }))
        return Side::top;
      if (all_vertices(face, [&](const auto &x) { return x[2] == -p.height; }))
        return Side::bottom;
      if (all_vertices(face, [](const auto &x) { return x[1] == 0; }))
        return Side::front;
      const auto is_far = [&](const Point<3> &x) {
        return std::hypot(x[0], x[1]) > (1 - 1e-10) * p.radius;
      };
      return all_vertices(face, is_far) ? Side::round : Side::back;
    }



    /// Inside, where a face may have cells of different size on both sides, all
    /// edges are straight; and so are those in the planes of symmetry, which
    /// stay planes to the last digit.
    void
    follow_cylinder(Triangulation<3> &mesh)
    {
      mesh.set_all_manifold_ids(numbers::flat_manifold_id);
      mesh.set_manifold(cylindrical, CylindricalManifold<3>(2));
      for (const auto &face : mesh.active_face_iterators())
        if (face->boundary_id() == id(Side::round))
          face->set_all_manifold_ids(cylindrical);
      for (const auto &face : mesh.active_face_iterators())
        if (face->boundary_id() == id(Side::front) ||
            face->boundary_id() == id(Side::back))
          face->set_all_manifold_ids(numbers::flat_manifold_id);
    }



    [[noreturn]] void
    reject(const std::string &entry,
           const double       value,
           const std::string &remedy)
    {
      throw InputError("Geometry/" + entry, value, remedy);
    }
  } // namespace



  void
  SectorParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_action("Radius", [this](const std::string &value) {
      radius = Utilities::string_to_double(value);
    });
    prm.add_parameter(
      "Sector angle",
      angle,
      "Type sector: the angle between its plane sides, which meet on the axis "
      "x = y = 0: 'front' is the plane y = 0, 'back' the one at this angle "
      "from it, counter-clockwise seen from above. The smallest part that "
      "symmetry allows is 45 for a pyramid with four faces (Vickers), 60 for "
      "one with three (Berkovich), and anything for a cone or a sphere. At 180 "
      "both sides are one plane, 'front'. Unit: degrees; allowed: > 0, <= 180.",
      Patterns::Double());
    prm.add_parameter(
      "Height",
      height,
      "Type sector: how deep it reaches below the top, which lies at z = 0. "
      "Unit: length; allowed: at least twice the core radius.",
      Patterns::Double());
    prm.add_parameter(
      "Core radius",
      core_radius,
      "Type sector: radius and depth of the part under the tip where the cells "
      "of the coarse mesh are smallest, half as large as the core. Around and "
      "below it lie shells, each twice as large as the one inside it, or nearly "
      "so: a whole number of them reaches up to the radius. After n initial "
      "refinements, the elements at the edge of a contact measure between 1/2^n "
      "and 1/2^(n+1) of its radius, once it is larger than the core. A quarter "
      "of the largest radius of the contact is a good choice. Unit: length; "
      "allowed: at most half the radius, at least a millionth of it.",
      Patterns::Double());
  }



  void
  SectorParameters::check(const unsigned int dim) const
  {
    if (dim != 3)
      throw InputError(
        "Geometry/Type",
        "sector",
        "a sector of a round block needs 'Dimension = 3'. In two "
        "dimensions, a round block is a box with 'Kinematics = "
        "axisymmetric'.");
    if (!(radius > 0))
      reject("Radius", radius, "it must be greater than 0.");
    if (!(angle > 0 && angle <= 180))
      reject("Sector angle",
             angle,
             "it must be greater than 0 and at most 180 degrees.");
    if (!(core_radius >= radius / largest_ratio && core_radius <= radius / 2))
      reject("Core radius",
             core_radius,
             "it must be at most half of 'Radius', which is " +
               Patterns::Tools::to_string(radius) +
               ", and at least a millionth of it.");
    if (!(height >= 2 * core_radius))
      reject("Height",
             height,
             "it must be at least twice 'Core radius', which is " +
               Patterns::Tools::to_string(core_radius) + ".");
  }



  template <int dim>
  BoundaryNames
  make_sector(const SectorParameters &parameters,
              Triangulation<dim>     &triangulation)
  {
    if constexpr (dim == 3)
      {
        const unsigned int n_triangles =
          parameters.angle <= largest_angle_of_triangle ? 1 : 2;
        const NestedShells shells(
          DividedSector(parameters.angle * numbers::PI / 180, n_triangles),
          surfaces_of_shells(parameters));
        triangulation.create_triangulation(shells.vertices(),
                                           shells.cells(),
                                           SubCellData());
        for (const auto &face : triangulation.active_face_iterators())
          if (face->at_boundary())
            face->set_all_boundary_ids(id(side_of(face, parameters)));
        follow_cylinder(triangulation);
      }
    else
      AssertThrow(false, ExcInternalError()); // (check() refuses it)

    BoundaryNames names = {{"top", id(Side::top)},
                           {"bottom", id(Side::bottom)},
                           {"side", id(Side::round)},
                           {"front", id(Side::front)}};
    if (parameters.angle < 180)
      names["back"] = id(Side::back);
    return names;
  }



  template BoundaryNames
  make_sector(const SectorParameters &, Triangulation<2> &);
  template BoundaryNames
  make_sector(const SectorParameters &, Triangulation<3> &);
} // namespace ElastoPlastic
