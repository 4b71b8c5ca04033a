// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_logarithm_h
#define mechanics_logarithm_h

namespace ElastoPlastic
{
  /// f(c) = ln(1 + c) / 2, the logarithm of a stretch whose square is 1 + c,
  /// and its divided differences, which without cancellation tend to its
  /// derivatives when their arguments, all above -1, tend to each other.
  namespace HalfLogarithm
  {
    double
    value(const double c);

    /// f[a, b] = (f(b) - f(a)) / (b - a)
    double
    difference(const double a, const double b);

    /// f[a, b, c] = (f[b, c] - f[a, b]) / (c - a)
    double
    difference(const double a, const double b, const double c);
  } // namespace HalfLogarithm
} // namespace ElastoPlastic

#endif
