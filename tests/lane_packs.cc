// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The unknowns of nodes at scattered places of a vector, read to the lanes of
// batches and added from there, against single numbers; also if lanes have
// places in common.

#include <array>
#include <vector>

#include "base/lane_packs.h"
#include "base/simd.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// As many numbers as other processors take at a time.
  template <typename T, unsigned int n>
  struct Lanes : std::array<T, n>
  {
    static constexpr std::size_t
    size()
    {
      return n;
    }
  };



  template <int dim, typename Number>
  void
  check(const std::string &name)
  {
    using Packs                  = LanePacks<dim, Number>;
    using value_type             = typename Number::value_type;
    constexpr unsigned int lanes = Number::size();

    // (whole numbers, so that sums are exact)
    std::vector<value_type> vector(dim * 2 * lanes + 1);
    for (unsigned int i = 0; i < vector.size(); ++i)
      vector[i] = i;
    std::array<unsigned int, lanes> places;
    for (unsigned int lane = 0; lane < lanes; ++lane)
      places[lane] = dim * ((7 * (lane / 2) + lane % 2) % (2 * lanes));
    places[lanes - 1] = places[0];

    typename Packs::Batches batches;
    Packs::read(batches, vector.data(), places.data());
    bool is_right = true;
    for (unsigned int lane = 0; lane < lanes; ++lane)
      for (unsigned int c = 0; c < dim; ++c)
        {
          is_right = is_right && batches[c][lane] == vector[places[lane] + c];
          batches[c][lane] = 100. * lane + c;
        }
    verify(name + ", read", is_right);

    std::vector<value_type> expected = vector;
    for (unsigned int lane = 0; lane < lanes; ++lane)
      for (unsigned int c = 0; c < dim; ++c)
        expected[places[lane] + c] += batches[c][lane];
    Packs::add(vector.data(), batches, places.data());
    verify(name + ", add", vector == expected);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2, Simd<float>>("2D, single precision");
  check<3, Simd<float>>("3D, single precision");
  check<2, Simd<double>>("2D, double precision");
  check<3, Simd<double>>("3D, double precision");
  check<2, Lanes<float, 4>>("2D, 4 lanes");
  check<3, Lanes<float, 4>>("3D, 4 lanes");
  check<3, Lanes<double, 2>>("3D, 2 lanes");
  check<3, Lanes<double, 4>>("3D, 4 lanes, double precision");
  check<3, Lanes<double, 8>>("3D, 8 lanes, double precision");
  check<3, Lanes<float, 16>>("3D, 16 lanes");
}
