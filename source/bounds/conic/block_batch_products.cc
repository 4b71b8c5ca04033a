// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>

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



    void
    store(Vector<double>                          &values,
          const Lanes                             &lanes,
          const BlockBatch::ByLanes<unsigned int> &begins,
          const unsigned int                       n_blocks)
    {
      for (unsigned int lane = 0; lane < n_blocks; ++lane)
        for (unsigned int i = 0; i < lanes.size(); ++i)
          values[begins[lane] + i] = lane_of(lanes[i], lane);
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



  void
  BlockBatch::solve(Lanes &x) const
  {
    for (const Part &part : parts)
      LocalAlgebra::solve(&factor[part.entry],
                          part.size(),
                          x.begin() + part.begin);
  }



  // P x is added.
  void
  BlockBatch::multiply_unknowns(Workspace &w) const
  {
    const unsigned int n = shape.n_unknowns;
    clear(w.of_y, shape.n_equations);
    clear(w.of_z, n_rows);
    if (shape.has_quadratic_cost)
      add_product(w.of_x.begin(), quadratic_cost.begin(), n, n, w.x.begin());
    add_product(
      w.of_y.begin(), coupling.begin(), shape.n_equations, n, w.x.begin());
    for_each_cone([&](const auto &cone,
                      const auto &,
                      const auto        *columns,
                      const unsigned int row) {
      add_transposed_product(w.of_z.begin() + row + cone.first_row,
                             columns,
                             cone.n_columns,
                             cone.n_rows(),
                             w.x.begin() + cone.first_column);
    });
  }



  void
  BlockBatch::multiply_equations(Workspace &w) const
  {
    clear(w.of_x, shape.n_unknowns);
    add_transposed_product(w.of_x.begin(),
                           coupling.begin(),
                           shape.n_equations,
                           shape.n_unknowns,
                           w.y.begin());
  }



  void
  BlockBatch::reduce(Vector<double>  &y,
                     Vector<double>  &reduced,
                     const KktVector &residual,
                     Workspace       &w) const
  {
    load(w.x, residual.x, unknowns, shape.n_unknowns);
    load(w.z, residual.z, rows, n_rows);
    for_each_cone([&](const auto        &cone,
                      const auto        &scaling,
                      const auto        *columns,
                      const unsigned int row) {
      const ArrayView<Simd<double>> z(w.z.begin() + row, cone.size);
      scaling.divide(z);
      scaling.divide(z);
      add_product(w.x.begin() + cone.first_column,
                  columns,
                  cone.n_columns,
                  cone.n_rows(),
                  z.data() + cone.first_row);
    });
    store(reduced, w.x, unknowns, n_blocks);

    solve(w.x);
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
                         const Vector<double> &reduced,
                         const Vector<double> &y,
                         Workspace            &w) const
  {
    load(w.x, reduced, unknowns, shape.n_unknowns);
    load(w.z, residual.z, rows, n_rows);
    load_equations(w.y, y);
    multiply_equations(w);
    for (unsigned int i = 0; i < shape.n_unknowns; ++i)
      w.x[i] -= w.of_x[i];
    solve(w.x);
    multiply_unknowns(w);

    std::array<Simd<double>, SecondOrderCone::max_size> product;
    for_each_cone([&](const auto        &cone,
                      const auto        &scaling,
                      const auto        *columns,
                      const unsigned int row) {
      const ArrayView<Simd<double>> z(w.z.begin() + row, cone.size);
      for (unsigned int i = 0; i < cone.size; ++i)
        z[i] = w.of_z[row + i] - z[i];
      scaling.divide(z);
      scaling.divide(z);
      add_product(w.of_x.begin() + cone.first_column,
                  columns,
                  cone.n_columns,
                  cone.n_rows(),
                  z.data() + cone.first_row);
      std::copy_n(z.begin(), cone.size, product.begin());
      scaling.multiply({product.data(), cone.size});
      scaling.multiply({product.data(), cone.size});
      for (unsigned int i = 0; i < cone.size; ++i)
        w.of_z[row + i] -= product[i];
    });
    add(solution.x, w.x, unknowns, 1.);
    add(solution.z, w.z, rows, 1.);
    subtract_products(residual, w);
  }



  void
  BlockBatch::add_quadratic_slope(Vector<double>       &slope,
                                  const Vector<double> &x,
                                  Workspace            &w) const
  {
    if (!shape.has_quadratic_cost)
      return;
    const unsigned int n = shape.n_unknowns;
    load(w.x, x, unknowns, n);
    clear(w.of_x, n);
    add_product(w.of_x.begin(), quadratic_cost.begin(), n, n, w.x.begin());
    add(slope, w.of_x, unknowns, 1.);
  }



  void
  BlockBatch::subtract_product(KktVector       &residual,
                               const KktVector &solution,
                               Workspace       &w) const
  {
    load(w.x, solution.x, unknowns, shape.n_unknowns);
    load(w.z, solution.z, rows, n_rows);
    load_equations(w.y, solution.y);
    multiply_equations(w);
    multiply_unknowns(w);
    for_each_cone([&](const auto &cone,
                      const auto &,
                      const auto        *columns,
                      const unsigned int row) {
      add_product(w.of_x.begin() + cone.first_column,
                  columns,
                  cone.n_columns,
                  cone.n_rows(),
                  w.z.begin() + row + cone.first_row);
    });
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
