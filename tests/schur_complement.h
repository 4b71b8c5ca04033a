// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_schur_complement_h
#define tests_schur_complement_h

#include "mechanics/solid_operator.h"
#include "solver/krylov_methods.h"

using namespace ElastoPlastic;

/// Of the mixed form, with some displacements held: 1 + D A^-1 D^T, without
/// multigrid.
template <int dim>
class SchurComplement
{
public:
  SchurComplement(const SolidOperator<dim> &solid, const VectorType &held)
    : solid(solid)
    , held(held)
  {
    solid.initialize_mixed_vector(mixed);
    solid.initialize_mixed_vector(product);
  }

  void
  vmult(VectorType &result, const VectorType &pressures) const
  {
    mixed.block(0) = 0.;
    mixed.block(1) = pressures;
    solid.mixed_vmult(product, mixed);
    VectorType forces = product.block(0), u = product.block(0);
    set_held_entries(forces);
    conjugate_gradients(
      Moderate{*this}, u, forces, PreconditionIdentity(), 1e-9, 10000);
    moderate_product(forces, u);
    result = pressures;
    result += product.block(1);
  }

private:
  struct Moderate
  {
    const SchurComplement &schur;

    void
    vmult(VectorType &forces, const VectorType &u) const
    {
      schur.moderate_product(forces, u);
    }
  };

  void
  set_held_entries(VectorType &vector) const
  {
    for (unsigned int i = 0; i < held.locally_owned_size(); ++i)
      if (held.local_element(i) != 0.)
        vector.local_element(i) = 0.;
  }

  /// A u, and D u in block 1 of product.
  void
  moderate_product(VectorType &forces, const VectorType &u) const
  {
    mixed.block(0) = u;
    mixed.block(1) = 0.;
    solid.mixed_vmult(product, mixed);
    forces = product.block(0);
    set_held_entries(forces);
  }

  const SolidOperator<dim> &solid;
  const VectorType         &held;
  mutable BlockVectorType   mixed, product;
};

#endif
