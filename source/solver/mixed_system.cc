// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "solver/mixed_system.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int n_power_iterations = 6;
  }



  MixedSystem::MixedSystem(const TangentOperator &tangent,
                           const ReducedUnknowns &unknowns)
    : tangent(tangent)
    , unknowns(unknowns)
  {
    initialize_vector(source);
    initialize_vector(product);
  }



  // (Where no bulk modulus is more than moderate, D is zero.)
  void
  MixedSystem::scale_pressures(const VectorType &forces)
  {
    pressure_unit = 1.;
    BlockVectorType vector, strains;
    initialize_vector(vector);
    initialize_vector(strains);
    vector.block(0) = forces;
    double square   = 0.;
    for (unsigned int i = 0; i < n_power_iterations; ++i)
      {
        const double norm = vector.block(0).l2_norm();
        if (norm == 0.)
          return;
        vector.block(0) *= 1. / norm;
        vector.block(1) = 0.;
        vmult(strains, vector);
        strains.block(0) = 0.;
        vmult(vector, strains);
        square = vector.block(0).l2_norm();
      }
    if (square > 0.)
      pressure_unit = std::sqrt(square);
  }



  void
  MixedSystem::vmult(BlockVectorType       &result,
                     const BlockVectorType &vector) const
  {
    source.block(0) = vector.block(0);
    unknowns.expand(source.block(0));
    source.block(1).equ(pressure_unit, vector.block(1));
    tangent.mixed_vmult(result, source);
    unknowns.reduce_product(result.block(0), source.block(0), vector.block(0));
    result.block(1) *= pressure_unit;
  }



  void
  MixedSystem::vmult_moderate(VectorType       &forces,
                              const VectorType &increment) const
  {
    source.block(0) = increment;
    unknowns.expand(source.block(0));
    source.block(1) = 0.;
    tangent.mixed_vmult(product, source);
    forces = product.block(0);
    unknowns.reduce_product(forces, source.block(0), increment);
  }



  void
  MixedSystem::precondition(
    BlockVectorType       &result,
    const BlockVectorType &vector,
    const std::function<void(VectorType &result, const VectorType &forces)>
                                 &solve_moderate,
    const PressurePreconditioner &solve_pressures) const
  {
    solve_moderate(result.block(0), vector.block(0));
    result.block(1) = 0.;
    vmult(product, result);
    product.block(1) -= vector.block(1);
    product.block(1) *= 1. / (pressure_unit * pressure_unit);
    solve_pressures.vmult(result.block(1), product.block(1));
  }
} // namespace ElastoPlastic
