// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

#include "base/exceptions.h"
#include "mesh/ready_meshes.h"

namespace ElastoPlastic
{
  namespace
  {
    enum BoundaryIds : types::boundary_id
    {
      top,
      curved,
      left,
      front
    };

    constexpr types::manifold_id spherical = 0;



    /// How many of the pieces of wedge(), numbered clockwise (2D: from x > 0),
    /// make up the part.
    template <int dim>
    unsigned int
    n_wedges(const HalfBallPart part)
    {
      const unsigned int n_in_full = (dim == 2 ? 2 : 4);
      return part == HalfBallPart::full ? n_in_full :
             part == HalfBallPart::half ? n_in_full / 2 :
                                          n_in_full / 4;
    }



    /// The quarter disc or eighth of a ball with the given number. The first
    /// one lies in x > 0 (, y > 0), the next ones follow clockwise around the
    /// lowest axis. All of them come from deal.II's by rotations, which keep
    /// the orientation of the cells.
    void
    wedge(const unsigned int number,
          const double       radius,
          Triangulation<2>  &piece)
    {
      GridGenerator::quarter_hyper_ball(piece, Point<2>(), radius);
      GridTools::rotate(-(number + 1.) * numbers::PI_2, piece);
    }



    void
    wedge(const unsigned int number,
          const double       radius,
          Triangulation<3>  &piece)
    {
      const Tensor<1, 3> x_axis({1, 0, 0});
      const Tensor<1, 3> z_axis({0, 0, 1});
      GridGenerator::quarter_hyper_ball(piece, Point<3>(), radius);
      GridTools::rotate(x_axis, -numbers::PI_2, piece);
      GridTools::rotate(z_axis, -(number * numbers::PI_2), piece);
    }



    /// Rotations leave coordinates like 1e-17, where symmetry planes want 0.
    template <int dim>
    Point<dim>
    without_rounding_noise(Point<dim> point, const double radius)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(point[d]) < 1e-12 * radius)
          point[d] = 0;
      return point;
    }



    template <int dim>
    types::boundary_id
    boundary_of(const Point<dim> &face_centre)
    {
      return face_centre[dim - 1] == 0 ? top :
             face_centre[0] == 0       ? left :
             face_centre[1] == 0       ? front :
                                         curved;
    }
  } // namespace



  void
  HalfBallParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Radius",
      radius,
      "Type half ball: radius of the ball, whose flat side is the top, with "
      "its centre in the origin. Type sector: radius of the block. Unit: "
      "length; allowed: > 0.",
      Patterns::Double());
    prm.add_parameter(
      "Part",
      part,
      "Type half ball: how much of the half ball to compute with: all of it, "
      "the half with x >= 0 (its plane of symmetry x = 0 is the boundary "
      "'left'), or in three dimensions the quarter with x >= 0 and y >= 0 "
      "('left', and y = 0 is 'front'). Forces and areas are those of the part.");
  }



  void
  HalfBallParameters::check(const unsigned int dim) const
  {
    if (radius <= 0)
      throw InputError("Geometry/Radius", radius, "it must be greater than 0.");
    if (dim == 2 && part == HalfBallPart::quarter)
      throw InputError("Geometry/Part",
                       part,
                       "in two dimensions there are only 'full' and 'half'.");
  }



  template <int dim>
  BoundaryNames
  make_half_ball(const HalfBallParameters &parameters,
                 Triangulation<dim>       &triangulation)
  {
    const unsigned int n_pieces = n_wedges<dim>(parameters.part);
    const double       radius   = parameters.radius;

    std::vector<Triangulation<dim>>         pieces(n_pieces);
    std::vector<const Triangulation<dim> *> pointers;
    for (unsigned int i = 0; i < n_pieces; ++i)
      {
        wedge(i, radius, pieces[i]);
        pointers.push_back(&pieces[i]);
      }
    GridGenerator::merge_triangulations(pointers, triangulation, 1e-8 * radius);
    GridTools::transform(
      [radius](const Point<dim> &point) {
        return without_rounding_noise(point, radius);
      },
      triangulation);

    triangulation.reset_all_manifolds();
    triangulation.set_all_manifold_ids(numbers::flat_manifold_id);
    triangulation.set_manifold(spherical, SphericalManifold<dim>());

    std::set<types::boundary_id> used_ids;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const types::boundary_id id = boundary_of(face->center());
            face->set_all_boundary_ids(id);
            if (id == curved)
              face->set_all_manifold_ids(spherical);
            used_ids.insert(id);
          }

    const BoundaryNames all_names = {{"top", top},
                                     {"curved", curved},
                                     {"left", left},
                                     {"front", front}};
    BoundaryNames       names;
    for (const auto &[name, id] : all_names)
      if (used_ids.count(id) > 0)
        names[name] = id;
    return names;
  }



  template BoundaryNames
  make_half_ball(const HalfBallParameters &, Triangulation<2> &);
  template BoundaryNames
  make_half_ball(const HalfBallParameters &, Triangulation<3> &);
} // namespace ElastoPlastic
