// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <numeric>

#include "bounds/conic/conic_program.h"
#include "bounds/conic/local_algebra.h"

namespace ElastoPlastic
{
  namespace
  {
    /// That is expected, relative to the mean. (1 to 10 need as many
    /// iterations; 0.3 and 30 need more.)
    constexpr double smallest_multiplier = 3.;



    void
    append_row(FullMatrix<double> &matrix, const Vector<double> &row)
    {
      FullMatrix<double> longer(matrix.m() + 1, row.size());
      if (!matrix.empty())
        longer.fill(matrix);
      std::copy(row.begin(), row.end(), &longer(matrix.m(), 0));
      matrix = longer;
    }



    /// From the first to behind the last column with entries in some rows.
    std::pair<unsigned int, unsigned int>
    columns_of(const FullMatrix<double> &matrix,
               const unsigned int        first_row,
               const unsigned int        n_rows)
    {
      unsigned int first = matrix.n(), end = 0;
      for (unsigned int i = first_row; i < first_row + n_rows; ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          if (matrix(i, j) != 0)
            {
              first = std::min(first, j);
              end   = std::max(end, j + 1);
            }
      return {std::min(first, end), end};
    }
  } // namespace



  void
  ConicBlock::add_to_equation(const unsigned int    equation,
                              const Vector<double> &row)
  {
    append_row(coupling, row);
    rows.push_back(equation);
  }



  void
  ConicBlock::add_inequality(const Vector<double> &row)
  {
    append_row(cone_matrix, row);
    cone_offset.grow_or_shrink(cone_offset.size() + 1);
    cone_sizes.push_back(1);
    cone_scales.emplace_back();
  }



  void
  ConicProgram::expect_multipliers(const std::vector<double> &of_blocks)
  {
    const double smallest =
      smallest_multiplier *
      std::accumulate(of_blocks.begin(), of_blocks.end(), 0.) /
      of_blocks.size();
    if (!(smallest > 0.)) // nor if there are none
      return;
    Assert(of_blocks.size() <= blocks.size(), ExcInternalError());
    expected_multipliers.assign(blocks.size(), smallest);
    for (unsigned int b = 0; b < of_blocks.size(); ++b)
      expected_multipliers[b] += std::max(0., of_blocks[b]);
  }



  ConicLayout::ConicLayout(const ConicProgram &program)
    : unknowns(1, 0)
    , rows(1, 0)
    , first_cones(1, 0)
  {
    for (const ConicBlock &block : program.blocks)
      {
        unsigned int begin = rows.back();
        for (const unsigned int size : block.cone_sizes)
          {
            const auto [first, end] =
              columns_of(block.cone_matrix, begin - rows.back(), size);
            cones.push_back({begin, size, first, end});
            begin += size;
          }
        AssertDimension(block.cone_scales.size(), block.cone_sizes.size());
        scales.insert(scales.end(),
                      block.cone_scales.begin(),
                      block.cone_scales.end());
        unknowns.push_back(unknowns.back() + block.linear_cost.size());
        rows.push_back(begin);
        first_cones.push_back(cones.size());
      }
    linear_cost.reinit(unknowns.back());
    cone_offset.reinit(rows.back());
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock &block = program.blocks[b];
        std::copy(block.linear_cost.begin(),
                  block.linear_cost.end(),
                  linear_cost.begin() + unknowns[b]);
        std::copy(block.cone_offset.begin(),
                  block.cone_offset.end(),
                  cone_offset.begin() + rows[b]);
      }
  }
} // namespace ElastoPlastic
