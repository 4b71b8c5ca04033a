// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/container/small_vector.hpp>

#include <algorithm>

#include "equilibrium/kkt_system.h"

// What KktSystem does with single blocks.

namespace ElastoPlastic
{
  using namespace LocalAlgebra;

  namespace
  {
    /// The compliance of a block in the directions that no cone sees, relative
    /// to the largest eigenvalue of its W^-2 across the directions of s and z;
    /// those along them tend to zero and infinity in the course of the
    /// iteration. With 1e-4, repeated solving leaves a divergence of 1e-8 of
    /// the rate of strain.
    constexpr double kernel_compliance = 1e-7;

    /// What is added to the diagonals of a block, relative to each entry: more
    /// than the rounding errors of its Cholesky factorisation.
    constexpr double relative_rounding = 1e-14;

    using LocalVector = boost::container::small_vector<double, 32>;



    /// H += G^T W^-2 G for one cone, whose rows of G begin with @p first_row.
    /// Only the lower half of H is needed.
    void
    add_cone(FullMatrix<double>             &h,
             const FullMatrix<double>       &cone_matrix,
             const unsigned int              first_row,
             const ConicLayout::Cone        &cone,
             const SecondOrderCone::Scaling &scaling)
    {
      const unsigned int first = cone.first_column,
                         n     = cone.end_column - cone.first_column;
      LocalVector scaled(n);
      for (unsigned int i = 0; i < cone.size; ++i)
        {
          std::fill(scaled.begin(), scaled.end(), 0.);
          for (unsigned int k = 0; k < cone.size; ++k)
            {
              const double        entry = scaling.inverse_square(i, k);
              const double *const row = &cone_matrix(first_row + k, 0) + first;
              for (unsigned int j = 0; j < n; ++j)
                scaled[j] += entry * row[j];
            }
          for (unsigned int row = 0; row < n; ++row)
            if (const double factor = cone_matrix(first_row + i, first + row);
                factor != 0)
              for (unsigned int column = 0; column <= row; ++column)
                h(first + row, first + column) += factor * scaled[column];
        }
    }
  } // namespace



  void
  KktSystem::find_kernels()
  {
    kernels.resize(program.blocks.size());
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      if (program.blocks[b].quadratic_cost.empty())
        kernels[b] = kernel(program.blocks[b].cone_matrix);
  }



  // Cones that see the same unknowns make a strip.
  void
  KktSystem::find_strips()
  {
    strips.resize(program.blocks.size());
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      for (unsigned int c = layout.first_cones[b];
           c < layout.first_cones[b + 1];
           ++c)
        {
          const auto &cone  = layout.cones[c];
          const Part  rows  = {cone.begin - layout.rows[b],
                               cone.begin - layout.rows[b] + cone.size};
          auto       &strip = strips[b];
          if (!strip.empty() &&
              strip.back().columns.begin == cone.first_column &&
              strip.back().columns.end == cone.end_column)
            strip.back().rows.end = rows.end;
          else
            strip.push_back({rows, {cone.first_column, cone.end_column}});
        }
  }



  // The columns of a strip join what they meet.
  void
  KktSystem::find_parts()
  {
    parts.resize(program.blocks.size());
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const unsigned int n = program.blocks[b].linear_cost.size();
        std::vector<bool>  begins_part(n, true);
        const auto         join = [&](const Part &part) {
          for (unsigned int j = part.begin + 1; j < part.end; ++j)
            begins_part[j] = false;
        };
        if (!program.blocks[b].quadratic_cost.empty() || kernels[b].m() > 0)
          join({0, n});
        for (const Strip &strip : strips[b])
          join(strip.columns);
        for (unsigned int j = 0; j < n; ++j)
          if (begins_part[j])
            parts[b].push_back({j, j + 1});
          else
            parts[b].back().end = j + 1;
      }
  }



  bool
  KktSystem::eliminate(const unsigned int b)
  {
    const ConicBlock   &block = program.blocks[b];
    const unsigned int  n     = block.linear_cost.size();
    FullMatrix<double> &h     = local_factors[b];
    if (block.quadratic_cost.empty())
      h.reinit(n, n);
    else
      h = block.quadratic_cost;

    double across = 0;
    for (unsigned int c = layout.first_cones[b]; c < layout.first_cones[b + 1];
         ++c)
      {
        const ConicLayout::Cone &cone    = layout.cones[c];
        const auto              &scaling = (*scalings)[c];
        add_cone(
          h, block.cone_matrix, cone.begin - layout.rows[b], cone, scaling);
        if (cone.size > 1)
          across = std::max(across, scaling.inverse_square_across());
      }
    for (unsigned int i = 0; i < h.m(); ++i)
      h(i, i) *= 1. + relative_rounding;
    const FullMatrix<double> &directions = kernels[b];
    for (unsigned int k = 0; k < directions.m(); ++k)
      for (unsigned int i = 0; i < h.m(); ++i)
        for (unsigned int j = 0; j <= i; ++j)
          h(i, j) +=
            kernel_compliance * across * directions(k, i) * directions(k, j);
    // A H^-1 A^T
    FullMatrix<double> &coupling = local_couplings[b];
    coupling                     = block.coupling;
    for (const Part &part : parts[b])
      {
        if (!LocalAlgebra::factorize(h, part))
          return false;
        solve_lower(h, part, &coupling(0, 0), coupling.m());
      }
    FullMatrix<double> contribution(coupling.m(), coupling.m());
    for (unsigned int i = 0; i < coupling.m(); ++i)
      add_product(
        &contribution(i, 0), coupling, {0, i + 1}, {0, n}, &coupling(i, 0), 1.);
    add_to_matrix(block.rows, contribution);
    return true;
  }



  void
  KktSystem::add_to_matrix(const std::vector<unsigned int> &rows,
                           const FullMatrix<double>        &contribution)
  {
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          const auto [lower, upper] = std::minmax(rows[i], rows[j]);
          const double entry        = contribution(i, j);
          if (upper < n_sparse_rows)
            matrix.add(upper, lower, entry);
          else if (lower < n_sparse_rows)
            dense_rows[upper - n_sparse_rows][lower] += entry;
          else
            {
              dense_inverse(upper - n_sparse_rows, lower - n_sparse_rows) +=
                entry;
              if (lower != upper)
                dense_inverse(lower - n_sparse_rows, upper - n_sparse_rows) +=
                  entry;
            }
        }
  }



  void
  KktSystem::add_cone_product(double            *z,
                              const unsigned int b,
                              const double      *x,
                              const double       factor) const
  {
    for (const auto &[rows, columns] : strips[b])
      add_product(z + rows.begin,
                  program.blocks[b].cone_matrix,
                  rows,
                  columns,
                  x + columns.begin,
                  factor);
  }



  void
  KktSystem::add_transposed_cone_product(double            *x,
                                         const unsigned int b,
                                         const double      *z,
                                         const double       factor) const
  {
    for (const auto &[rows, columns] : strips[b])
      add_transposed_product(x + columns.begin,
                             program.blocks[b].cone_matrix,
                             rows,
                             columns,
                             z + rows.begin,
                             factor);
  }
} // namespace ElastoPlastic
