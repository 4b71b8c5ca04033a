// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_face_conditions_h
#define bounds_body_face_conditions_h

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "bounds/body/split_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

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
