// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_tip_on_curved_surface_h
#define evaluation_tip_on_curved_surface_h

#include <deal.II/distributed/tria.h>

#include <array>
#include <memory>
#include <set>

#include "contact/gap_function.h"
#include "evaluation/tip_on_surface.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A tip on a surface that is not level, and is that of the mesh as it is
  /// when it is asked for (doc/theory, "Evaluating an indentation test"). In
  /// three dimensions, or of an axisymmetric body.
  template <int dim>
  class TipOnCurvedSurface : public TipOnSurface
  {
  public:
    /// @p gap_function and @p triangulation must outlive this object. @p part
    /// is modelled_part().
    TipOnCurvedSurface(
      const std::shared_ptr<const TipShape>           &tip,
      const GapFunction<dim>                          &gap_function,
      const parallel::distributed::Triangulation<dim> &triangulation,
      const std::set<types::boundary_id>              &boundaries,
      const double                                     part)
      : tip(tip)
      , gap_function(gap_function)
      , triangulation(triangulation)
      , boundaries(boundaries)
      , part(part)
    {}


    /// The smallest gap of a vertex: contact is found at nodes.
    double
    initial_gap() const override;

    /// That of the tip; but what a flat face leaves above a curved surface
    /// grows as under a paraboloid.
    double
    depth_factor() const override;

    /// Within the boundary.
    double
    overlapped_area(const double height) const override;

  private:
    /// The corners of a face or of a part of it, in lexicographic order.
    using Patch = std::array<Point<dim>, (1 << (dim - 1))>;

    static std::array<Patch, (1 << (dim - 1))>
    quarters(const Patch &patch);

    /// Seen from above; of the whole ring, if there is one.
    static double
    area(const Patch &patch);

    static Point<dim>
    middle(const Patch &patch);

    /// Of the part where the gap is not larger than @p depth.
    double
    overlapped_area(const Patch       &patch,
                    const double       depth,
                    const unsigned int n_divisions) const;

    /// Calls @p receive for all locally owned faces of the surface.
    template <typename Function>
    void
    for_each_face(const Function &receive) const;

    const std::shared_ptr<const TipShape>            tip;
    const GapFunction<dim>                          &gap_function;
    const parallel::distributed::Triangulation<dim> &triangulation;
    const std::set<types::boundary_id>               boundaries;
    const double                                     part;
  };
} // namespace ElastoPlastic

#endif
