// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/conic/block_batch.h"
#include "bounds/conic/local_algebra.h"

// Products and solves of a BlockBatch with vectors.

namespace ElastoPlastic
{
  using namespace LocalAlgebra;

  namespace
  {
    using Lanes = AlignedVector<Simd<double>>;



    void
    load(Lanes                                   &lanes,
         const Vector<double>                    &values,
         const BlockBatch::ByLanes<unsigned int> &begins,
         const unsigned int                       n)
    {
      lanes.resize_fast(n);
      for (unsigned int lane = 0; lane < BlockBatch::max_blocks; ++lane)
        for (unsigned int i = 0; i < n; ++i)
          lane_of(lanes[i], lane) = values[begins[lane] + i];
    }
  } // namespace



  void
  BlockBatch::load_equations(Lanes &lanes, const Vector<double> &values) const
  {
    lanes.resize_fast(equations.size());
    for (unsigned int i = 0; i < equations.size(); ++i)
      for (unsigned int lane = 0; lane < max_blocks; ++lane)
        lane_of(lanes[i], lane) = values[equations[i][lane]];
  }



  void
  BlockBatch::add(Vector<double>              &values,
                  const Lanes                 &lanes,
                  const ByLanes<unsigned int> &begins,
                  const double                 factor) const
  {
    for (unsigned int lane = 0; lane < n_blocks; ++lane)
      for (unsigned int i = 0; i < lanes.size(); ++i)
        values[begins[lane] + i] += factor * lane_of(lanes[i], lane);
  }



  void
  BlockBatch::add_to_equations(Vector<double> &values,
                               const Lanes    &lanes,
                               const double    factor) const
  {
    for (unsigned int i = 0; i < equations.size(); ++i)
      for (unsigned int lane = 0; lane < n_blocks; ++lane)
        values[equations[i][lane]] += factor * lane_of(lanes[i], lane);
  }



  // x := r_x + G^T W^-2 r_z, z := r_z
  void
  BlockBatch::load_right_hand_side(Workspace       &w,
                                   const KktVector &residual) const
  {
    load(w.x, residual.x, unknowns, shape.n_unknowns);
    load(w.z, residual.z, rows, n_rows);
    w.of_z = w.z;
    for_each_cone([&](const auto        &cone,
                      const auto        &scaling,
                      const auto        *columns,
                      const unsigned int row) {
      const ArrayView<Simd<double>> of_z(w.of_z.begin() + row, cone.size);
      scaling.divide(of_z);
      scaling.divide(of_z);
      add_product(w.x.begin() + cone.first_column,
                  columns,
                  cone.n_columns,
                  cone.size,
                  of_z.data());
    });
  }



  // The products of P, A and G with x, y and z.
  void
  BlockBatch::multiply(Workspace &w) const
  {
    const unsigned int n = shape.n_unknowns, n_equations = shape.n_equations;
    clear(w.of_x, n);
    clear(w.of_y, n_equations);
    clear(w.of_z, n_rows);
    if (shape.has_quadratic_cost)
      add_product(w.of_x.begin(), quadratic_cost.begin(), n, n, w.x.begin());
    add_transposed_product(
      w.of_x.begin(), coupling.begin(), n_equations, n, w.y.begin());
    add_product(w.of_y.begin(), coupling.begin(), n_equations, n, w.x.begin());
    for_each_cone([&](const auto &cone,
                      const auto &,
                      const auto        *columns,
                      const unsigned int row) {
      add_product(w.of_x.begin() + cone.first_column,
                  columns,
                  cone.n_columns,
                  cone.size,
                  w.z.begin() + row);
      add_transposed_product(w.of_z.begin() + row,
                             columns,
                             cone.n_columns,
                             cone.size,
                             w.x.begin() + cone.first_column);
    });
  }



  void
  BlockBatch::reduce(Vector<double>  &y,
                     const KktVector &residual,
                     Workspace       &w) const
  {
    load_right_hand_side(w, residual);
    LocalAlgebra::solve(factor.begin(), shape.n_unknowns, w.x.begin());
    clear(w.of_y, shape.n_equations);
    add_product(w.of_y.begin(),
                coupling.begin(),
                shape.n_equations,
                shape.n_unknowns,
                w.x.begin());
    add_to_equations(y, w.of_y, 1.);
  }



  void
  BlockBatch::substitute(KktVector            &solution,
                         KktVector            &residual,
                         const Vector<double> &y,
                         Workspace            &w) const
  {
    load_right_hand_side(w, residual);
    load_equations(w.y, y);
    clear(w.of_x, shape.n_unknowns);
    add_transposed_product(w.of_x.begin(),
                           coupling.begin(),
                           shape.n_equations,
                           shape.n_unknowns,
                           w.y.begin());
    for (unsigned int i = 0; i < shape.n_unknowns; ++i)
      w.x[i] -= w.of_x[i];
    LocalAlgebra::solve(factor.begin(), shape.n_unknowns, w.x.begin());

    for (Simd<double> &entry : w.z)
      entry *= -1.;
    for_each_cone([&](const auto        &cone,
                      const auto        &scaling,
                      const auto        *columns,
                      const unsigned int row) {
      const ArrayView<Simd<double>> z(w.z.begin() + row, cone.size);
      add_transposed_product(z.data(),
                             columns,
                             cone.n_columns,
                             cone.size,
                             w.x.begin() + cone.first_column);
      scaling.divide(z);
      scaling.divide(z);
    });
    add(solution.x, w.x, unknowns, 1.);
    add(solution.z, w.z, rows, 1.);

    multiply(w);
    for_each_cone([&](const auto &cone,
                      const auto &scaling,
                      const auto *,
                      const unsigned int row) {
      const ArrayView<Simd<double>> z(w.z.begin() + row, cone.size);
      scaling.multiply(z);
      scaling.multiply(z);
      for (unsigned int i = 0; i < cone.size; ++i)
        w.of_z[row + i] -= z[i];
    });
    subtract_products(residual, w);
  }



  void
  BlockBatch::subtract_product(KktVector       &residual,
                               const KktVector &solution,
                               Workspace       &w) const
  {
    load(w.x, solution.x, unknowns, shape.n_unknowns);
    load(w.z, solution.z, rows, n_rows);
    load_equations(w.y, solution.y);
    multiply(w);
    subtract_products(residual, w);
  }



  void
  BlockBatch::subtract_products(KktVector &residual, const Workspace &w) const
  {
    add(residual.x, w.of_x, unknowns, -1.);
    add(residual.z, w.of_z, rows, -1.);
    add_to_equations(residual.y, w.of_y, -1.);
  }
} // namespace ElastoPlastic
