// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_johnson_mercier_h
#define bounds_stress_johnson_mercier_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

#include "bounds/stress/bernstein.h"

/// The equilibrium element of Johnson and Mercier @cite johnson_mercier_1978:
/// symmetric stresses on a triangle K that are linear on each of the three
/// triangles, its subtriangles, into which its centre of gravity divides it,
/// or, of the second degree, quadratic. The tractions are continuous across the
/// sides of the subtriangles.
///
///              2             Subtriangle k has the corners k, k + 1 (of 3)
///             /|\            and the centre of gravity c, in this order. Side
///            / | \           k of K belongs to it.
///         2 / .c. \ 1
///          /.' 0 '.\         A stress is given by its Bernstein coefficients
///         0---------1        on the subtriangles, see value_index().
///
/// The coefficients that come first on a subtriangle are the values at its
/// corners; those of the first degree are these alone.
namespace ElastoPlastic::JohnsonMercier
{
  using namespace dealii;

  using Triangle = std::array<Point<2>, 3>;

  /// Points that coefficients belong to, of each subtriangle its own: a stress
  /// has three components at each.
  constexpr unsigned int
  n_points(const unsigned int degree)
  {
    return 3 * Bernstein::n_functions(degree);
  }

  /// Numbers by which a stress is given.
  constexpr unsigned int
  n_values(const unsigned int degree)
  {
    return 3 * n_points(degree);
  }

  /// Coefficients of the tractions on the three sides.
  constexpr unsigned int
  n_tractions(const unsigned int degree)
  {
    return 6 * (degree + 1);
  }

  /// Coefficients of the divergence on the subtriangles.
  constexpr unsigned int
  n_divergences(const unsigned int degree)
  {
    return 2 * n_points(degree - 1);
  }



  /// Where the coefficients number @p i, of the component 11, come on a
  /// @p subtriangle; those of 22 and 12 follow.
  constexpr unsigned int
  value_index(const unsigned int degree,
              const unsigned int subtriangle,
              const unsigned int i)
  {
    return 3 * (Bernstein::n_functions(degree) * subtriangle + i);
  }



  /// A @p component of coefficient @p i of the traction on a @p side, on the
  /// way from corner side to corner side + 1 of the triangle.
  constexpr unsigned int
  traction_index(const unsigned int degree,
                 const unsigned int side,
                 const unsigned int i,
                 const unsigned int component)
  {
    return 2 * ((degree + 1) * side + i) + component;
  }



  /// The corners of a subtriangle.
  Triangle
  subtriangle_of(const Triangle &triangle, const unsigned int subtriangle);

  /// The values at the corners of a third of a function that is linear on the
  /// triangle, and has these @p values at its corners.
  template <typename Value>
  std::array<Value, 3>
  on_subtriangle(const std::array<Value, 3> &values,
                 const unsigned int          subtriangle)
  {
    return {{values[subtriangle],
             values[(subtriangle + 1) % 3],
             (values[0] + values[1] + values[2]) / 3.}};
  }

  /// The gradients of the linear functions that are 1 at one corner and 0 at
  /// the others.
  std::array<Tensor<1, 2>, 3>
  gradients(const Triangle &triangle);

  /// The coefficient number @p i on a @p subtriangle of a stress of any degree.
  SymmetricTensor<2, 2>
  coefficient(const Vector<double> &values,
              const unsigned int    subtriangle,
              const unsigned int    i);

  /// The number of coefficient @p i on the line from corner @p from to corner
  /// @p to of a subtriangle.
  unsigned int
  number_on_line(const unsigned int degree,
                 const unsigned int from,
                 const unsigned int to,
                 const unsigned int i);

  /// A basis of all stresses, one per column: 15 of the first, 36 of the second
  /// degree.
  FullMatrix<double>
  basis(const Triangle &triangle, const unsigned int degree);

  /// A basis of the stresses without divergence: 9 of the first, 18 of the
  /// second degree.
  FullMatrix<double>
  equilibrated_basis(const Triangle &triangle, const unsigned int degree);

  /// What turns values into the coefficients of the tractions on the sides; the
  /// normals point outwards.
  FullMatrix<double>
  traction_matrix(const Triangle &triangle, const unsigned int degree);

  /// What turns values into the coefficients of the divergence on the
  /// subtriangles, whose degree is one less: two components for each.
  FullMatrix<double>
  divergence_matrix(const Triangle &triangle, const unsigned int degree);
} // namespace ElastoPlastic::JohnsonMercier

#endif
