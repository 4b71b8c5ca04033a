// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_sloped_bound_h
#define base_sloped_bound_h

#include <array>

namespace ElastoPlastic
{
  /// A bound u_i <= b(u_j, u_l) that depends on other unknowns of the same
  /// rank, to first order, and the force on the body that belongs to it: that
  /// of a contact node beside the flank of an indenter.
  struct SlopedBound
  {
    unsigned int index = 0;
    /// j and l, so many of them as there are.
    std::array<unsigned int, 2> others   = {{0, 0}};
    unsigned int                n_others = 0;
    /// The first derivatives of b.
    std::array<double, 2> slope = {{0., 0.}};
    /// u_j takes the part -force_slope[j] of a force -f on u_i: without
    /// friction, the slope.
    std::array<double, 2> force_slope = {{0., 0.}};
    /// How it changes with u_l; and f, which presses against the bound.
    std::array<std::array<double, 2>, 2> curvature = {};
    double                               force     = 0.;
    /// Whether u_i is not at its bound, but about to come there
    /// (EnteringUnknown).
    bool entering = false;
  };
} // namespace ElastoPlastic

#endif
