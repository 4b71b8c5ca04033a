// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Cholesky factors of a sparse matrix with many fronts, and of one with a few
// that are larger than the tiles in which they are stored.

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "bounds/conic/kkt_system.h"
#include "bounds/conic/sparse_cholesky.h"
#include "verdict.h"

#include <omp.h>

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int n_points     = 12; // in each direction
  constexpr unsigned int n_components = 3;
  constexpr unsigned int size = n_points * n_points * n_points * n_components;

  /// Calls the @p action for all pairs of unknowns at neighbours of a grid.
  template <typename Action>
  void
  for_each_pair(const Action &action)
  {
    const auto distance = [](const int a, const int b, const int stride) {
      return std::abs(a / stride % int(n_points) - b / stride % int(n_points));
    };
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          const int a = i / n_components, b = j / n_components;
          if (distance(a, b, 1) + distance(a, b, n_points) +
                distance(a, b, n_points * n_points) <=
              1)
            action(i, j);
        }
  }



  /// Diagonally dominant, without symmetries but its own.
  double
  entry(const unsigned int i, const unsigned int j)
  {
    return i == j ? 25. : ((7 * i + 13 * j) % 11) / 11. - 0.7;
  }



  void
  fill(SparseCholesky &factor)
  {
    factor.clear();
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      factor.entry(i, j) = entry(i, j);
    });
  }



  /// The unknowns of each two neighbours.
  std::vector<std::vector<unsigned int>>
  neighbors()
  {
    std::vector<std::vector<unsigned int>> result;
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      if (i % n_components == 0 && j % n_components == 0 && i != j)
        result.push_back({i, i + 1, i + 2, j, j + 1, j + 2});
    });
    return result;
  }



  Vector<double>
  solve(const SparseCholesky &factor)
  {
    Vector<double> right_hand_side(size), solution;
    right_hand_side = 1.;
    factor.vmult(solution, right_hand_side);
    return solution;
  }



  double
  largest_residual(const Vector<double> &x)
  {
    Vector<double> residual(size);
    residual = -1.;
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      residual[i] += entry(i, j) * x[j];
      if (i != j)
        residual[j] += entry(i, j) * x[i];
    });
    return residual.linfty_norm();
  }



  /// Two lists of unknowns that overlap: of the first, 600 are eliminated with
  /// 300 rows below them.
  double
  residual_of_large_fronts()
  {
    constexpr unsigned int n = 1500, begin_of_second = 600, end_of_first = 900;
    std::vector<std::vector<unsigned int>> lists(2);
    for (unsigned int i = 0; i < n; ++i)
      {
        if (i < end_of_first)
          lists[0].push_back(i);
        if (i >= begin_of_second)
          lists[1].push_back(i);
      }
    SparseCholesky factor(n, lists);
    factor.clear();
    FullMatrix<double> matrix(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i < end_of_first ? 0 : begin_of_second; j <= i; ++j)
        {
          const double value = i == j ? 1000. : entry(i, j);
          matrix(i, j) = matrix(j, i) = factor.entry(i, j) = value;
        }
    if (!factor.factorize())
      return numbers::invalid_unsigned_int;
    Vector<double> right_hand_side(n), solution, residual(n);
    right_hand_side = 1.;
    factor.vmult(solution, right_hand_side);
    return matrix.residual(residual, solution, right_hand_side);
  }
} // namespace



// What it holds points into itself.
static_assert(!std::is_copy_constructible_v<SparseCholesky> &&
              !std::is_move_constructible_v<SparseCholesky> &&
              !std::is_copy_constructible_v<KktSystem> &&
              !std::is_move_constructible_v<KktSystem>);



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  SparseCholesky factor(size, neighbors());
  fill(factor);
  omp_set_num_threads(1);
  verify("positive definite", factor.factorize());
  const Vector<double> x = solve(factor);
  verify("residual", largest_residual(x), 1e-14);

  fill(factor);
  omp_set_num_threads(3);
  verify("by three threads", factor.factorize());
  const Vector<double> again = solve(factor);
  verify("the same numbers", std::equal(x.begin(), x.end(), again.begin()));

  fill(factor);
  factor.entry(size / 2, size / 2) = -25.;
  verify("not positive definite", !factor.factorize());
  fill(factor);
  verify("positive definite again", factor.factorize());
  verify("its residual", largest_residual(solve(factor)), 1e-14);

  omp_set_num_threads(1);
  verify("large fronts", residual_of_large_fronts(), 1e-12);
  omp_set_num_threads(3);
  verify("by three threads", residual_of_large_fronts(), 1e-12);
}
