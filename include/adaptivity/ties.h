// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef adaptivity_ties_h
#define adaptivity_ties_h

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Cells that mirror each other have the same error, but for rounding: where
  /// some of them are flagged for refinement or coarsening, the others are
  /// flagged, too, or the mesh would depend on the last digits of the solution.
  /// From the last cell that is flagged, goes on to the first jump of the
  /// indicators by more than @p accuracy, which is relative. Collective.
  template <int dim>
  void
  flag_ties(const Vector<float>                       &error_indicators,
            const double                               accuracy,
            parallel::distributed::Triangulation<dim> &triangulation);



  /// @return how many of @p candidates, which are sorted, tie with the @p last
  /// one that is flagged: those before the first relative jump by more than
  /// @p accuracy or, if there is none, before the widest one.
  std::size_t
  n_ties(const float               last,
         const std::vector<float> &candidates,
         const double              accuracy);
} // namespace ElastoPlastic

#endif
