// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_lanes_h
#define base_lanes_h

#include "base/inlining.h"
#include "base/simd.h"

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
