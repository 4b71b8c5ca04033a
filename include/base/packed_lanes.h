// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_packed_lanes_h
#define base_packed_lanes_h

#include <array>
#include <cstring>
#include <type_traits>

#include "base/simd.h"

namespace ElastoPlastic
{
  /// The lanes of a Simd<double> as numbers of a smaller type @p T, for storage
  /// only: single precision, or integers, towards zero.
  template <typename T>
  class PackedLanes
  {
  public:
    using Number = Simd<double>;

    PackedLanes() = default;

    PackedLanes(const Number &number)
    {
      if constexpr (n_lanes > 1)
        convert<double, T>(&number, lanes.data());
      else
        lanes[0] = number[0];
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline operator Number() const
    {
      Number number;
      if constexpr (n_lanes > 1)
        convert<T, double>(lanes.data(), &number);
      else
        number[0] = lanes[0];
      return number;
    }

  private:
    static constexpr unsigned int n_lanes = Number::size();

    template <typename U>
    struct VectorOf
    {
      using type [[gnu::vector_size(n_lanes * sizeof(U))]] = U;
    };
    template <typename U>
    using Vector = typename VectorOf<U>::type;

    /// With the processor's conversions of whole registers, which it has
    /// between double precision and integers of four bytes.
    template <typename From, typename To>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    convert(const void *const from, void *const to)
    {
      using Between = std::conditional_t<std::is_integral_v<T>, int, T>;
      Vector<From> source;
      std::memcpy(&source, from, sizeof(source));
      const Vector<To> result = __builtin_convertvector(
        __builtin_convertvector(source, Vector<Between>), Vector<To>);
      std::memcpy(to, &result, sizeof(result));
    }

    std::array<T, n_lanes> lanes;
  };
} // namespace ElastoPlastic

#endif
