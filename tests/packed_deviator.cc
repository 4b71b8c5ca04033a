// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Deviators in two bytes an entry: what is unpacked has no trace, the norm of
// what has been packed to single precision, and its direction up to a small
// angle, whatever the units; zeros stay zeros.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>

#include "mechanics/packed_deviator.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

namespace
{
  using Number  = Simd<double>;
  using Tensor3 = SymmetricTensor<2, 3, Number>;

  /// A deviator that is another one in each lane, with a small entry besides
  /// large ones, and none out of the plane in two dimensions.
  template <int dim>
  Tensor3
  sample(const double unit)
  {
    Tensor3 result;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        result[0][0][lane] = unit * std::cos(1. + lane);
        result[1][1][lane] = -unit * std::sin(2. + 3. * lane);
        result[0][1][lane] = 1e-3 * unit * std::cos(5. * lane);
        if (dim == 3)
          {
            result[0][2][lane] = unit * std::sin(0.3 + lane);
            result[1][2][lane] = -unit * std::cos(2. * lane);
          }
      }
    result[2][2] = -(result[0][0] + result[1][1]);
    return result;
  }

  double
  largest_lane(const Number &number)
  {
    double result = 0;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
      result = std::max(result, std::abs(number[lane]));
    return result;
  }

  bool
  is_zero(const Number &number)
  {
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
      if (number[lane] != 0.)
        return false;
    return true;
  }

  template <int dim>
  void
  check(const double unit)
  {
    const std::string where = std::to_string(dim) + "D, unit 10^" +
                              std::to_string(std::lround(std::log10(unit)));
    const Tensor3 tensor   = sample<dim>(unit);
    const Tensor3 unpacked = PackedDeviator<dim>(tensor).unpack();
    verify(where + ", norm",
           largest_lane((unpacked.norm() - tensor.norm()) / tensor.norm()),
           1e-7);
    verify(where + ", direction",
           largest_lane((unpacked - tensor).norm() / tensor.norm()),
           PackedDeviator<dim>::largest_turn);
    verify(where + ", trace",
           largest_lane(trace(unpacked) / tensor.norm()),
           1e-14);
    verify(where + ", zero",
           is_zero(PackedDeviator<dim>(Tensor3()).unpack().norm()));

    // What is left where two parallel deviators have been subtracted.
    Tensor3 rounding;
    rounding[2][2] = 1e-17 * unit;
    verify(where + ", rounding",
           is_zero(PackedDeviator<dim>(rounding).unpack().norm()));
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double unit : {1., 1e-20, 1e20})
    {
      check<2>(unit);
      check<3>(unit);
    }
}
