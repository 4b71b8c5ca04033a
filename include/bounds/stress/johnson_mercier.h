// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_johnson_mercier_h
#define bounds_stress_johnson_mercier_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  /// The equilibrium element of Johnson and Mercier @cite johnson_mercier_1978,
  /// in space @cite krizek_1982 @cite gopalakrishnan_guzman_lee_2024: symmetric
  /// stresses on a simplex that are polynomials of a degree, 1 or more, on each
  /// of the parts into which its centre of gravity divides it (see
  /// place_in_part()). The tractions are continuous between the parts.
  ///
  ///              2             Part k of a triangle has the corners k, k + 1
  ///             /|\            (of 3) and the centre of gravity c, in this
  ///            / | \           order. Side k belongs to it.
  ///         2 / .c. \ 1
  ///          /.' 0 '.\         A stress is given by its Bernstein coefficients
  ///         0---------1        on the parts, see value_index().
  ///
  /// The coefficients that come first on a part are the values at its corners;
  /// those of the first degree are these alone. Matrices act on such
  /// coefficients, or have them as columns.
  template <int dim>
  struct JohnsonMercier
  {
    static constexpr unsigned int n_parts = dim + 1;

    /// The order is that of SymmetricTensor: 11, 22, 12, or in space 11, 22,
    /// 33, 12, 13, 23.
    static constexpr unsigned int n_components = dim * (dim + 1) / 2;

    /// Points that coefficients belong to, of each part its own: a stress has
    /// all components at each.
    static constexpr unsigned int
    n_points(const unsigned int degree)
    {
      return n_parts * Bernstein<dim>::n_functions(degree);
    }

    /// Numbers by which a stress is given.
    static constexpr unsigned int
    n_values(const unsigned int degree)
    {
      return n_components * n_points(degree);
    }

    /// Those of a face, at which its traction has dim components.
    static constexpr unsigned int
    n_face_points(const unsigned int degree)
    {
      return Bernstein<dim - 1>::n_functions(degree);
    }

    /// Coefficients of the divergence on the parts.
    static constexpr unsigned int
    n_divergences(const unsigned int degree)
    {
      return dim * n_points(degree - 1);
    }

    /// Where the components of coefficient number @p i on a @p part begin.
    static constexpr unsigned int
    value_index(const unsigned int degree,
                const unsigned int part,
                const unsigned int i)
    {
      return n_components * (Bernstein<dim>::n_functions(degree) * part + i);
    }

    static Corners<dim>
    part_of(const Corners<dim> &corners, const unsigned int part);

    /// The number, among the coefficients of a part, of coefficient @p i on the
    /// face that joins the corners at these @p places of the part.
    static unsigned int
    number_on_face(const unsigned int                   degree,
                   const std::array<unsigned int, dim> &places,
                   const unsigned int                   i);

    /// What the tractions of the parts @p k and @p l on the face between them
    /// are of: where its corners are in either, the centre being the last.
    static std::array<std::array<unsigned int, dim>, 2>
    places_between(const unsigned int k, const unsigned int l);

    /// A basis of all stresses: in the plane 15 of the first and 36 of the
    /// second degree, in space 42 of the first.
    static FullMatrix<double>
    basis(const Corners<dim> &corners, const unsigned int degree);

    /// A basis of the stresses without divergence: 9 and 18, or 30.
    static FullMatrix<double>
    equilibrated_basis(const Corners<dim> &corners, const unsigned int degree);

    /// The jumps of the tractions on the faces between parts.
    static FullMatrix<double>
    jump_matrix(const Corners<dim> &corners, const unsigned int degree);

    /// What turns values into the coefficients of the divergence on the parts,
    /// whose degree is one less: dim components for each.
    static FullMatrix<double>
    divergence_matrix(const Corners<dim> &corners, const unsigned int degree);
  };
} // namespace ElastoPlastic

#endif
