// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "adaptivity/ties.h"
#include "base/compatibility.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of how many cells, beyond those flagged, ties are looked for: a cell has
    /// seven images in three planes, and a twentieth changes no mesh much.
    std::size_t
    n_candidates(const std::size_t n_flagged)
    {
      return std::max<std::size_t>(8, n_flagged / 20);
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



    /// What is flagged is what has the largest @p sign times indicator.
    template <int dim, typename IsFlagged, typename Flag>
    void
    flag_ties_of(const float                                sign,
                 const IsFlagged                           &is_flagged,
                 const Flag                                &flag,
                 const Vector<float>                       &indicators,
                 const double                               accuracy,
                 parallel::distributed::Triangulation<dim> &triangulation)
    {
      const MPI_Comm communicator = communicator_of(triangulation);
      const auto     value        = [&](const auto &cell) {
        return sign * indicators[cell->active_cell_index()];
      };
      const auto is_candidate = [](const auto &cell) {
        return cell->is_locally_owned() && !cell->refine_flag_set() &&
               !cell->coarsen_flag_set();
      };

      std::size_t        n_flagged = 0;
      float              last      = std::numeric_limits<float>::max();
      std::vector<float> candidates;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (is_candidate(cell))
          candidates.push_back(value(cell));
        else if (cell->is_locally_owned() && is_flagged(cell))
          {
            ++n_flagged;
            last = std::min(last, value(cell));
          }
      n_flagged = Utilities::MPI::sum(n_flagged, communicator);
      last      = Utilities::MPI::min(last, communicator);
      if (n_flagged == 0)
        return;

      candidates          = largest_of_all(std::move(candidates),
                                  n_candidates(n_flagged),
                                  communicator);
      const std::size_t n = n_ties(last, candidates, accuracy);
      if (n > 0)
        for (const auto &cell : triangulation.active_cell_iterators())
          if (is_candidate(cell) && value(cell) >= candidates[n - 1])
            flag(cell);
    }
  } // namespace



  std::size_t
  n_ties(const float               last,
         const std::vector<float> &candidates,
         const double              accuracy)
  {
    std::size_t before_widest = 0;
    double      widest        = 0.;
    for (std::size_t n = 0; n < candidates.size(); ++n)
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
    return before_widest;
  }



  template <int dim>
  void
  flag_ties(const Vector<float>                       &error_indicators,
            const double                               accuracy,
            parallel::distributed::Triangulation<dim> &triangulation)
  {
    flag_ties_of(
      1.f,
      [](const auto &cell) { return cell->refine_flag_set(); },
      [](const auto &cell) { cell->set_refine_flag(); },
      error_indicators,
      accuracy,
      triangulation);
    flag_ties_of(
      -1.f,
      [](const auto &cell) { return cell->coarsen_flag_set(); },
      [](const auto &cell) { cell->set_coarsen_flag(); },
      error_indicators,
      accuracy,
      triangulation);
  }



  template void
  flag_ties(const Vector<float> &,
            const double,
            parallel::distributed::Triangulation<2> &);
  template void
  flag_ties(const Vector<float> &,
            const double,
            parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
