// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Interpolation of unknowns: the rows of nodes, shared, and of others give the
// numbers of the whole matrix, in whatever order they come.

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "base/nodal_interpolation.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int dim = 3, n_unknowns = 14, n_entries = 12;

  using Interpolation = NodalInterpolation<dim, double>;

  struct Sample
  {
    Interpolation      interpolation;
    FullMatrix<double> matrix{n_unknowns, n_entries};

    void
    add(const unsigned int                       unknown,
        const std::vector<Interpolation::Entry> &entries)
    {
      interpolation.add(unknown, entries);
      for (const auto &[index, weight] : entries)
        matrix(unknown, index) += weight;
    }

    /// With the same weights for all unknowns of a node.
    void
    add_node(const unsigned int                first,
             std::vector<Interpolation::Entry> entries)
    {
      for (unsigned int c = 0; c < dim; ++c)
        {
          add(first + c, entries);
          for (auto &entry : entries)
            ++entry.index;
        }
    }
  };



  Sample
  make_sample()
  {
    Sample sample;
    sample.add_node(0, {{0, 0.5}, {6, 0.25}, {3, 0.25}});
    sample.add(3, {{2, 0.1}});
    sample.add_node(4, {{9, 1.}});
    // a node but for one weight, and one with fewer entries
    sample.add(7, {{0, 0.5}, {3, 0.5}});
    sample.add(8, {{1, 0.5}, {4, 0.6}});
    sample.add(9, {{2, 0.5}, {5, 0.5}});
    sample.add(10, {{0, 1.}, {3, 0.}});
    sample.add(11, {{1, 1.}});
    sample.add(12, {});
    sample.interpolation.finish();
    return sample;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Sample                           sample = make_sample();
  verify("every row is there", sample.interpolation.n_unknowns() == 13);

  Vector<double> vector(n_entries), expected(n_unknowns), found(n_unknowns);
  for (unsigned int i = 0; i < n_entries; ++i)
    vector(i) = std::sin(1. + i);
  sample.matrix.vmult(expected, vector);
  std::vector<unsigned int> order;
  sample.interpolation.interpolate(vector.begin(),
                                   [&](const unsigned int i, const double v) {
                                     found(i) += v;
                                     order.push_back(i);
                                   });
  found -= expected;
  verify("interpolates", found.linfty_norm(), 1e-15);

  Vector<double> values(n_unknowns), expected_sums(n_entries), sums(n_entries);
  for (unsigned int i = 0; i < n_unknowns; ++i)
    values(i) = std::cos(2. * i);
  sample.matrix.Tvmult(expected_sums, values);
  std::vector<unsigned int> order_of_transpose, order_of_unknowns;
  sample.interpolation.add_transpose(sums.begin(), [&](const unsigned int i) {
    order_of_transpose.push_back(i);
    return values(i);
  });
  sums -= expected_sums;
  verify("its transpose", sums.linfty_norm(), 1e-15);

  sample.interpolation.for_each_unknown(
    [&](const unsigned int i) { order_of_unknowns.push_back(i); });
  verify("in the same order",
         order == order_of_transpose && order == order_of_unknowns);

  std::vector<std::pair<unsigned int, unsigned int>> copies;
  sample.interpolation.for_each_copy(
    [&](const unsigned int i, const unsigned int j) {
      copies.emplace_back(i, j);
    });
  const std::vector<std::pair<unsigned int, unsigned int>> expected_copies = {
    {4, 9}, {5, 10}, {6, 11}, {11, 1}};
  verify("copies", copies == expected_copies);
}
