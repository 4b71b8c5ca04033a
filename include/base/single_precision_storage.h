// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_single_precision_storage_h
#define base_single_precision_storage_h

#include <deal.II/base/aligned_vector.h>

#include <type_traits>

namespace ElastoPlastic
{
  /// An array of @p T, a type that consists of nothing but double precision
  /// numbers, which are rounded to single precision for storage: for data of
  /// quadrature points whose size, or the time it takes to read them, matters
  /// more than their last digits.
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

    T
    operator[](const std::size_t entry) const
    {
      T                  value;
      const float *const from = numbers.data() + entry * n_numbers;
      double *const      to   = reinterpret_cast<double *>(&value);
      for (unsigned int i = 0; i < n_numbers; ++i)
        to[i] = from[i];
      return value;
    }

    void
    set(const std::size_t entry, const T &value)
    {
      const double *const from = reinterpret_cast<const double *>(&value);
      float *const        to   = numbers.data() + entry * n_numbers;
      for (unsigned int i = 0; i < n_numbers; ++i)
        to[i] = from[i];
    }

  private:
    static_assert(std::is_standard_layout_v<T>);
    static_assert(sizeof(T) % sizeof(double) == 0);
    static constexpr unsigned int n_numbers = sizeof(T) / sizeof(double);

    dealii::AlignedVector<float> numbers;
  };
} // namespace ElastoPlastic

#endif
