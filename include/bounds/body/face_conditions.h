// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_face_conditions_h
#define bounds_body_face_conditions_h

#include <map>
#include <set>

#include "bounds/body/space_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Tells the conditions of faces from those of the boundaries. See
  /// make_space_body(), whose arguments must live as long as this object.
  class FaceConditions
  {
  public:
    FaceConditions(const BoundaryConditions<3>                   &conditions,
                   const std::function<double(const Point<3> &)> &gap,
                   const Footprint<2>                            &footprint,
                   const Loads<3>                                &loads,
                   const SurfaceFinish indenter_surface);

    /// Of a face with these corners. @throws InputError
    FaceCondition
    operator()(const TriangleFace &corners, const types::boundary_id id) const;

  private:
    using Values =
      std::map<types::boundary_id, BoundaryConditions<3>::Components>;

    /// How much of a face the indenter can touch.
    enum class Reach
    {
      none,
      part,
      whole
    };

    void
    press(FaceCondition &condition, const TriangleFace &corners) const;

    void
    prescribe(FaceCondition::Component &component,
              const Expression<3>      &expression,
              const TriangleFace       &corners) const;

    Reach
    reach_of(const TriangleFace &corners) const;

    const std::set<types::boundary_id>             contact;
    const std::set<types::boundary_id>             fixed;
    const std::set<types::boundary_id>             rollers;
    const Values                                  &displacements;
    const Values                                  &tractions;
    const std::function<double(const Point<3> &)> &gap;
    const Footprint<2>                            &footprint;
    const Loads<3>                                &loads;
    const SurfaceFinish                            indenter_surface;
  };
} // namespace ElastoPlastic

#endif
