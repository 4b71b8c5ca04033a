// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_body_state_h
#define mechanics_body_state_h

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// What has happened inside the body, of all ranks together.
  struct BodyState
  {
    /// Of the quadrature points that have yielded.
    double plastic_volume                = 0;
    double max_equivalent_plastic_strain = 0;
    double elastic_energy                = 0;
    /// What hardening has stored.
    double hardening_energy = 0;
    /// Since the last commit() of the body. In a SolveResult that has been
    /// committed: since the virgin state.
    double plastic_work = 0;
    double dissipation  = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &plastic_volume &max_equivalent_plastic_strain &elastic_energy
        &hardening_energy &plastic_work &dissipation;
    }
  };



  /// That of @p solid with the @p displacement. Collective.
  template <int dim>
  BodyState
  body_state(const SolidOperator<dim> &solid, const VectorType &displacement);
} // namespace ElastoPlastic

#endif
