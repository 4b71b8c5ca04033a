// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_ready_meshes_h
#define mesh_ready_meshes_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <vector>

#include "base/enum_names.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The entries of the section "Geometry" that shape a box. Lists have one
  /// value per direction.
  struct BoxParameters
  {
    std::vector<double>       lower_corner; ///< empty stands for the origin
    std::vector<double>       upper_corner; ///< empty stands for (1, 1, 1)
    std::vector<unsigned int> repetitions = {1}; ///< or one for all directions
    double                    grading     = 1;
    std::vector<double>       grading_centre;    ///< horizontal; may be empty
    double                    circle_radius = 0; ///< 0 stands for no circle
    std::vector<double>       circle_centre; ///< empty stands for the origin

    /// Declare the entries in the current section.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation with the coarse mesh of a box, cells graded
  /// geometrically towards the top and the grading centre. Its boundaries are
  /// left and right (x), front and back (y, 3D only), bottom and top. In three
  /// dimensions, edges of cells may lie on a circle: see
  /// divide_around_circle().
  /// @throws InputError if there is no room for it.
  template <int dim>
  BoundaryNames
  make_box(const BoxParameters &parameters, Triangulation<dim> &triangulation);



  /// How much of a half ball is computed with; see the entry "Part".
  enum class HalfBallPart
  {
    full,
    half,
    quarter ///< in three dimensions only
  };

  template <>
  inline const EnumNames<HalfBallPart> enum_names<HalfBallPart> = {
    {"full", HalfBallPart::full},
    {"half", HalfBallPart::half},
    {"quarter", HalfBallPart::quarter}};



  /// The entries of the section "Geometry" that shape a half ball.
  struct HalfBallParameters
  {
    double       radius = 1;
    HalfBallPart part   = HalfBallPart::full;

    /// Declare the entries in the current section.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation with the coarse mesh of the lower half of a ball
  /// around the origin, or of the part of it that is left after cutting it at
  /// planes of symmetry: half is x >= 0, quarter is x >= 0 and y >= 0. Its
  /// boundaries are top (flat, at height 0) and curved, and for the parts also
  /// left (x = 0) and front (y = 0). Refinement follows the sphere.
  template <int dim>
  BoundaryNames
  make_half_ball(const HalfBallParameters &parameters,
                 Triangulation<dim>       &triangulation);



  /// The entries of the section "Geometry" that shape a sector of a round
  /// block.
  struct SectorParameters
  {
    double radius      = 1;
    double height      = 1;
    double angle       = 45; ///< in degrees
    double core_radius = 0.125;

    /// Declare the entries in the current section, where the half ball has
    /// declared its radius, which is this one, too.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation, in three dimensions, with the coarse mesh of a
  /// sector of a cylinder: the axis is z, the top lies at z = 0, and the sides
  /// are the half-planes at the angle 0 (y = 0, x > 0) and at the given angle,
  /// counter-clockwise seen from above.
  ///
  /// Hexahedra without hanging nodes, graded towards the point where the axis
  /// meets the top: a core, and shells around and below it, each about twice as
  /// large as the one inside, of the same number of cells each. Seen from
  /// above, three quadrilaterals fill the angle at the axis (six, if it is
  /// larger than 100 degrees) and twice two thirds of them a ring.
  ///
  /// Its boundaries are top, bottom, side (the cylinder), front (y = 0) and
  /// back, which at 180 degrees is a part of front. Refinement follows the
  /// cylinder; all other edges are straight.
  template <int dim>
  BoundaryNames
  make_sector(const SectorParameters &parameters,
              Triangulation<dim>     &triangulation);
} // namespace ElastoPlastic

#endif
