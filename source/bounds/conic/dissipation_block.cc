// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <map>

#include "bounds/conic/dissipation_block.h"

namespace ElastoPlastic
{
  DissipationBlock::DissipationBlock(const unsigned int n_functions)
    : n_functions(n_functions)
  {}



  void
  DissipationBlock::add_norm(const FullMatrix<double> &rates,
                             const unsigned int        begin,
                             const unsigned int        n_rows,
                             const double              weight,
                             const double              limit,
                             const double              offset)
  {
    for (unsigned int i = begin; i < begin + n_rows; ++i)
      add_unknown(rates, i, weight, weight * offset);
    cones.push_back({n_rows, limit});
  }



  void
  DissipationBlock::add_condition(const FullMatrix<double> &rates,
                                  const unsigned int        row,
                                  const double              weight,
                                  const double              bound)
  {
    add_unknown(rates, row, weight, weight * bound);
    cones.push_back({0, 0.});
  }



  void
  DissipationBlock::add_unknown(const FullMatrix<double> &rates,
                                const unsigned int        row,
                                const double              weight,
                                const double              cost)
  {
    std::vector<double> &power = powers.emplace_back(n_functions);
    for (unsigned int f = 0; f < rates.n(); ++f)
      power[f] = weight * rates(row, f);
    costs.push_back(cost);
  }



  ConicBlock
  DissipationBlock::make(const std::vector<unsigned int> &equations) const
  {
    ConicBlock block(costs.size());
    std::copy(costs.begin(), costs.end(), block.linear_cost.begin());
    add_cones(block);

    std::map<unsigned int, Vector<double>> rows;
    for (unsigned int f = 0; f < n_functions; ++f)
      if (equations[f] != numbers::invalid_unsigned_int)
        {
          auto &row =
            rows.try_emplace(equations[f], costs.size()).first->second;
          for (unsigned int i = 0; i < costs.size(); ++i)
            row[i] += powers[i][f];
        }
    for (const auto &[equation, row] : rows)
      block.add_to_equation(equation, row);
    return block;
  }



  // (limit, x) or x itself
  void
  DissipationBlock::add_cones(ConicBlock &block) const
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
} // namespace ElastoPlastic
