// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_packed_lanes_h
#define base_packed_lanes_h

#include <array>
#include <type_traits>

#include "base/simd.h"

#include <experimental/simd>

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
        convert(&number[0], lanes.data());
      else
        lanes[0] = number[0];
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline operator Number() const
    {
      Number number;
      if constexpr (n_lanes > 1)
        convert(lanes.data(), &number[0]);
      else
        number[0] = lanes[0];
      return number;
    }

  private:
    static constexpr unsigned int n_lanes = Number::size();

    template <typename U>
    using Vector = std::experimental::
      simd<U, std::experimental::simd_abi::deduce_t<U, n_lanes>>;

    /// With the processor's conversions of whole registers, which it has
    /// between double precision and integers of four bytes. (GCC's
    /// __builtin_convertvector takes five instructions for one of AVX-512; for
    /// the warnings, see NativeVectorizedArray::get_sqrt().)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
    template <typename From, typename To>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    convert(const From *const from, To *const to)
    {
      using namespace std::experimental;
      using Between = std::conditional_t<std::is_integral_v<T>, int, T>;
      const Vector<From> source(from, element_aligned);
      static_simd_cast<Vector<To>>(static_simd_cast<Vector<Between>>(source))
        .copy_to(to, element_aligned);
    }
#pragma GCC diagnostic pop

    std::array<T, n_lanes> lanes;
  };
} // namespace ElastoPlastic

#endif
