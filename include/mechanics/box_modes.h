// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_box_modes_h
#define mechanics_box_modes_h

#include <array>
#include <type_traits>
#include <utility>

#include "base/inlining.h"

namespace ElastoPlastic
{
  /// The modes of bi- or trilinear elements that are boxes with edges along the
  /// axes. With coordinates xi from -1/2 to 1/2, their displacement gradients
  /// are
  ///   sum_k G_k phi_k(xi),   phi_k = product of xi_e over e in k,
  /// with sets k of directions, but not all of them: the column d of G_k, the
  /// derivative along x_d, is zero if d is in k. Over the box, the phi_k are
  /// orthogonal, with the mean square 1 / 12^|k|. So in a linear law that
  /// is the same at all points, each mode has a stress of its own: there is one
  /// less of them than quadrature points, and most have fewer entries. Nodal
  /// values become modes, and stresses become forces, by sums and differences.
  template <int dim, typename Number>
  class BoxModes
  {
  public:
    static constexpr unsigned int n_nodes = 1U << dim;

    /// A displacement gradient or nominal stress, row by row.
    using Entries = std::array<Number, dim * dim>;

    /// A set k as a type; bit d stands for direction d.
    template <unsigned int bits>
    using Set = std::integral_constant<unsigned int, bits>;

    static constexpr bool
    contains(const unsigned int set, const unsigned int direction)
    {
      return (set >> direction) % 2 == 1;
    }

    /// For boxes with the @p reciprocals of the lengths of their edges.
    BoxModes(const std::array<Number, dim> &reciprocals, const Number &volume)
      : reciprocals(reciprocals)
      , volume(volume)
    {}

    /// Makes nodal forces of nodal displacements, component by component and
    /// the nodes in lexicographic order: law(Set<k>(), G) is the stress of
    /// G, which is G_k but for a factor, both Entries; the law must be linear.
    /// The columns of the stress that are in k do not matter.
    template <typename Law>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    apply(Number *const values, const Law &law) const
    {
      std::array<Number, dim * n_nodes> forces;
      forces.fill(Number(0.));
      for (unsigned int c = 0; c < dim; ++c)
        take_sums_and_differences(values + c * n_nodes);
      add_forces(forces,
                 values,
                 law,
                 std::make_integer_sequence<unsigned int, n_nodes - 1>());
      for (unsigned int c = 0; c < dim; ++c)
        hand_to_nodes(values + c * n_nodes, &forces[c * n_nodes]);
    }

  private:
    /// Replaces the values a and b at the two ends of the edges along each
    /// direction by a + b and b - a: the number of an entry becomes the set of
    /// directions in which the differences have been taken.
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    take_sums_and_differences(Number *const values)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int i = 0; i < n_nodes; ++i)
          if (!contains(i, d))
            {
              const Number a = values[i], b = values[i + (1U << d)];
              values[i]             = a + b;
              values[i + (1U << d)] = b - a;
            }
    }

    /// The transpose, which puts its result, but not what is between, to
    /// @p result.
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    hand_to_nodes(Number *const result, Number *const forces)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int i = 0; i < n_nodes; ++i)
          if (!contains(i, d))
            {
              const unsigned int j   = i + (1U << d);
              const Number       sum = forces[i], difference = forces[j];
              Number *const      to = (d == dim - 1 ? result : forces);
              to[i]                 = sum - difference;
              to[j]                 = sum + difference;
            }
    }

    template <typename Law, unsigned int... sets>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_forces(std::array<Number, dim * n_nodes> &forces,
               const Number *const                values,
               const Law                         &law,
               std::integer_sequence<unsigned int, sets...>) const
    {
      (add_forces_of_mode(forces, values, law, Set<sets>()), ...);
    }

    // A sum is twice the mean, which G_k has. Both the gradient and the virtual
    // one are larger by that; the factor makes up for it.
    template <typename Law, unsigned int set>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_forces_of_mode(std::array<Number, dim * n_nodes> &forces,
                       const Number *const                values,
                       const Law                         &law,
                       const Set<set>                     mode) const
    {
      double factor = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        factor /= contains(set, d) ? 12. : 4.;
      factor *= 4.;

      Entries gradient;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int c = 0; c < dim; ++c)
          gradient[dim * c + d] =
            contains(set, d) ?
              Number(0.) :
              reciprocals[d] * values[c * n_nodes + set + (1U << d)];
      const Entries stress = law(mode, gradient);
      for (unsigned int d = 0; d < dim; ++d)
        if (!contains(set, d))
          {
            const Number weight = factor * volume * reciprocals[d];
            for (unsigned int c = 0; c < dim; ++c)
              forces[c * n_nodes + set + (1U << d)] +=
                weight * stress[dim * c + d];
          }
    }

    const std::array<Number, dim> reciprocals;
    const Number                  volume;
  };
} // namespace ElastoPlastic

#endif
