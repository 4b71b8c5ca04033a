// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_single_precision_storage_h
#define base_single_precision_storage_h

#include <deal.II/base/aligned_vector.h>

#include <type_traits>

#include "base/packed_lanes.h"
#include "base/simd.h"

namespace ElastoPlastic
{
  /// An array of @p T, a type that consists of nothing but Simd<double>, which
  /// are rounded to single precision for storage: for data of quadrature points
  /// whose size, or the time it takes to read them, matters more than their
  /// last digits.
  template <typename T>
  class SinglePrecisionStorage
  {
  public:
    /// All entries become zero.
    void
    reinit(const std::size_t n_entries)
    {
      numbers.resize(0);
      numbers.resize(n_entries * n_numbers);
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline T
    operator[](const std::size_t entry) const
    {
      T             value;
      Number *const to = reinterpret_cast<Number *>(&value);
      for (unsigned int i = 0; i < n_numbers; ++i)
        to[i] = numbers[entry * n_numbers + i];
      return value;
    }

    void
    set(const std::size_t entry, const T &value)
    {
      const Number *const from = reinterpret_cast<const Number *>(&value);
      for (unsigned int i = 0; i < n_numbers; ++i)
        numbers[entry * n_numbers + i] = from[i];
    }

  private:
    using Number = Simd<double>;
    static_assert(std::is_standard_layout_v<T>);
    static_assert(sizeof(T) % sizeof(Number) == 0);
    static constexpr unsigned int n_numbers = sizeof(T) / sizeof(Number);

    dealii::AlignedVector<PackedLanes<float>> numbers;
  };
} // namespace ElastoPlastic

#endif
