// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_contact_surface_h
#define evaluation_contact_surface_h

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "evaluation/surface_fields.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// A straight line on the contact surface of a body in space, seen from
  /// above: a point, a direction, and between which distances from the point.
  struct ProfileLine
  {
    Point<2>     point;
    Tensor<1, 2> direction; ///< of length 1
    double       begin = -std::numeric_limits<double>::infinity();
    double       end   = std::numeric_limits<double>::infinity();
  };



  /// The lines that the entry Output/Profile lines names, such as
  /// "0, 0; 1, 1 | 0, 0; 0, 2"; without any, that through @p axis along x.
  /// @throws InputError
  std::vector<ProfileLine>
  read_profile_lines(const std::string &text, const Point<2> &axis);



  /// A point of the contact surface. Between two nodes, everything is linear.
  template <int dim>
  struct SurfacePoint
  {
    /// In the undeformed body.
    Point<dim>     position;
    Tensor<1, dim> displacement;
    /// To the indenter in its present position; not a number where it does not
    /// reach.
    double gap      = 0;
    double pressure = 0;
    /// 1 for a node in contact, else 0.
    double active = 0;
    /// The shear traction of the indenter on the body, and 1 for a node that
    /// sticks to it, else 0.
    Tensor<1, dim> shear;
    double         stick = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &position &displacement &gap &pressure &active &shear &stick;
    }
  };



  /// The contact surface of a solution, as the net of straight sides between
  /// neighbouring nodes: those of the faces, which quadratic elements divide
  /// into 2^(dim-1).
  template <int dim>
  class ContactSurface
  {
  public:
    /// That of @p boundaries.
    ContactSurface(const DoFHandler<dim>              &dof_handler,
                   const std::set<types::boundary_id> &boundaries,
                   const SurfaceFields                &fields);

    /// All nodes, on all ranks, each once, in the order of x. Collective.
    std::vector<SurfacePoint<dim>>
    nodes() const;

    /// Where @p line, seen from above, meets the sides, on all ranks, each
    /// point once, in the order along the line. In three dimensions.
    /// Collective.
    std::vector<SurfacePoint<dim>>
    along(const ProfileLine &line) const;

    /// The largest vertical displacement up to the horizontal @p distance from
    /// @p axis, where the contact is; minus infinity without nodes there.
    /// Collective.
    double
    highest(const Point<dim - 1> &axis, const double distance) const;

    /// The mean vertical displacement at the edge of the contact: at the
    /// horizontal @p distance from @p axis, or as close to it as the sides come
    /// that have one end in contact. Zero without such sides. Collective.
    double
    height_of_edge(const Point<dim - 1> &axis, const double distance) const;

  private:
    struct Side
    {
      SurfacePoint<dim> begin, end;
    };

    /// From @p axis, horizontally, to where the contact finds @p point.
    double
    distance_from(const Point<dim - 1>    &axis,
                  const SurfacePoint<dim> &point) const;

    const MPI_Comm    communicator;
    const bool        at_present_place;
    std::vector<Side> sides;
  };
} // namespace ElastoPlastic

#endif
