// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_indenter_h
#define contact_indenter_h

#include <deal.II/base/point.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The shape of a rigid indenter, seen from its lowest point: the function
  /// phi of Johnson's paper @cite johnson_1978. It knows points only: where the
  /// indenter stands and how far it is pushed is up to GapFunction and to the
  /// loading.
  template <int dim>
  class Indenter
  {
  public:
    virtual ~Indenter() = default;

    /// Height of the indenter's surface above its tip (or face) at the
    /// horizontal offset @p x from its position; +infinity where the indenter
    /// does not reach.
    virtual double
    profile(const Point<dim - 1> &x) const = 0;
  };



  /// Whether a distance from the middle lies within an extent, the edge
  /// included. The tolerance keeps mesh nodes that lie on an edge there, though
  /// their coordinates are rounded.
  inline bool
  within(const double distance, const double extent)
  {
    return distance <= (1 + 1e-10) * extent;
  }
} // namespace ElastoPlastic

#endif
