// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_box_modes_h
#define mechanics_box_modes_h

#include <deal.II/base/utilities.h>

#include <array>
#include <utility>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The modes of elements of @p degree 1 or 2 that are boxes with edges along
  /// the axes: with coordinates xi from -1 to 1, displacements are sums of
  ///   phi_m(xi) = product of P_{m_d}(xi_d),   0 <= m_d <= degree,
  /// with the Legendre polynomials P. So are their gradients; and since that of
  /// P_i is a multiple of P_{i - 1}, a mode of a gradient is made of dim modes
  /// of the displacement. Its column d, the derivative along x_d, is zero if
  /// m_d = degree. Over the box, the phi_m are orthogonal, with the mean square
  /// product of 1 / (2 m_d + 1). So in a linear law that is the same at all
  /// points, each mode has a stress of its own: there is one less of them than
  /// quadrature points, and most have fewer entries. Nodal values become modes,
  /// and stresses become forces, by a few sums and differences.
  template <int dim, int degree, typename Number>
  class BoxModes
  {
  public:
    static constexpr unsigned int n_1d    = degree + 1;
    static constexpr unsigned int n_nodes = Utilities::pow(n_1d, dim);

    /// A displacement gradient or nominal stress, row by row.
    using Entries = std::array<Number, dim * dim>;

    /// A mode as a type: the m_d are the digits of @p m to the base n_1d.
    template <unsigned int m>
    struct Mode
    {
      static constexpr bool is_constant = (m == 0);

      static constexpr unsigned int
      degree_along(const unsigned int direction)
      {
        return m / stride(direction) % n_1d;
      }

      /// Whether that one of the Entries vanishes.
      static constexpr bool
      is_zero(const unsigned int entry)
      {
        return degree_along(entry % dim) == degree;
      }
    };

    /// For boxes with the @p reciprocals of the lengths of their edges.
    BoxModes(const std::array<Number, dim> &reciprocals, const Number &volume)
      : volume(volume)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int i = 0; i < degree; ++i)
          slopes[d][i] = (degree == 1 ? 2. : i == 0 ? 6. : 4.) * reciprocals[d];
    }

    /// Makes nodal forces of nodal displacements, component by component and
    /// the nodes in lexicographic order: law(mode, G) is the stress of
    /// G, which is the gradient of the Mode but for a factor, both Entries; the
    /// law must be linear. What it makes of entries that are zero does not
    /// matter.
    template <typename Law>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    apply(Number *const values, const Law &law) const
    {
      std::array<Number, dim * n_nodes> forces;
      forces.fill(Number(0.));
      for (unsigned int c = 0; c < dim; ++c)
        take_modes(values + c * n_nodes);
      add_forces(forces,
                 values,
                 law,
                 std::make_integer_sequence<unsigned int, n_nodes - 1>());
      for (unsigned int c = 0; c < dim; ++c)
        hand_to_nodes(values + c * n_nodes, &forces[c * n_nodes]);
    }

  private:
    static constexpr unsigned int
    stride(const unsigned int direction)
    {
      return Utilities::pow(n_1d, direction);
    }

    /// Calls @p treat for the lines of nodes along each direction, with that,
    /// their first nodes and the distance of those that follow.
    template <typename Treat>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    for_each_line(const Treat &treat)
    {
#pragma GCC unroll 3
      for (unsigned int d = 0; d < dim; ++d)
#pragma GCC unroll 9
        for (unsigned int line = 0; line < n_nodes / n_1d; ++line)
          treat(d,
                line % stride(d) + line / stride(d) * n_1d * stride(d),
                stride(d));
    }

    /// The coefficients of the Legendre polynomials are multiples of integer
    /// sums of the values at equidistant nodes, with these factors.
    static constexpr double
    factor(const unsigned int i)
    {
      return degree == 1 ? 1. / 2. :
             i == 0      ? 1. / 6. :
             i == 1      ? 1. / 2. :
                           1. / 3.;
    }

    /// Makes of the values at the nodes of the lines along each direction these
    /// sums: the number of an entry becomes that of a mode.
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    take_modes(Number *const values)
    {
      for_each_line([&](const unsigned int,
                        const unsigned int i,
                        const unsigned int stride) {
        const unsigned int last = i + degree * stride;
        const Number       a = values[i], b = values[last];
        values[i] = a + b;
        if constexpr (degree == 1)
          values[last] = b - a;
        else
          {
            Number      &middle        = values[i + stride];
            const Number twice_between = middle + middle;
            values[last]               = values[i] - twice_between;
            values[i] += twice_between + twice_between;
            middle = b - a;
          }
      });
    }

    /// The transpose, which puts its result, but not what is between, to
    /// @p result.
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    hand_to_nodes(Number *const result, Number *const forces)
    {
      for_each_line([&](const unsigned int d,
                        const unsigned int i,
                        const unsigned int stride) {
        const unsigned int last       = i + degree * stride;
        Number             sum        = forces[i];
        const Number       difference = forces[i + stride];
        Number *const      to         = (d == dim - 1 ? result : forces);
        if constexpr (degree == 2)
          {
            const Number curvature = forces[last];
            to[i + stride]         = 2. * (sum + sum - curvature);
            sum += curvature;
          }
        to[i]    = sum - difference;
        to[last] = sum + difference;
      });
    }

    template <typename Law, unsigned int... modes>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_forces(std::array<Number, dim * n_nodes> &forces,
               const Number *const                values,
               const Law                         &law,
               std::integer_sequence<unsigned int, modes...>) const
    {
      (add_forces_of_mode<modes>(forces, values, law), ...);
    }

    // (The factor of the sums is in both the gradient and the virtual one.)
    template <unsigned int m, typename Law>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_forces_of_mode(std::array<Number, dim * n_nodes> &forces,
                       const Number *const                values,
                       const Law                         &law) const
    {
      double square = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i = Mode<m>::degree_along(d);
          square *= factor(i) * factor(i) / (2 * i + 1);
        }
      const Number weight = square * volume;

      Entries gradient;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int c = 0; c < dim; ++c)
          gradient[dim * c + d] = Mode<m>::is_zero(d) ?
                                    Number(0.) :
                                    slopes[d][Mode<m>::degree_along(d)] *
                                      values[c * n_nodes + m + stride(d)];
      const Entries stress = law(Mode<m>(), gradient);
      for (unsigned int d = 0; d < dim; ++d)
        if (!Mode<m>::is_zero(d))
          {
            const Number of_column =
              weight * slopes[d][Mode<m>::degree_along(d)];
            for (unsigned int c = 0; c < dim; ++c)
              forces[c * n_nodes + m + stride(d)] +=
                of_column * stress[dim * c + d];
          }
    }

    const Number volume;
    /// For each direction, what makes the entries of mode i of a gradient of
    /// those of mode i + 1 of the displacement, both but for their factors.
    std::array<std::array<Number, degree>, dim> slopes;
  };
} // namespace ElastoPlastic

#endif
