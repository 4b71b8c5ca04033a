// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_face_conditions_h
#define bounds_body_face_conditions_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "bounds/body/loads.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mesh/integration.h"
#include "bounds/mesh/split_mesh.h"
#include "loads/boundary_conditions.h"

namespace ElastoPlastic
{
  template <int dim>
  struct IndenterOnBody;



  /// What holds for one component of displacement and traction on a face.
  enum class ConditionType
  {
    continuous,   ///< between two simplices
    traction,     ///< the traction is given, maybe zero
    displacement, ///< the displacement is given, maybe zero; as it is across
                  ///< the direction in which a rough indenter presses
    contact       ///< the indenter presses, if it touches, in this direction
  };



  /// A given traction or displacement on a face, zero if there is none: in the
  /// plane any function of the position, in space a linear one.
  template <int dim>
  struct FaceValue
  {
    std::function<double(const FacePoint<dim> &)> function;

    double
    operator()(const FacePoint<dim> &point) const
    {
      return function ? function(point) : 0.;
    }

    bool
    is_zero() const
    {
      return !function;
    }
  };



  /// The condition of a face: for each of dim directions at right angles.
  template <int dim>
  struct FaceCondition
  {
    struct Component
    {
      Tensor<1, dim> direction;
      ConditionType  type;
      FaceValue<dim> value     = {};
      FaceValue<dim> live_load = {}; ///< what a load factor adds to a traction
    };

    std::array<Component, dim> components;

    /// Whether the indenter can touch any point of the face. If it can touch
    /// some only, it presses on none: the stresses stay admissible. But no
    /// point of the face may penetrate, nor slide along a rough indenter, so
    /// that motions are admissible, too.
    bool is_reached = false;

    /// The component in which the indenter presses.
    const Component &
    contact() const
    {
      return components[dim - 1];
    }

    /// Whether it can press on all of the face.
    bool
    is_pressed() const
    {
      return contact().type == ConditionType::contact;
    }
  };



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



  /// The conditions of the faces of a @p mesh, from those of the boundaries;
  /// see make_split_body(). @throws InputError
  template <int dim>
  std::vector<FaceCondition<dim>>
  conditions_of_faces(const SplitMesh<dim>          &mesh,
                      const BoundaryConditions<dim> &conditions,
                      const IndenterOnBody<dim>     &indenter,
                      const Loads<dim>              &loads);
} // namespace ElastoPlastic

#endif
