// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <numeric>

#include "bounds/conic/block_batch.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  using namespace LocalAlgebra;

  namespace
  {
    void
    set_lane(AlignedVector<Simd<double>> &lanes,
             const unsigned int           lane,
             const FullMatrix<double>    &matrix)
    {
      for (unsigned int i = 0, k = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          lane_of(lanes[k++], lane) = matrix(i, j);
    }



    bool
    is_zero(const FullMatrix<double> &matrix, const unsigned int row)
    {
      for (unsigned int j = 0; j < matrix.n(); ++j)
        if (matrix(row, j) != 0)
          return false;
      return true;
    }



    BlockBatch::Shape
    shape_of(const ConicBlock         &block,
             const ConicLayout        &layout,
             const unsigned int        b,
             const FullMatrix<double> &null_space)
    {
      BlockBatch::Shape shape = {static_cast<unsigned int>(
                                   block.linear_cost.size()),
                                 static_cast<unsigned int>(block.rows.size()),
                                 static_cast<unsigned int>(null_space.m()),
                                 !block.quadratic_cost.empty(),
                                 {}};
      for (unsigned int c = layout.first_cones[b];
           c < layout.first_cones[b + 1];
           ++c)
        {
          const ConicLayout::Cone &cone = layout.cones[c];
          const bool               has_fixed_radius =
            cone.size > 1 &&
            is_zero(block.cone_matrix, cone.begin - layout.rows[b]);
          shape.cones.push_back({cone.size,
                                 has_fixed_radius ? 1u : 0u,
                                 cone.first_column,
                                 cone.end_column - cone.first_column});
        }
      return shape;
    }
  } // namespace



  // Blocks stay as near to each other as they are in the program.
  std::vector<BlockBatch>
  BlockBatch::make(std::vector<ConicBlock> blocks, const ConicLayout &layout)
  {
    struct Group
    {
      Shape                           shape;
      std::vector<unsigned int>       blocks;
      std::vector<FullMatrix<double>> null_space;
    };
    std::vector<Group>      groups;
    std::vector<BlockBatch> batches;
    const auto              flush = [&](Group &group) {
      if (!group.blocks.empty())
        batches.push_back(BlockBatch(
          blocks, layout, group.shape, group.blocks, group.null_space));
      for (const unsigned int b : group.blocks)
        blocks[b] = ConicBlock(0);
      group.blocks.clear();
      group.null_space.clear();
    };
    for (unsigned int b = 0; b < blocks.size(); ++b)
      {
        const ConicBlock  &block = blocks[b];
        FullMatrix<double> null_space;
        if (block.quadratic_cost.empty())
          null_space = kernel(block.cone_matrix);
        const Shape shape = shape_of(block, layout, b, null_space);
        auto group = std::find_if(groups.begin(), groups.end(), [&](auto &g) {
          return g.shape == shape;
        });
        if (group == groups.end())
          group = groups.insert(group, {shape, {}, {}});
        group->blocks.push_back(b);
        group->null_space.push_back(std::move(null_space));
        if (group->blocks.size() == max_blocks)
          flush(*group);
      }
    std::for_each(groups.begin(), groups.end(), flush);
    return batches;
  }



  BlockBatch::BlockBatch(const std::vector<ConicBlock>         &all_blocks,
                         const ConicLayout                     &layout,
                         const Shape                           &shape,
                         const std::vector<unsigned int>       &blocks,
                         const std::vector<FullMatrix<double>> &null_spaces)
    : shape(shape)
    , n_blocks(blocks.size())
    , n_rows(all_blocks[blocks[0]].cone_offset.size())
    , equations(shape.n_equations)
  {
    const unsigned int n         = shape.n_unknowns;
    unsigned int       n_entries = 0;
    for (const Shape::Cone &cone : shape.cones)
      {
        n_entries += cone.n_rows() * cone.n_columns;
        scalings.emplace_back(cone.size);
      }
    clear(quadratic_cost, shape.has_quadratic_cost ? n * n : 0);
    clear(coupling, shape.n_equations * n);
    clear(cone_columns, n_entries);
    clear(null_space, shape.n_null * n);
    find_parts();
    clear(factor, parts.back().entry + lower_size(parts.back().size()));
    for (unsigned int lane = 0; lane < max_blocks; ++lane)
      {
        const unsigned int i     = lane < n_blocks ? lane : 0;
        const ConicBlock  &block = all_blocks[blocks[i]];
        unknowns[lane]           = layout.unknowns[blocks[i]];
        rows[lane]               = layout.rows[blocks[i]];
        cones[lane]              = layout.first_cones[blocks[i]];
        for (unsigned int k = 0; k < shape.n_equations; ++k)
          equations[k][lane] = block.rows[k];
        set_lane(quadratic_cost, lane, block.quadratic_cost);
        set_lane(coupling, lane, block.coupling);
        set_lane(null_space, lane, null_spaces[i]);
        set_cones(lane, block.cone_matrix);
      }
  }



  void
  BlockBatch::set_cones(const unsigned int        lane,
                        const FullMatrix<double> &cone_matrix)
  {
    unsigned int first_row = 0, entry = 0;
    for (const Shape::Cone &cone : shape.cones)
      {
        for (unsigned int j = 0; j < cone.n_columns; ++j)
          for (unsigned int i = cone.first_row; i < cone.size; ++i)
            lane_of(cone_columns[entry++], lane) =
              cone_matrix(first_row + i, cone.first_column + j);
        first_row += cone.size;
      }
  }



  void
  BlockBatch::set_targets(
    const std::function<double *(const unsigned int, const unsigned int)>
      &target)
  {
    targets.resize(lower_size(shape.n_equations));
    for (unsigned int i = 0; i < shape.n_equations; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        for (unsigned int lane = 0; lane < n_blocks; ++lane)
          targets[lower_size(i) + j][lane] =
            target(std::max(equations[i][lane], equations[j][lane]),
                   std::min(equations[i][lane], equations[j][lane]));
  }



  // Directions that no cone sees have entries in all parts.
  void
  BlockBatch::find_parts()
  {
    const unsigned int n = shape.n_unknowns;
    if (shape.has_quadratic_cost || shape.n_null > 0)
      {
        parts = {{0, n}};
        return;
      }
    std::vector<unsigned int> ends(n);
    std::iota(ends.begin(), ends.end(), 1);
    for (const Shape::Cone &cone : shape.cones)
      ends[cone.first_column] =
        std::max(ends[cone.first_column], cone.first_column + cone.n_columns);
    for (unsigned int i = 0; i < n; ++i)
      {
        if (parts.empty())
          parts.push_back({i, i});
        else if (i == parts.back().end)
          parts.push_back(
            {i, i, parts.back().entry + lower_size(parts.back().size())});
        parts.back().end = std::max(parts.back().end, ends[i]);
      }
  }



  // By B G of each cone with B^T B = W^-2.
  void
  BlockBatch::assemble()
  {
    const unsigned int n = shape.n_unknowns;
    if (shape.has_quadratic_cost)
      for (unsigned int i = 0; i < n; ++i)
        std::copy_n(&quadratic_cost[i * n], i + 1, &factor[lower_size(i)]);
    else
      clear(factor, factor.size());

    Lanes        scaled;
    Simd<double> across = 0.;
    for_each_cone([&](const Shape::Cone &cone,
                      const auto        &scaling,
                      const auto        *columns,
                      const unsigned int) {
      scaled.resize_fast(cone.n_columns * cone.n_rows());
      std::copy_n(columns, scaled.size(), scaled.begin());
      scaling.divide_columns(scaled.begin(), cone.n_columns, cone.first_row);
      const Part &part =
        *std::find_if(parts.begin(), parts.end(), [&](const Part &part) {
          return cone.first_column < part.end;
        });
      add_square(&factor[part.entry],
                 cone.first_column - part.begin,
                 scaled.begin(),
                 cone.n_columns,
                 cone.n_rows());
      if (cone.size > 1)
        across = std::max(across, scaling.inverse_square_across());
    });
    for (const Part &part : parts)
      for (unsigned int i = 0; i < part.size(); ++i)
        factor[part.entry + lower_size(i) + i] *=
          1. + Tolerance::rounding_of_block;
    add_compliance(Tolerance::kernel_compliance * across);
  }



  // Then there is only one part.
  void
  BlockBatch::add_compliance(const Simd<double> &compliance)
  {
    const unsigned int n = shape.n_unknowns;
    for (unsigned int k = 0; k < shape.n_null; ++k)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          factor[lower_size(i) + j] +=
            compliance * null_space[k * n + i] * null_space[k * n + j];
  }



  bool
  BlockBatch::eliminate(const Scalings &all_scalings)
  {
    for (unsigned int c = 0; c < scalings.size(); ++c)
      for (unsigned int lane = 0; lane < max_blocks; ++lane)
        scalings[c].set_lane(lane, all_scalings[cones[lane] + c]);
    assemble();
    Lanes scaled = coupling, square; // A L^-T and A H^-1 A^T
    for (const Part &part : parts)
      {
        if (!factorize(&factor[part.entry], part.size()))
          return false;
        solve_rows(&factor[part.entry],
                   part.size(),
                   scaled.begin() + part.begin,
                   shape.n_equations,
                   shape.n_unknowns);
      }
    clear(square, lower_size(shape.n_equations));
    add_square(
      square.begin(), 0, scaled.begin(), shape.n_equations, shape.n_unknowns);
    for (unsigned int lane = 0; lane < n_blocks; ++lane)
      for (unsigned int i = 0; i < square.size(); ++i)
        *targets[i][lane] += lane_of(square[i], lane);
    return true;
  }
} // namespace ElastoPlastic
