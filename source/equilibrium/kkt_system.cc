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
    find_strips();
    find_parts();
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
            const ConicLayout::Cone &cone = layout.cones[c];
            (*scalings)[c].add_square(
              SecondOrderCone::View(&residual.z[cone.begin], cone.size),
              SecondOrderCone::ConstView(&solution.z[cone.begin], cone.size));
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
        add_transposed_cone_product(x,
                                    b,
                                    solution.z.begin() + layout.rows[b],
                                    1.);
        for (const Part &part : parts[b])
          solve_lower(local_factors[b], part, x);
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
        for (const Part &part : parts[b])
          solve_upper(local_factors[b], part, x);
        add_cone_product(solution.z.begin() + layout.rows[b], b, x, 1.);
        divide_by_square(solution.z, b);
      }
  }



  void
  KktSystem::divide_by_square(Vector<double> &z, const unsigned int b) const
  {
    for (unsigned int c = layout.first_cones[b]; c < layout.first_cones[b + 1];
         ++c)
      {
        const SecondOrderCone::View view(&z[layout.cones[c].begin],
                                         layout.cones[c].size);
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
        add_transposed_cone_product(r,
                                    b,
                                    solution.z.begin() + layout.rows[b],
                                    -1.);
        add_to_equations(residual.y, block.rows, block.coupling, x, -1.);
        add_cone_product(residual.z.begin() + layout.rows[b], b, x, -1.);
      }
  }
} // namespace ElastoPlastic
