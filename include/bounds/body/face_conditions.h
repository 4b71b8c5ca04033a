// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_face_conditions_h
#define bounds_body_face_conditions_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The point @p x of a side or face, moved towards its @p centre by little
  /// more than rounding. A load that jumps at a vertex has one value there for
  /// all sides that meet: what it is on one of them is found inside it.
  template <int dim>
  Point<dim>
  from_inside(const Point<dim> &x, const Point<dim> &centre)
  {
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();

    const double distance = x.distance(centre);
    if (distance == 0.)
      return x;
    double coordinate = 0;
    for (unsigned int d = 0; d < dim; ++d)
      coordinate = std::max(coordinate, std::abs(x[d]));
    const double share = std::clamp(rounding * coordinate / distance,
                                    Tolerance::smallest_inset,
                                    Tolerance::largest_inset);
    return Point<dim>(x + share * (centre - x));
  }



  /// Tells the conditions of faces from those of the boundaries. See
  /// make_split_body(), whose arguments must live as long as this object.
  template <int dim>
  class FaceConditions
  {
  public:
    FaceConditions(const BoundaryConditions<dim> &conditions,
                   const IndenterOnBody<dim>     &indenter,
                   const Loads<dim>              &loads);

    /// Of a face with these corners. @throws InputError
    FaceCondition<dim>
    operator()(const FaceCorners<dim>  &corners,
               const types::boundary_id id) const;

  private:
    using Values = std::map<types::boundary_id,
                            typename BoundaryConditions<dim>::Components>;

    /// How much of a face the indenter can touch.
    enum class Reach
    {
      none,
      part,
      whole
    };

    /// Lets the indenter press where it can.
    void
    add_contact(FaceCondition<dim>     &condition,
                const FaceCorners<dim> &corners) const;

    void
    prescribe(FaceCondition<dim>      &condition,
              const ConditionType      type,
              const Values            &values,
              const types::boundary_id id,
              const FaceCorners<dim>  &corners) const;

    /// At the points of a lattice, but where the indenter does not reach.
    std::vector<double>
    gaps_of(const FaceCorners<dim> &corners) const;

    Reach
    reach_of(const FaceCorners<dim> &corners) const;

    /// Whether the indenter presses across a face that it reaches. It fits the
    /// face if the gap is the same everywhere.
    bool
    presses_across(const FaceCorners<dim> &corners) const;

    const std::set<types::boundary_id> contact;
    const std::set<types::boundary_id> fixed;
    const std::set<types::boundary_id> rollers;
    const Values                      &displacements;
    const Values                      &tractions;
    const IndenterOnBody<dim>         &indenter;
    const Loads<dim>                  &loads;
  };
} // namespace ElastoPlastic

#endif
