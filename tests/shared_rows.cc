// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Products with shared rows are those of a full matrix, with columns on other
// ranks than their rows, and on ranks that have no unknowns at all.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <set>

#include "base/shared_rows.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = SharedRows::Vector;

  constexpr unsigned int n = 30, n_of_first_rank = 12;

  struct Entry
  {
    unsigned int row, column;
    double       value;
  };

  const std::vector<std::vector<Entry>> all_rows = {
    {{2, 17, 0.5}, {2, 3, 2.}},
    {{11, 4, 1.5}},
    {{12, 11, 0.25}, {12, 13, 0.75}, {12, 29, -1.}},
    {{25, 29, -1.}, {25, 0, 3.}},
    {{29, 25, 1.}, {29, 29, 0.5}}};



  /// Numbers are on the first and the last rank.
  IndexSet
  owned_numbers()
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    IndexSet owned(n);
    if (rank == 0)
      owned.add_range(0, n_of_first_rank);
    if (rank == n_ranks - 1)
      owned.add_range(n_of_first_rank, n);
    return owned;
  }



  /// In vectors of all unknowns, two others stand before each of the few, in
  /// which these are in the opposite order.
  class Products
  {
  public:
    Products()
      : owned(owned_numbers())
      , matrix(n)
    {
      IndexSet ghosts(n);
      for (const auto &row : all_rows)
        for (const auto &[i, j, value] : row)
          {
            matrix(i, j) = value;
            if (owned.is_element(i) && !owned.is_element(j))
              ghosts.add_index(j);
          }
      const auto layout =
        std::make_shared<const Utilities::MPI::Partitioner>(owned,
                                                            ghosts,
                                                            MPI_COMM_WORLD);
      SharedRows::Rows local_rows;
      for (const auto &row : all_rows)
        if (const auto i = row.front().row; owned.is_element(i))
          {
            std::vector<SharedRows::Rows::Entry> entries;
            for (const Entry &entry : row)
              entries.push_back(
                {layout->global_to_local(entry.column), entry.value});
            local_rows.add(layout->global_to_local(i), entries);
            with_row.insert(i);
          }
      local_rows.finish();
      for (unsigned int k = 0; k < owned.n_elements(); ++k)
        places.push_back(3 * (owned.n_elements() - k) - 1);
      rows = std::make_unique<SharedRows>(local_rows, places, layout);
    }

    void
    check(const double factor) const
    {
      dealii::Vector<double> all(n), expected(n);
      for (unsigned int i = 0; i < n; ++i)
        all(i) = factor * (1. + i * i);
      Vector vector = unknowns();
      vector        = -1e6;
      for (const auto i : owned)
        vector.local_element(place(i)) = all(i);

      matrix.vmult(expected, all);
      compare("sums", expected, with_row, [&](const auto &receive) {
        rows->sums(vector, receive);
      });
      matrix.Tvmult(expected, all);
      compare("shares",
              expected,
              std::set<unsigned int>(owned.begin(), owned.end()),
              [&](const auto &receive) { rows->shares(vector, receive); });
    }

  private:
    /// @p multiply calls what it is given with each of the @p numbers once, and
    /// with its @p expected value.
    template <typename Multiply>
    void
    compare(const std::string            &name,
            const dealii::Vector<double> &expected,
            const std::set<unsigned int> &numbers,
            const Multiply               &multiply) const
    {
      std::multiset<unsigned int> called, wanted;
      for (const unsigned int i : numbers)
        wanted.insert(place(i));
      dealii::Vector<double> of_places(3 * owned.n_elements());
      multiply([&](const unsigned int i, const double value) {
        called.insert(i);
        of_places(i) = value;
      });
      double error = 0;
      for (const unsigned int i : numbers)
        error = std::max(error, std::abs(of_places(place(i)) - expected(i)));
      verify(name,
             Utilities::MPI::max(error, MPI_COMM_WORLD),
             1e-12 * expected.linfty_norm());
      verify("  each once",
             !Utilities::MPI::logical_or(called != wanted, MPI_COMM_WORLD));
    }

    unsigned int
    place(const types::global_dof_index number) const
    {
      return places[owned.index_within_set(number)];
    }

    Vector
    unknowns() const
    {
      return Vector(Utilities::MPI::create_ascending_partitioning(
                      MPI_COMM_WORLD,
                      3 * owned.n_elements())[Utilities::MPI::this_mpi_process(
                      MPI_COMM_WORLD)],
                    MPI_COMM_WORLD);
    }

    const IndexSet              owned;
    FullMatrix<double>          matrix;
    std::set<unsigned int>      with_row;
    std::vector<unsigned int>   places;
    std::unique_ptr<SharedRows> rows;
  };
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Products                         products;
  products.check(1.);
  output() << "Again" << std::endl;
  products.check(-0.3);
}
