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
  /// mesh would depend on the last digits of the solution. deal.II has flagged
  /// about @p n_wanted cells, as its bisection of the errors could tell them
  /// apart. Flags those with the largest errors that are still wanted, but none
  /// whose error is rounding of the largest; and those that tie with the last
  /// one: up to the first jump of the errors by more than @p accuracy, which is
  /// relative. Cells with equal errors are never told apart. Collective.
  template <int dim>
  void
  flag_ties(const std::uint64_t                        n_wanted,
            const Vector<float>                       &error_indicators,
            const double                               accuracy,
            parallel::distributed::Triangulation<dim> &triangulation);



  /// @return how many of @p candidates, sorted errors, tie with the @p last one
  /// before them: those before the first jump. Without a jump, they are all if
  /// they are not more than @p n_at_most, else those before the widest
  /// difference.
  std::size_t
  n_ties(const float               last,
         const std::vector<float> &candidates,
         const std::size_t         n_at_most,
         const double              accuracy);
} // namespace ElastoPlastic

#endif
