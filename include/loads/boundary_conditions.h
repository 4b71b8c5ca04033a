// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_boundary_conditions_h
#define loads_boundary_conditions_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/expression.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Boundary conditions". Each boundary of the
  /// geometry must appear in exactly one of them, see BoundaryConditions.
  struct BoundaryConditionParameters
  {
    std::vector<std::string> fixed;
    std::vector<std::string> roller;
    std::vector<std::string> free;
    std::vector<std::string> contact;
    std::string              prescribed_displacement;
    std::string              traction;

    void
    add_parameters(ParameterHandler &prm);
  };



  enum class BoundaryConditionType
  {
    fixed,                   ///< u = 0
    roller,                  ///< u.n = 0, no tangential traction
    prescribed_displacement, ///< some components of u given
    traction,                ///< sigma n given
    free,                    ///< sigma n = 0
    contact                  ///< sigma n = 0 where the indenter does not touch
  };

  /// Which condition holds on which boundary. Each boundary has exactly one.
  template <int dim>
  class BoundaryConditions
  {
  public:
    /// One expression per component; null where a component of the displacement
    /// is free.
    using Components = std::array<std::shared_ptr<const Expression<dim>>, dim>;

    /// @throws InputError if the entries do not fit @p names: a name that there
    /// is not, a boundary without a condition or with two, a number of
    /// components that is not dim, an expression that cannot be evaluated.
    BoundaryConditions(const BoundaryConditionParameters &parameters,
                       const BoundaryNames               &names);

    /// All boundaries.
    const BoundaryNames &
    names() const
    {
      return boundary_names;
    }

    /// The boundaries with this condition.
    std::set<types::boundary_id>
    ids(const BoundaryConditionType type) const;

    /// What is prescribed by boundary. Components are empty where the
    /// displacement is free.
    const std::map<types::boundary_id, Components> &
    prescribed_displacements() const
    {
      return displacements;
    }

    /// The tractions by boundary. No component is empty.
    const std::map<types::boundary_id, Components> &
    tractions() const
    {
      return traction_vectors;
    }

    /// The largest magnitude of a component of what is prescribed on
    /// @p boundary, zero if nothing is. @throws InputError for a value that is
    /// not finite.
    double
    largest_value(const types::boundary_id boundary,
                  const Point<dim>        &point,
                  const double             time) const;

  private:
    void
    add_boundary(const std::string          &entry,
                 const BoundaryConditionType type,
                 const std::string          &name);

    /// Read "name: component; component | name: ...".
    std::map<types::boundary_id, Components>
    add_boundaries_with_components(const std::string          &entry,
                                   const BoundaryConditionType type,
                                   const std::string          &text);

    struct Condition
    {
      BoundaryConditionType type;
      std::string           entry; ///< that names the boundary
    };

    const BoundaryNames                      boundary_names;
    std::map<types::boundary_id, Condition>  conditions;
    std::map<types::boundary_id, Components> displacements;
    std::map<types::boundary_id, Components> traction_vectors;
  };
} // namespace ElastoPlastic

#endif
