// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_simd_h
#define base_simd_h

#include <deal.II/base/vectorization.h>

#ifdef WIDER_THAN_DEAL_II
#  include <experimental/simd>
#endif

/// For the small functions of points and cells, which the compiler must inline
/// wherever it optimises. A Debug build does not optimise: there, it would only
/// make large functions, which take three times as long to compile.
#ifdef DEBUG
#  define ELASTO_PLASTIC_ALWAYS_INLINE
#else
#  define ELASTO_PLASTIC_ALWAYS_INLINE DEAL_II_ALWAYS_INLINE
#endif

namespace ElastoPlastic
{
  /// The numbers that one processor instruction treats at a time: one for each
  /// cell of a batch.
  ///
  /// deal.II's cell loops take any VectorizedArray, but a deal.II built for all
  /// processors of a kind, such as Debian's, has only those of one number. The
  /// rest of this file teaches it those of the processor that this program is
  /// compiled for (CMake option WIDER_THAN_DEAL_II), on top of the C++
  /// library's std::experimental::simd, and source/simd/ compiles deal.II's
  /// MatrixFree for them: 4 to 7 times faster products with AVX-512.
#ifndef WIDER_THAN_DEAL_II
  template <typename Number>
  using Simd = dealii::VectorizedArray<Number>;
#else
  template <typename Number>
  constexpr std::size_t
    simd_width = std::experimental::native_simd<Number>::size();

  template <typename Number>
  using Simd = dealii::VectorizedArray<Number, simd_width<Number>>;



  /// What VectorizedArray demands of its specialisations.
  template <typename Number>
  class NativeVectorizedArray
    : public dealii::VectorizedArrayBase<Simd<Number>, simd_width<Number>>
  {
  public:
    using value_type = Number;
    using Data       = std::experimental::native_simd<Number>;

    NativeVectorizedArray() = default;

    NativeVectorizedArray(const Number scalar)
      : data(scalar)
    {}

    [[gnu::always_inline]] Simd<Number> &
    operator=(const Number scalar)
    {
      return assign(scalar);
    }

    template <typename U>
    NativeVectorizedArray(const std::initializer_list<U> &list)
      : dealii::VectorizedArrayBase<Simd<Number>, simd_width<Number>>(list)
    {}

    [[gnu::always_inline]] Number &
    operator[](const unsigned int lane)
    {
      return reinterpret_cast<Number *>(&data)[lane];
    }

    [[gnu::always_inline]] const Number &
    operator[](const unsigned int lane) const
    {
      return reinterpret_cast<const Number *>(&data)[lane];
    }

    [[gnu::always_inline]] Simd<Number> &
    operator+=(const Simd<Number> &other)
    {
      return assign(data + other.data);
    }

    [[gnu::always_inline]] Simd<Number> &
    operator-=(const Simd<Number> &other)
    {
      return assign(data - other.data);
    }

    [[gnu::always_inline]] Simd<Number> &
    operator*=(const Simd<Number> &other)
    {
      return assign(data * other.data);
    }

    [[gnu::always_inline]] Simd<Number> &
    operator/=(const Simd<Number> &other)
    {
      return assign(data / other.data);
    }

    [[gnu::always_inline]] void
    load(const Number *ptr)
    {
      data.copy_from(ptr, std::experimental::element_aligned);
    }

    [[gnu::always_inline]] void
    store(Number *ptr) const
    {
      data.copy_to(ptr, std::experimental::element_aligned);
    }

    [[gnu::always_inline]] void
    streaming_store(Number *ptr) const
    {
      store(ptr);
    }

    [[gnu::always_inline]] void
    gather(const Number *base_ptr, const unsigned int *offsets)
    {
      for (unsigned int lane = 0; lane < Data::size(); ++lane)
        (*this)[lane] = base_ptr[offsets[lane]];
    }

    [[gnu::always_inline]] void
    scatter(const unsigned int *offsets, Number *base_ptr) const
    {
      for (unsigned int lane = 0; lane < Data::size(); ++lane)
        base_ptr[offsets[lane]] = (*this)[lane];
    }

    // GCC 12 takes the "undefined" argument of the instruction for an
    // oversight.
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wuninitialized"
#  pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
    [[gnu::always_inline]] Simd<Number>
    get_sqrt() const
    {
      return Simd<Number>().assign(std::experimental::sqrt(data));
    }
#  pragma GCC diagnostic pop

    [[gnu::always_inline]] Simd<Number>
    get_abs() const
    {
      return Simd<Number>().assign(std::experimental::abs(data));
    }

    [[gnu::always_inline]] Simd<Number>
    get_max(const Simd<Number> &other) const
    {
      return Simd<Number>().assign(std::experimental::max(data, other.data));
    }

    [[gnu::always_inline]] Simd<Number>
    get_min(const Simd<Number> &other) const
    {
      return Simd<Number>().assign(std::experimental::min(data, other.data));
    }

    [[gnu::always_inline]] Simd<Number> &
    assign(const Data &new_data)
    {
      data = new_data;
      return static_cast<Simd<Number> &>(*this);
    }

    Data data;
  };
#endif
} // namespace ElastoPlastic



