// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_loads_h
#define bounds_body_loads_h

#include <optional>
#include <vector>

#include "base/exceptions.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mesh/split_mesh.h"
#include "loads/boundary_conditions.h"
#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  /// The tractions and body forces that the equilibrium method knows: those at
  /// one time, or such that grow in proportion to a load factor beside others
  /// that do not.
  template <int dim>
  struct Loads
  {
    /// All loads are those at this @p time.
    Loads(const double time, const BodyForce<dim> &body_force = {})
      : begin(time)
      , body_force(body_force)
    {}

    /// The load factor multiplies what the loads become between two times,
    /// or all that they are at the second, if there is no first.
    Loads(const std::optional<double> begin,
          const double                end,
          const BodyForce<dim>       &body_force)
      : begin(begin)
      , end(end)
      , body_force(body_force)
    {}

    /// Those that grow with a load factor: it is the time, of which they are
    /// linear functions; or, if none depends on time, it multiplies all of
    /// them. @throws InputError if they are not linear in time, or all zero.
    static Loads
    growing(const SplitMesh<dim>          &mesh,
            const BoundaryConditions<dim> &conditions,
            const BodyForce<dim>          &body_force);

    /// At which of these @p times the largest of all tractions and body forces
    /// occurs.
    static double
    time_of_largest(const SplitMesh<dim>          &mesh,
                    const BoundaryConditions<dim> &conditions,
                    const BodyForce<dim>          &body_force,
                    const std::vector<double>     &times);

    /// Of a @p load as a function of time.
    template <typename Load>
    auto
    constant_part(const Load &load) const
    {
      return begin ? load(*begin) : decltype(load(0.))();
    }

    template <typename Load>
    auto
    growing_part(const Load &load) const
    {
      return end ? load(*end) - constant_part(load) : decltype(load(0.))();
    }

    /// The body force at a @p time, which must be the same at all these
    /// @p points and between them. @throws InputError
    Tensor<1, dim>
    constant_body_force(const std::vector<Point<dim>> &points,
                        const double                   time) const
    {
      constexpr double between   = 0.3819660113; // (waves do not vanish there)
      const Tensor<1, dim> first = body_force.value(points.front(), time);
      const auto           differs = [&](const Point<dim> &point) {
        return !((body_force.value(point, time) - first).norm() <=
                 Tolerance::expression * first.norm());
      };
      for (unsigned int i = 0; i < points.size(); ++i)
        if (differs(points[i]) ||
            differs(Point<dim>(
              points[i] +
              between * (points[(i + 1) % points.size()] - points[i]))))
          throw InputError(
            "The body force ('Body force') depends on the "
            "position. The equilibrium method is for constant "
            "ones. Write numbers, or expressions in t alone.");
      return first;
    }

    std::optional<double> begin;
    std::optional<double> end;
    BodyForce<dim>        body_force;
  };



  /// Loads, or the power of all in the whole body of revolution.
  struct TwoLoads
  {
    double constant = 0; ///< of the loads that do not grow
    double growing  = 0; ///< of what a load factor of 1 adds
  };
} // namespace ElastoPlastic

#endif
