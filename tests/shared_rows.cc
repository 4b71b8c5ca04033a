// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Products with the weights of shared rows are those of a full matrix, on ranks
// that own neither row nor column of their entries and on ranks without any.

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include "base/shared_rows.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Weights = SharedRows::Weights;
  using Product = void (Weights::*)(SharedRows::Vector &,
                                    const SharedRows::Vector &) const;

  constexpr unsigned int n = 30;

  const std::vector<Weights::Entry> all_entries = {{2, 17, 0.5},
                                                   {25, 29, -1.},
                                                   {2, 17, 0.25},
                                                   {11, 4, 1.5},
                                                   {2, 3, 2.},
                                                   {25, 0, 3.}};

  /// Entries go round the ranks but the last, if there are several.
  std::vector<Weights::Entry>
  entries_of_rank()
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    std::vector<Weights::Entry> entries;
    for (unsigned int k = 0; k < all_entries.size(); ++k)
      if ((k + 1) % std::max(n_ranks - 1, 1U) == rank)
        entries.push_back(all_entries[k]);
    return entries;
  }

  /// With ghosts where these entries have their rows and columns.
  std::shared_ptr<const Utilities::MPI::Partitioner>
  make_layout(const IndexSet &owned)
  {
    IndexSet ghosts(n);
    for (const Weights::Entry &entry : entries_of_rank())
      {
        ghosts.add_index(entry.row);
        ghosts.add_index(entry.column);
      }
    ghosts.subtract_set(owned);
    return std::make_shared<Utilities::MPI::Partitioner>(owned,
                                                         ghosts,
                                                         MPI_COMM_WORLD);
  }

  /// The largest difference of @p product with a vector from @p expected.
  double
  error(const Product product, const FullMatrix<double> &expected)
  {
    const IndexSet owned =
      Utilities::MPI::create_evenly_distributed_partitioning(MPI_COMM_WORLD, n);
    const auto         layout = make_layout(owned);
    const Weights      weights(entries_of_rank(), layout);
    SharedRows::Vector vector(layout), result(layout);
    Vector<double>     all(n), expected_result(n);
    for (unsigned int i = 0; i < n; ++i)
      all(i) = 1. + i * i;
    for (const auto i : owned)
      vector(i) = all(i);
    (weights.*product)(result, vector);
    expected.vmult(expected_result, all);
    double difference = 0;
    for (const auto i : owned)
      difference =
        std::max(difference, std::abs(result(i) - expected_result(i)));
    return Utilities::MPI::max(difference, MPI_COMM_WORLD);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  FullMatrix<double> matrix(n), transpose(n);
  for (const auto &[row, column, value] : all_entries)
    {
      matrix(row, column) += value;
      transpose(column, row) += value;
    }
  verify("product", error(&Weights::vmult, matrix), 1e-12);
  verify("product with the transpose",
         error(&Weights::Tvmult, transpose),
         1e-12);
}
