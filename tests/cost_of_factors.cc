// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// cost_of_factors [MESHES]
//
// Measures how long the own multifrontal factorisation and CHOLMOD's
// supernodal one take for equations of stresses in the block of
// limit_load/square_punch_3d.prm, with nine for each triangle of meshes that
// are refined at the edge of the punch, each with its own order of elimination
// and on as many threads as OMP_NUM_THREADS says. Values are those of a
// diagonally dominant matrix. Writes a table of numbers separated by commas.
// The BLAS is CHOLMOD's: a processor that it does not know gets slow kernels;
// see OPENBLAS_VERBOSE=2, and choose with OPENBLAS_CORETYPE.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bounds/conic/sparse_cholesky.h"
#include "bounds/mesh/split_mesh.h"

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int equations_per_face = 9;

  /// Of the fastest of three calls.
  double
  seconds(const std::function<bool()> &work)
  {
    double fastest = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < 3; ++i)
      {
        const auto begin = std::chrono::steady_clock::now();
        AssertThrow(work(), ExcMessage("The matrix is not positive definite."));
        const std::chrono::duration<double> time =
          std::chrono::steady_clock::now() - begin;
        fastest = std::min(fastest, time.count());
      }
    return fastest;
  }



  /// Refines the cells at the edge of the punch 2 x 2.
  void
  refine(Triangulation<3> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const double size = cell->extent_in_direction(0);
        const auto   x    = cell->center();
        if (std::abs(std::max(x[0], x[1]) - 1.) < size && x[2] > -size)
          cell->set_refine_flag();
      }
    mesh.execute_coarsening_and_refinement();
  }



  /// By tetrahedra, the equations of their faces.
  std::vector<std::vector<unsigned int>>
  equations(const SplitMesh<3> &mesh)
  {
    std::vector<std::vector<unsigned int>> result;
    for (const auto &simplex : mesh.simplices)
      {
        auto &list = result.emplace_back();
        for (const unsigned int f : simplex.faces)
          for (unsigned int i = 0; i < equations_per_face; ++i)
            list.push_back(equations_per_face * f + i);
      }
    return result;
  }



  /// The lower half of all pairs.
  SparsityPattern
  couplings(const unsigned int                            n,
            const std::vector<std::vector<unsigned int>> &coupled)
  {
    DynamicSparsityPattern pattern(n, n);
    for (const auto &list : coupled)
      for (const unsigned int i : list)
        for (const unsigned int j : list)
          if (j <= i)
            pattern.add(i, j);
    SparsityPattern result;
    result.copy_from(pattern);
    return result;
  }



  /// CHOLMOD's own factors of a matrix whose lower half is given.
  class Supernodal
  {
  public:
    explicit Supernodal(const SparseMatrix<double> &lower)
    {
      cholmod_l_start(&common);
      common.supernodal     = CHOLMOD_SUPERNODAL;
      common.default_nesdis = 1; // METIS' own would catch SIGTERM
      begins.push_back(0);
      for (unsigned int row = 0; row < lower.m(); ++row)
        {
          std::vector<std::pair<SuiteSparse_long, double>> entries;
          for (auto entry = lower.begin(row); entry != lower.end(row); ++entry)
            if (entry->column() <= row)
              entries.emplace_back(entry->column(), entry->value());
          std::sort(entries.begin(), entries.end());
          for (const auto &[column, value] : entries)
            {
              columns.push_back(column);
              values.push_back(value);
            }
          begins.push_back(columns.size());
        }
      matrix      = {};
      matrix.nrow = matrix.ncol = lower.m();
      matrix.nzmax              = columns.size();
      matrix.p                  = begins.data();
      matrix.i                  = columns.data();
      matrix.x                  = values.data();
      matrix.stype              = 1;
      matrix.itype              = CHOLMOD_LONG;
      matrix.xtype              = CHOLMOD_REAL;
      matrix.dtype              = CHOLMOD_DOUBLE;
      matrix.sorted = matrix.packed = 1;
      factor                        = cholmod_l_analyze(&matrix, &common);
      n_entries                     = common.lnz;
      operations                    = common.fl;
    }

    ~Supernodal()
    {
      cholmod_l_free_factor(&factor, &common);
      cholmod_l_finish(&common);
    }

    bool
    factorize()
    {
      return cholmod_l_factorize(&matrix, factor, &common) &&
             common.status == CHOLMOD_OK;
    }

    double n_entries;
    double operations;

  private:
    cholmod_common                common;
    std::vector<SuiteSparse_long> begins, columns;
    std::vector<double>           values;
    cholmod_sparse                matrix;
    cholmod_factor               *factor;
  };



  void
  measure(const SplitMesh<3> &mesh)
  {
    const unsigned int    n       = equations_per_face * mesh.faces.size();
    const auto            coupled = equations(mesh);
    const SparsityPattern pattern = couplings(n, coupled);
    SparseMatrix<double>  matrix(pattern);
    for (unsigned int row = 0; row < matrix.m(); ++row)
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        entry->value() = entry->column() == row ?
                           100. :
                           ((7 * row + 13 * entry->column()) % 11) / 11. - 0.7;
    Supernodal     supernodal(matrix);
    SparseCholesky own(n, coupled);
    const double of_cholmod = seconds([&]() { return supernodal.factorize(); });
    std::vector<std::pair<double *, double>> entries;
    for (unsigned int row = 0; row < n; ++row)
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        entries.emplace_back(&own.entry(row, entry->column()), entry->value());
    const double of_own = seconds([&]() {
      own.clear();
      for (const auto &[address, value] : entries)
        *address = value;
      return own.factorize();
    });
    std::cout << mesh.simplices.size() << ',' << matrix.m() << ','
              << supernodal.n_entries << ',' << supernodal.operations << ','
              << of_cholmod << ',' << of_own << ',' << of_cholmod / of_own
              << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int               n_meshes = argc > 1 ? std::stoi(argv[1]) : 5;

  Triangulation<3> mesh(Triangulation<3>::limit_level_difference_at_vertices);
  GridGenerator::subdivided_hyper_rectangle(mesh,
                                            {4, 4, 4},
                                            {0., 0., -4.},
                                            {4., 4., 0.});
  std::cout << "tetrahedra,equations,entries,operations,seconds_of_cholmod,"
               "seconds_of_own,ratio"
            << std::endl;
  for (unsigned int i = 0; i < n_meshes; ++i)
    {
      measure(make_split_mesh(mesh));
      refine(mesh);
    }
}
