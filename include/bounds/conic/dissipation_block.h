// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_dissipation_block_h
#define bounds_conic_dissipation_block_h

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <map>
#include <vector>

#include "bounds/conic/conic_program.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a simplex or a face contributes to the minimisation of plastic work,
  /// a sum of norms under conditions, as a block of its dual, a ConicProgram:
  ///   limit |w e| = max { x . w e : |x| <= limit }.
  /// The unknowns x are stresses, and forces x >= 0 for the conditions; the
  /// equations say that their power vanishes for all velocities. Rates e are
  /// given by matrices with a column for each local function of the velocity.
  /// Velocities are the multipliers of the equations with the opposite sign.
  class DissipationBlock
  {
  public:
    explicit DissipationBlock(const unsigned int n_functions)
      : n_functions(n_functions)
    {}

    /// Whether nothing has been added.
    bool
    empty() const
    {
      return costs.empty();
    }

    /// Adds limit |w e|: the components of e are @p n_rows of @p rates from
    /// @p begin on, w is the @p weight.
    void
    add_norm(const FullMatrix<double> &rates,
             const unsigned int        begin,
             const unsigned int        n_rows,
             const double              weight,
             const double              limit)
    {
      for (unsigned int i = begin; i < begin + n_rows; ++i)
        add_unknown(rates, i, weight, 0.);
      cones.push_back({n_rows, limit});
    }

    /// Adds the condition that a @p row of @p rates is @p bound at most.
    void
    add_condition(const FullMatrix<double> &rates,
                  const unsigned int        row,
                  const double              weight,
                  const double              bound)
    {
      add_unknown(rates, row, weight, weight * bound);
      cones.push_back({0, 0.});
    }

    /// Adds the condition that a @p row of @p rates is zero. Must come last.
    void
    require_zero(const FullMatrix<double> &rates,
                 const unsigned int        row,
                 const double              weight)
    {
      add_unknown(rates, row, weight, 0.);
    }

    /// The block, with the equations of the local functions, which may
    /// share some; invalid_unsigned_int for functions that vanish. Those
    /// without any power are left out.
    ConicBlock
    make(const std::vector<unsigned int> &equations) const
    {
      ConicBlock block(costs.size());
      std::copy(costs.begin(), costs.end(), block.linear_cost.begin());
      add_cones(block);

      std::map<unsigned int, Vector<double>> rows;
      double                                 largest = 0;
      for (unsigned int f = 0; f < n_functions; ++f)
        if (equations[f] != numbers::invalid_unsigned_int)
          {
            auto &row =
              rows.try_emplace(equations[f], costs.size()).first->second;
            for (unsigned int i = 0; i < costs.size(); ++i)
              row[i] += powers[i][f];
            largest = std::max(largest, row.linfty_norm());
          }
      for (const auto &[equation, row] : rows)
        if (row.linfty_norm() > Tolerance::power * largest)
          block.add_to_equation(equation, row);
      return block;
    }

  private:
    void
    add_unknown(const FullMatrix<double> &rates,
                const unsigned int        row,
                const double              weight,
                const double              cost)
    {
      std::vector<double> &power = powers.emplace_back(n_functions);
      for (unsigned int f = 0; f < rates.n(); ++f)
        power[f] = weight * rates(row, f);
      costs.push_back(cost);
    }

    // (limit, x) or x itself
    void
    add_cones(ConicBlock &block) const
    {
      unsigned int n_rows = 0, row = 0, unknown = 0;
      for (const Cone &cone : cones)
        n_rows += 1 + cone.n_components;
      block.cone_matrix.reinit(n_rows, costs.size());
      block.cone_offset.reinit(n_rows);
      block.cone_scales.resize(cones.size());
      for (const auto &[n_components, limit] : cones)
        {
          block.cone_sizes.push_back(1 + n_components);
          if (n_components > 0)
            block.cone_offset[row++] = limit;
          for (unsigned int c = 0; c < std::max(1u, n_components); ++c)
            block.cone_matrix(row++, unknown++) = -1.;
        }
    }

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
