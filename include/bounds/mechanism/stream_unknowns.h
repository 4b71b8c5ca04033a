// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_stream_unknowns_h
#define bounds_mechanism_stream_unknowns_h

#include <boost/pending/disjoint_sets.hpp>

#include <vector>

#include "bounds/body/split_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The unknowns of a mechanism with a stream function, numbered:
  /// coefficients of the cubic psi, in plane strain, or chi, those of the
  /// linear phi in a body of revolution (StreamElement), and three for the
  /// velocity along each side inside the body.
  ///
  /// They are continuous. Nothing moves through closed sides: the stream
  /// function is the same all along them. It vanishes on the axis, or else in
  /// the first vertex.
  class StreamUnknowns
  {
  public:
    /// @p body must live as long as this object.
    explicit StreamUnknowns(const SplitBody<2> &body);

    /// Of different unknowns that need not vanish.
    unsigned int
    size() const
    {
      return n_unknowns;
    }

    /// Whether there is a phi on a triangle. There is none in plane strain, nor
    /// where triangles touch the axis.
    bool
    has_flux(const unsigned int triangle) const;

    /// Those of the local functions of the StreamElement of a triangle, and of
    /// its sides' velocities; invalid_unsigned_int if they vanish.
    std::vector<unsigned int>
    on_triangle(const unsigned int triangle) const;

  private:
    using Sets = boost::disjoint_sets_with_storage<>;

    void
    find_flux();

    void
    close_side(Sets &sets, const unsigned int side) const;

    void
    number();

    /// The coefficient on a side that is the @p i th (0 to 3) from an end on.
    unsigned int
    cubic(const unsigned int side,
          const unsigned int first_vertex,
          const unsigned int i) const;

    const SplitBody<2> &body;

    /// The first unknown of each kind, before they have been numbered; those of
    /// vertices come before all of these. The last is zero.
    const unsigned int first_on_sides, first_inside, first_flux, first_velocity,
      zero;

    std::vector<bool>         vertex_has_flux;
    std::vector<unsigned int> numbering;
    unsigned int              n_unknowns = 0;
  };
} // namespace ElastoPlastic

#endif
