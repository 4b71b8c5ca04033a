// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_dissipation_block_h
#define bounds_conic_dissipation_block_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "bounds/conic/conic_program.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a triangle contributes to the minimisation of plastic work, a sum of
  /// norms under conditions, as a block of its dual, a ConicProgram:
  ///   limit |w e| = max { x . w e : |x| <= limit }.
  /// The unknowns x are stresses, and forces x >= 0 for the conditions; the
  /// equations say that their power vanishes for all velocities. Rates e are
  /// given by matrices with a column for each local function of the velocity,
  /// or for the first of them. Velocities are the multipliers of the equations
  /// with the opposite sign.
  class DissipationBlock
  {
  public:
    explicit DissipationBlock(const unsigned int n_functions);

    /// Adds limit |w (e - e_0)|: the components of e are @p n_rows of @p rates
    /// from @p begin on, w is the @p weight. All components of e_0 are @p
    /// offset.
    void
    add_norm(const FullMatrix<double> &rates,
             const unsigned int        begin,
             const unsigned int        n_rows,
             const double              weight,
             const double              limit,
             const double              offset = 0.);

    /// Adds the condition that a @p row of @p rates is @p bound at most.
    void
    add_condition(const FullMatrix<double> &rates,
                  const unsigned int        row,
                  const double              weight,
                  const double              bound);

    /// The block, with the equations of the local functions, which may
    /// share some; invalid_unsigned_int for functions that vanish.
    ConicBlock
    make(const std::vector<unsigned int> &equations) const;

  private:
    void
    add_unknown(const FullMatrix<double> &rates,
                const unsigned int        row,
                const double              weight,
                const double              cost);

    void
    add_cones(ConicBlock &block) const;

    struct Cone
    {
      unsigned int n_components; ///< 0: of a condition
      double       limit;
    };

    const unsigned int               n_functions;
    std::vector<std::vector<double>> powers; ///< by unknowns
    std::vector<double>              costs;  ///< by unknowns
    std::vector<Cone>                cones;
  };
} // namespace ElastoPlastic

#endif