#ifdef WIDER_THAN_DEAL_II
DEAL_II_NAMESPACE_OPEN

template <>
class VectorizedArray<float, ElastoPlastic::simd_width<float>>
  : public ElastoPlastic::NativeVectorizedArray<float>
{
public:
  using NativeVectorizedArray::NativeVectorizedArray;
  using NativeVectorizedArray::operator=;
};



template <>
class VectorizedArray<double, ElastoPlastic::simd_width<double>>
  : public ElastoPlastic::NativeVectorizedArray<double>
{
public:
  using NativeVectorizedArray::NativeVectorizedArray;
  using NativeVectorizedArray::operator=;
};



template <SIMDComparison predicate, typename Number, std::size_t width>
DEAL_II_ALWAYS_INLINE inline VectorizedArray<Number, width>
compare_and_apply_mask(const VectorizedArray<Number, width> &left,
                       const VectorizedArray<Number, width> &right,
                       const VectorizedArray<Number, width> &true_value,
                       const VectorizedArray<Number, width> &false_value)
{
  const auto holds = [](const auto &a, const auto &b) {
    if constexpr (predicate == SIMDComparison::equal)
      return a == b;
    else if constexpr (predicate == SIMDComparison::not_equal)
      return a != b;
    else if constexpr (predicate == SIMDComparison::less_than)
      return a < b;
    else if constexpr (predicate == SIMDComparison::less_than_or_equal)
      return a <= b;
    else if constexpr (predicate == SIMDComparison::greater_than)
      return a > b;
    else
      return a >= b;
  };
  VectorizedArray<Number, width> result = false_value;
  std::experimental::where(holds(left.data, right.data), result.data) =
    true_value.data;
  return result;
}

DEAL_II_NAMESPACE_CLOSE
#endif

namespace ElastoPlastic
{
  /// How many numbers a @p Number consists of, double or VectorizedArray, and
  /// access to one of them: for what cannot be done with all at once.
  template <typename Number>
  constexpr unsigned int n_lanes = 1;

  template <typename T, std::size_t width>
  constexpr unsigned int n_lanes<dealii::VectorizedArray<T, width>> = width;



  inline double &
  lane_of(double &number, const unsigned int)
  {
    return number;
  }



  inline const double &
  lane_of(const double &number, const unsigned int)
  {
    return number;
  }



  template <std::size_t width>
  ELASTO_PLASTIC_ALWAYS_INLINE inline double &
  lane_of(dealii::VectorizedArray<double, width> &number,
          const unsigned int                      lane)
  {
    return number[lane];
  }



  template <std::size_t width>
  ELASTO_PLASTIC_ALWAYS_INLINE inline const double &
  lane_of(const dealii::VectorizedArray<double, width> &number,
          const unsigned int                            lane)
  {
    return number[lane];
  }
} // namespace ElastoPlastic

#endif
