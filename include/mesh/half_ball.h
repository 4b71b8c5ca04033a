// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_half_ball_h
#define mesh_half_ball_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include "base/enum_names.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

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
} // namespace ElastoPlastic

#endif
