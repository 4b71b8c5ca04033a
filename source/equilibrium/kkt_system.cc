// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "equilibrium/kkt_system.h"
#include "equilibrium/local_algebra.h"

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

    /// What is added to the diagonal of the sum of all blocks, relative to each
    /// entry, one after the other until it can be factorised.
    constexpr std::array<double, 4> sum_roundings = {{0., 1e-14, 1e-12, 1e-10}};

    /// Solves are repeated so often at most, while each halves the residual,
    /// and until it is that small.
    constexpr unsigned int max_repetitions   = 12;
    constexpr double       relative_residual = 1e-11;

    using LocalVector = boost::container::small_vector<double, 32>;



    /// equations += factor A x, where A is the coupling to these @p rows.
    void
    add_to_equations(Vector<double>                  &equations,
                     const std::vector<unsigned int> &rows,
                     const FullMatrix<double>        &coupling,
                     const double                    *x,
                     const double                     factor)
    {
      LocalVector local(rows.size(), 0.);
      add_product(local.data(), coupling, x, factor);
      for (unsigned int i = 0; i < rows.size(); ++i)
        equations[rows[i]] += local[i];
    }



    /// x += factor A^T equations
    void
    add_from_equations(double                          *x,
                       const std::vector<unsigned int> &rows,
                       const FullMatrix<double>        &coupling,
                       const Vector<double>            &equations,
                       const double                     factor)
    {
      LocalVector local(rows.size());
      for (unsigned int i = 0; i < rows.size(); ++i)
        local[i] = equations[rows[i]];
      add_transposed_product(x, coupling, local.data(), factor);
    }



    /// H += G^T W^-2 G for one cone: the @p size rows of G from @p begin on.
    /// Only the lower half of H is needed.
    void
    add_cone(FullMatrix<double>             &h,
             const FullMatrix<double>       &cone_matrix,
             const unsigned int              begin,
             const unsigned int              size,
             const SecondOrderCone::Scaling &scaling)
    {
      const unsigned int n = h.n();
      LocalVector        scaled(n);
      for (unsigned int i = 0; i < size; ++i)
        {
          std::fill(scaled.begin(), scaled.end(), 0.);
          for (unsigned int k = 0; k < size; ++k)
            {
              const double        entry = scaling.inverse_square(i, k);
              const double *const row   = &cone_matrix(begin + k, 0);
              for (unsigned int j = 0; j < n; ++j)
                scaled[j] += entry * row[j];
            }
          for (unsigned int row = 0; row < n; ++row)
            if (const double factor = cone_matrix(begin + i, row); factor != 0)
              for (unsigned int column = 0; column <= row; ++column)
                h(row, column) += factor * scaled[column];
        }
    }



    double
    square(const KktVector &v)
    {
      return v.x.norm_sqr() + v.y.norm_sqr() + v.z.norm_sqr() +
             v.load_factor * v.load_factor;
    }
  } // namespace



  KktSystem::KktSystem(const ConicProgram &program, const ConicLayout &layout)
    : program(program)
    , layout(layout)
    , n_sparse_rows(program.right_hand_side.size() - program.n_dense_rows)
    , local_factors(program.blocks.size())
    , local_couplings(program.blocks.size())
    , dense_rows(program.n_dense_rows, Vector<double>(n_sparse_rows))
    , dense_solutions(dense_rows)
    , dense_inverse(program.n_dense_rows, program.n_dense_rows)
  {
    DynamicSparsityPattern couplings(n_sparse_rows, n_sparse_rows);
    for (const ConicBlock &block : program.blocks)
      for (const unsigned int i : block.rows)
        for (const unsigned int j : block.rows)
          if (i < n_sparse_rows && j < n_sparse_rows)
            couplings.add(i, j);
    sparsity_pattern.copy_from(couplings);
    matrix.reinit(sparsity_pattern);
    sparse_factor = std::make_unique<SparseCholesky>(sparsity_pattern);
    find_kernels();
  }



  void
  KktSystem::find_kernels()
  {
    kernels.resize(program.blocks.size());
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      if (program.blocks[b].quadratic_cost.linfty_norm() == 0)
        kernels[b] = kernel(program.blocks[b].cone_matrix);
  }



  bool
  KktSystem::factorize(const Scalings &new_scalings)
  {
    scalings      = &new_scalings;
    matrix        = 0.;
    dense_inverse = 0.;
    for (Vector<double> &row : dense_rows)
      row = 0.;

    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      if (!eliminate(b))
        return false;
    if (!factorize_sum())
      return false;

    for (unsigned int i = 0; i < dense_rows.size(); ++i)
      {
        sparse_factor->vmult(dense_solutions[i], dense_rows[i]);
        for (unsigned int j = 0; j < dense_rows.size(); ++j)
          dense_inverse(j, i) -= dense_rows[j] * dense_solutions[i];
      }
    if (!dense_rows.empty())
      dense_inverse.gauss_jordan();
    growth_solution = program.growth;
    if (program.growth.size() > 0)
      solve_sparse_and_dense(growth_solution);
    return true;
  }



  bool
  KktSystem::factorize_sum()
  {
    double added = 0;
    for (const double rounding : sum_roundings)
      {
        for (unsigned int i = 0; i < n_sparse_rows; ++i)
          matrix.diag_element(i) *= 1. + rounding - added;
        added = rounding;
        if (sparse_factor->factorize(matrix))
          return true;
      }
    return false;
  }



  bool
  KktSystem::eliminate(const unsigned int b)
  {
    const ConicBlock   &block = program.blocks[b];
    FullMatrix<double> &h     = local_factors[b];
    h                         = block.quadratic_cost;

    double across = 0;
    for (unsigned int c = layout.first_cones[b]; c < layout.first_cones[b + 1];
         ++c)
      {
        const auto [begin, size] = layout.cones[c];
        const auto &scaling      = (*scalings)[c];
        add_cone(h, block.cone_matrix, begin - layout.rows[b], size, scaling);
        if (size > 1)
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
    if (!LocalAlgebra::factorize(h))
      return false;

    // A H^-1 A^T
    FullMatrix<double> &coupling = local_couplings[b];
    coupling                     = block.coupling;
    solve_lower(h, &coupling(0, 0), coupling.m());
    FullMatrix<double> contribution(coupling.m(), coupling.m());
    for (unsigned int i = 0; i < coupling.m(); ++i)
      add_product(&contribution(i, 0), coupling, &coupling(i, 0));
    add_to_matrix(block.rows, contribution);
    return true;
  }



  void
  KktSystem::add_to_matrix(const std::vector<unsigned int> &rows,
                           const FullMatrix<double>        &contribution)
  {
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < rows.size(); ++j)
        if (rows[i] < n_sparse_rows)
          {
            if (rows[j] <= rows[i])
              matrix.add(rows[i], rows[j], contribution(i, j));
          }
        else if (rows[j] < n_sparse_rows)
          dense_rows[rows[i] - n_sparse_rows][rows[j]] += contribution(i, j);
        else
          dense_inverse(rows[i] - n_sparse_rows, rows[j] - n_sparse_rows) +=
            contribution(i, j);
  }



  void
  KktSystem::solve(KktVector &solution, const KktVector &right_hand_side) const
  {
    solve_once(solution, right_hand_side);

    KktVector    residual, correction;
    const double small =
      relative_residual * relative_residual * square(right_hand_side);
    double last = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < max_repetitions; ++k)
      {
        residual = right_hand_side;
        subtract_product(residual, solution);
        for (unsigned int c = 0; c < layout.cones.size(); ++c)
          {
            const auto [begin, size] = layout.cones[c];
            (*scalings)[c].add_square(
              SecondOrderCone::View(&residual.z[begin], size),
              SecondOrderCone::ConstView(&solution.z[begin], size));
          }
        const double remainder = square(residual);
        if (remainder > 0.25 * last || remainder < small)
          break;
        last = remainder;
        solve_once(correction, residual);
        solution.x += correction.x;
        solution.y += correction.y;
        solution.z += correction.z;
        solution.load_factor += correction.load_factor;
      }
  }



  // H x = r_x + G^T W^-2 r_z - A^T y, z = W^-2 (G x - r_z).
  void
  KktSystem::solve_once(KktVector       &solution,
                        const KktVector &right_hand_side) const
  {
    solution = right_hand_side;
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock &block = program.blocks[b];
        double *const     x     = solution.x.begin() + layout.unknowns[b];
        divide_by_square(solution.z, b);
        add_transposed_product(x,
                               block.cone_matrix,
                               solution.z.begin() + layout.rows[b]);
        solve_lower(local_factors[b], x);
        add_to_equations(solution.y, block.rows, local_couplings[b], x, -1.);
      }
    solution.y *= -1.;
    solve_sparse_and_dense(solution.y);
    solution.load_factor = add_growth(solution.y, right_hand_side.load_factor);

    solution.z.equ(-1., right_hand_side.z);
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock &block = program.blocks[b];
        double *const     x     = solution.x.begin() + layout.unknowns[b];
        add_from_equations(x, block.rows, local_couplings[b], solution.y, -1.);
        solve_upper(local_factors[b], x);
        add_product(solution.z.begin() + layout.rows[b], block.cone_matrix, x);
        divide_by_square(solution.z, b);
      }
  }



  void
  KktSystem::divide_by_square(Vector<double> &z, const unsigned int b) const
  {
    for (unsigned int c = layout.first_cones[b]; c < layout.first_cones[b + 1];
         ++c)
      {
        const auto [begin, size] = layout.cones[c];
        const SecondOrderCone::View view(&z[begin], size);
        (*scalings)[c].divide(view);
        (*scalings)[c].divide(view);
      }
  }



  void
  KktSystem::solve_sparse_and_dense(Vector<double> &y) const
  {
    Vector<double> sparse(n_sparse_rows), dense(dense_rows.size()),
      dense_solution(dense_rows.size());
    std::copy(y.begin(), y.begin() + n_sparse_rows, sparse.begin());
    Vector<double> solution;
    sparse_factor->vmult(solution, sparse);
    for (unsigned int i = 0; i < dense.size(); ++i)
      dense[i] = y[n_sparse_rows + i] - dense_rows[i] * solution;
    if (!dense_rows.empty())
      dense_inverse.vmult(dense_solution, dense);
    for (unsigned int i = 0; i < dense.size(); ++i)
      {
        solution.add(-dense_solution[i], dense_solutions[i]);
        y[n_sparse_rows + i] = dense_solution[i];
      }
    std::copy(solution.begin(), solution.end(), y.begin());
  }



  double
  KktSystem::add_growth(Vector<double> &y, const double r_lambda) const
  {
    if (growth_solution.size() == 0)
      return 0.;
    const double lambda =
      (r_lambda + program.growth * y) / (program.growth * growth_solution);
    y.add(-lambda, growth_solution);
    return lambda;
  }



  void
  KktSystem::subtract_product(KktVector       &residual,
                              const KktVector &solution) const
  {
    if (program.growth.size() > 0)
      {
        residual.y.add(solution.load_factor, program.growth);
        residual.load_factor += program.growth * solution.y;
      }
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock   &block = program.blocks[b];
        const double *const x     = solution.x.begin() + layout.unknowns[b];
        double *const       r     = residual.x.begin() + layout.unknowns[b];
        add_product(r, block.quadratic_cost, x, -1.);
        add_from_equations(r, block.rows, block.coupling, solution.y, -1.);
        add_transposed_product(r,
                               block.cone_matrix,
                               solution.z.begin() + layout.rows[b],
                               -1.);
        add_to_equations(residual.y, block.rows, block.coupling, x, -1.);
        add_product(residual.z.begin() + layout.rows[b],
                    block.cone_matrix,
                    x,
                    -1.);
      }
  }
} // namespace ElastoPlastic
