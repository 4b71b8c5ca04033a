// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef adaptivity_ties_h
#define adaptivity_ties_h

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Cells that mirror each other have the same error, but for rounding: where
  /// some of them are to be refined, the others are to be refined, too, or the
  /// mesh would depend on the last digits of the solution. Flags the cells with
  /// the largest positive errors until there are @p n_wanted, which deal.II has
  /// flagged as well as its bisection can tell them apart, and those that tie
  /// with the last one: up to the first jump of the errors by more than
  /// @p accuracy, which is relative. Collective.
  template <int dim>
  void
  flag_ties(const std::uint64_t                        n_wanted,
            const Vector<float>                       &error_indicators,
            const double                               accuracy,
            parallel::distributed::Triangulation<dim> &triangulation);



  /// @return how many of @p candidates, which are sorted, tie with the @p last
  /// cell before them. If there is no jump before @p n_at_most of them, those
  /// before the widest difference; they are all there are if they are not more.
  std::size_t
  n_ties(const float               last,
         const std::vector<float> &candidates,
         const std::size_t         n_at_most,
         const double              accuracy);
} // namespace ElastoPlastic

#endif
