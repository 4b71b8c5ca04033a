// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "adaptivity/ties.h"
#include "base/compatibility.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How many cells may tie, if nothing tells where these end: a cell of a
    /// cube has 47 images, and a tenth more changes no large mesh much.
    std::size_t
    max_ties(const std::uint64_t n_refined)
    {
      return std::max<std::size_t>(48, n_refined / 10);
    }



    /// The @p n largest values of all ranks, the largest first.
    std::vector<float>
    largest_of_all(std::vector<float> own,
                   const std::size_t  n,
                   const MPI_Comm     communicator)
    {
      const auto keep_largest = [n](std::vector<float> &values) {
        const auto end = values.begin() + std::min(n, values.size());
        std::partial_sort(values.begin(), end, values.end(), std::greater<>());
        values.erase(end, values.end());
      };
      keep_largest(own);
      std::vector<float> all;
      for (const auto &of_rank : Utilities::MPI::all_gather(communicator, own))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      keep_largest(all);
      return all;
    }
  } // namespace



  std::size_t
  n_ties(const float               last,
         const std::vector<float> &candidates,
         const std::size_t         n_at_most,
         const double              accuracy)
  {
    std::size_t before_widest = 0;
    double      widest        = 0.;
    for (std::size_t n = 0; n < candidates.size() && n <= n_at_most; ++n)
      {
        const double a    = n > 0 ? candidates[n - 1] : last;
        const double b    = candidates[n];
        const double jump = std::abs(a - b);
        const double size = std::max(std::abs(a), std::abs(b));
        if (jump > accuracy * size)
          return n;
        if (jump > widest * size)
          {
            widest        = jump / size;
            before_widest = n;
          }
      }
    return candidates.size() <= n_at_most ? candidates.size() : before_widest;
  }



  template <int dim>
  void
  flag_ties(const std::uint64_t                        n_wanted,
            const Vector<float>                       &error_indicators,
            const double                               accuracy,
            parallel::distributed::Triangulation<dim> &triangulation)
  {
    const MPI_Comm communicator = communicator_of(triangulation);
    const auto     error        = [&](const auto &cell) {
      return error_indicators[cell->active_cell_index()];
    };
    const float rounding =
      std::numeric_limits<float>::epsilon() *
      Utilities::MPI::max(error_indicators.size() > 0 ?
                            error_indicators.linfty_norm() :
                            0.f,
                          communicator);
    std::uint64_t      n_flagged = 0;
    float              last      = std::numeric_limits<float>::max();
    std::vector<float> others;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          if (error(cell) <= rounding)
            cell->clear_refine_flag();
          else if (cell->refine_flag_set())
            {
              ++n_flagged;
              last = std::min(last, error(cell));
            }
          else
            others.push_back(error(cell));
        }
    n_flagged = Utilities::MPI::sum(n_flagged, communicator);
    last      = Utilities::MPI::min(last, communicator);

    const std::size_t missing   = std::max(n_wanted, n_flagged) - n_flagged;
    const std::size_t n_at_most = max_ties(n_flagged + missing);
    others =
      largest_of_all(std::move(others), missing + n_at_most + 1, communicator);
    const auto first_candidate =
      others.begin() + std::min(missing, others.size());
    if (first_candidate != others.begin())
      last = first_candidate[-1];
    const std::vector<float> candidates(first_candidate, others.end());
    if (const std::size_t n = n_ties(last, candidates, n_at_most, accuracy);
        n > 0)
      last = candidates[n - 1];
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && error(cell) >= last)
        {
          cell->clear_coarsen_flag();
          cell->set_refine_flag();
        }
  }



  template void
  flag_ties(const std::uint64_t,
            const Vector<float> &,
            const double,
            parallel::distributed::Triangulation<2> &);
  template void
  flag_ties(const std::uint64_t,
            const Vector<float> &,
            const double,
            parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
