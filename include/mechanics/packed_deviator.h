// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_packed_deviator_h
#define mechanics_packed_deviator_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <cstdint>

#include "base/packed_lanes.h"
#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A deviator in each lane, in two bytes an entry: integers times a scale of
  /// the lane, so that the norm is kept (in single precision) and the direction
  /// turns by no more than @p largest_turn. Where the product of two directions
  /// counts, as in the stiffness along the flow, that is an error of the square
  /// of that.
  ///
  /// There are no shear components out of the plane in two dimensions. The last
  /// entry of the diagonal follows from the others.
  template <int dim>
  class PackedDeviator
  {
  public:
    using Number  = Simd<double>;
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    static constexpr double largest_turn = 5e-5;

    PackedDeviator() = default;

    explicit PackedDeviator(const Tensor3 &tensor)
    {
      // (zeros stay zeros)
      const Number tiny    = 1e-100;
      Number       largest = tiny;
      for (unsigned int k = 0; k < n_entries; ++k)
        largest = std::max(largest, std::abs(tensor[row(k)][column(k)]));
      const Number unit = largest_integer / largest;
      for (unsigned int k = 0; k < n_entries; ++k)
        {
          const Number entry = unit * tensor[row(k)][column(k)];
          integers[k] =
            Number(entry + compare_and_apply_mask<SIMDComparison::less_than>(
                             entry, Number(0.), Number(-0.5), Number(0.5)));
        }
      // (the norm of what is kept: a trace that is not zero but for rounding
      // would remain where all else cancels)
      Tensor3 deviator = tensor;
      deviator[2][2]   = -(tensor[0][0] + tensor[1][1]);
      scale            = Number(1.);
      scale = Number(deviator.norm() / std::max(unpack().norm(), tiny));
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline Tensor3
    unpack() const
    {
      const Number factor = scale;
      Tensor3      result;
      for (unsigned int k = 0; k < n_entries; ++k)
        result[row(k)][column(k)] = factor * Number(integers[k]);
      result[2][2] = -(result[0][0] + result[1][1]);
      return result;
    }

  private:
    static constexpr unsigned int n_entries       = (dim == 3 ? 5 : 3);
    static constexpr double       largest_integer = 32767.;

    // xx, yy, xy, xz, yz
    static constexpr unsigned int
    row(const unsigned int entry)
    {
      constexpr std::array<unsigned int, 5> rows = {{0, 1, 0, 0, 1}};
      return rows[entry];
    }

    static constexpr unsigned int
    column(const unsigned int entry)
    {
      constexpr std::array<unsigned int, 5> columns = {{0, 1, 1, 2, 2}};
      return columns[entry];
    }

    std::array<PackedLanes<std::int16_t>, n_entries> integers;
    PackedLanes<float>                               scale;
  };
} // namespace ElastoPlastic

#endif
