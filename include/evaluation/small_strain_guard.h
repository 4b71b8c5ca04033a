// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_small_strain_guard_h
#define evaluation_small_strain_guard_h

#include <set>
#include <string>

#include "evaluation/nominal_contact.h"
#include "evaluation/solve_result.h"

namespace ElastoPlastic
{
  /// Tells when a run leaves the theory of small strains (doc/trust,
  /// "Small strains or not"): by the largest equivalent plastic strain, by
  /// the slope of the indenter at the edge of the contact, which is that of the
  /// surface there, or, if it is flat, by its depth over the contact radius. In
  /// plane problems, where a depth depends on the size of the body, there is no
  /// such ratio; nor is there an edge under an indenter without a single tip.
  template <int dim>
  class SmallStrainGuard
  {
  public:
    /// Beyond these values there is a warning.
    static constexpr double largest_plastic_strain = 0.1;
    static constexpr double largest_slope          = 0.25;
    static constexpr double largest_relative_depth = 0.2;

    explicit SmallStrainGuard(const NominalContact<dim> &contact);

    /// A warning about the @p result of a load step: what is beyond its limit
    /// and was not when this function has been called before. Empty if there is
    /// nothing to say.
    std::string
    warning(const SolveResult &result);

  private:
    /// Adds to @p text that @p what is @p value if that is beyond @p limit for
    /// the first time.
    void
    compare(const std::string &what,
            const double       value,
            const double       limit,
            std::string       &text);

    const NominalContact<dim> contact;
    std::set<std::string>     exceeded;
  };
} // namespace ElastoPlastic

#endif
