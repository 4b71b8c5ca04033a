// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_side_conditions_h
#define bounds_body_side_conditions_h

#include <map>
#include <set>
#include <vector>

#include "bounds/body/plane_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Tells the conditions of sides from those of the boundaries. See
  /// make_plane_body(), whose arguments must live as long as this object.
  class SideConditions
  {
  public:
    SideConditions(const BoundaryConditions<2>                   &conditions,
                   const std::function<double(const Point<2> &)> &gap,
                   const Loads<2>                                &loads,
                   const SurfaceFinish   indenter_surface,
                   const ContactGeometry geometry,
                   const Footprint<1>   &footprint);

    /// @throws InputError
    SideCondition
    operator()(const SplitMesh &mesh, const SplitMesh::Side &side) const;

  private:
    using Values =
      std::map<types::boundary_id, BoundaryConditions<2>::Components>;

    /// How much of a side the indenter can touch.
    enum class Reach
    {
      none,
      part,
      whole
    };

    SideCondition
    under_indenter() const;

    /// What is prescribed on the side with this @p centre.
    void
    prescribe(SideCondition           &condition,
              const SideConditionType  type,
              const Values            &values,
              const types::boundary_id id,
              const Point<2>          &centre) const;

    /// At equidistant points of a side, but where the indenter does not reach.
    std::vector<double>
    gaps_of(const SplitMesh &mesh, const SplitMesh::Side &side) const;

    Reach
    reach_of(const SplitMesh &mesh, const SplitMesh::Side &side) const;

    /// Whether the indenter presses across a side that it reaches. It fits the
    /// side if the gap is the same at both ends.
    bool
    presses_across(const SplitMesh &mesh, const SplitMesh::Side &side) const;

    const std::set<types::boundary_id>             contact;
    const std::set<types::boundary_id>             fixed;
    const std::set<types::boundary_id>             rollers;
    const Values                                  &displacements;
    const Values                                  &tractions;
    const std::function<double(const Point<2> &)> &gap;
    const Loads<2>                                &loads;
    const SurfaceFinish                            indenter_surface;
    const ContactGeometry                          geometry;
    const Footprint<1>                            &footprint;
  };
} // namespace ElastoPlastic

#endif
