// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_johnson_mercier_h
#define equilibrium_johnson_mercier_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>

/// The equilibrium element of Johnson and Mercier @cite johnson_mercier_1978:
/// symmetric stresses on a triangle K that are linear on each of the three
/// triangles, its subtriangles, into which its centre of gravity divides it.
/// The tractions are continuous across the sides of the subtriangles.
///
///              2             Subtriangle k has the corners k, k + 1 (modulo 3)
///              and
///             /|\            the centre of gravity c, in this order. Side k
///            / | \           of K belongs to it.
///         2 / .c. \ 1
///          /.' 0 '.\         A stress is given by its values at the corners
///         0---------1        of the subtriangles, see value_index().
///
/// Its degrees of freedom are the tractions at both ends of each side (dofs 0
/// to 11, see traction_index()) and the mean values of the components 11, 22
/// and 12 (dofs 12, 13, 14): J (4.3) and (4.4) in @cite johnson_1978.
namespace ElastoPlastic::JohnsonMercier
{
  using namespace dealii;

  using Triangle = std::array<Point<2>, 3>;

  /// Numbers by which a stress is given: subtriangles times corners times
  /// components.
  constexpr unsigned int n_values = 27;
  /// Corners of subtriangles, of each subtriangle its own: a stress has three
  /// components at each.
  constexpr unsigned int n_points = 9;
  constexpr unsigned int n_dofs   = 15;
  /// Of them, stresses without divergence have so many left.
  constexpr unsigned int n_equilibrated_dofs = 9;
  /// Components of the tractions at both ends of three sides.
  constexpr unsigned int n_tractions = 12;



  /// The @p component (0: 11, 1: 22, 2: 12) at a @p corner of a @p subtriangle.
  constexpr unsigned int
  value_index(const unsigned int subtriangle,
              const unsigned int corner,
              const unsigned int component)
  {
    return 9 * subtriangle + 3 * corner + component;
  }



  /// A @p component of the traction at an end of a @p side; its ends are the
  /// corners side and side + 1 of the triangle.
  constexpr unsigned int
  traction_index(const unsigned int side,
                 const unsigned int end,
                 const unsigned int component)
  {
    return 4 * side + 2 * end + component;
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

  /// The stress at a @p corner of a @p subtriangle.
  SymmetricTensor<2, 2>
  stress_at(const Vector<double> &values,
            const unsigned int    subtriangle,
            const unsigned int    corner);

  /// The values of the shape functions, one per column (27 x 15): they are
  /// dual to the degrees of freedom.
  FullMatrix<double>
  shape_functions(const Triangle &triangle);

  /// A basis of the stresses without divergence (27 x 9).
  FullMatrix<double>
  equilibrated_basis(const Triangle &triangle);

  /// What turns values into tractions on the sides (12 x 27); the normals
  /// point outwards.
  FullMatrix<double>
  traction_matrix(const Triangle &triangle);

  /// What turns values into the divergence on the subtriangles, which is
  /// constant there (6 x 27): two components for each.
  FullMatrix<double>
  divergence_matrix(const Triangle &triangle);

  /// The interpolation pi_h of J (4.5): the degrees of freedom (15) of a
  /// stress field, the end tractions being those of the linear function on
  /// each side that has the same resultant and moment. Integrals are computed
  /// by Gauss formulas, exact for polynomials of degree 5 or less.
  Vector<double>
  interpolate(
    const Triangle                                               &triangle,
    const std::function<SymmetricTensor<2, 2>(const Point<2> &)> &stress);
} // namespace ElastoPlastic::JohnsonMercier

#endif
