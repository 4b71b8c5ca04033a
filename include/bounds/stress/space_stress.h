// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_space_stress_h
#define bounds_stress_space_stress_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "bounds/body/space_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Stresses in exact equilibrium in space, without the pressure of body
  /// forces (see PlaneBody), and what the indenter does.
  struct SpaceStressField
  {
    /// By tetrahedra, at the corners of their parts: see
    /// TetrahedronStress::value_index().
    std::vector<Vector<double>> values;
    /// By faces: the vertical part of the indenter's pressure at the corners,
    /// between which it is linear; zero where it cannot touch.
    std::vector<std::array<double, 3>> pressure;

    double force = 0;
    /// Zero if neither it nor the force has been prescribed.
    double       depth        = 0;
    double       load_factor  = 0; ///< of the loads that grow, if any do
    double       cost         = 0; ///< what has been minimised
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;

    /// At a @p corner of a @p part of a tetrahedron.
    SymmetricTensor<2, 3>
    at(const unsigned int tetrahedron,
       const unsigned int part,
       const unsigned int corner) const;

    /// The largest pressure of the indenter.
    double
    max_pressure() const;

    /// The area of what the indenter presses on.
    double
    contact_area(const SpaceBody &body) const;
  };



  /// How well a stress field satisfies what it promises, relative to the unit
  /// of stress of the body: all should be zero but for rounding.
  struct SpaceStressErrors
  {
    /// What is missing to equilibrium, times the size of the tetrahedron.
    double divergence    = 0;
    double traction_jump = 0; ///< between parts and between tetrahedra
    double boundary_force =
      0;                ///< given tractions, and shear under the indenter
    double tension = 0; ///< under the indenter
    /// |dev tau| - sqrt(2/3) sigma_0, where the material does not harden
    double yield_excess = 0;
    double force_difference =
      0; ///< of the field's force and int p ds, relative

    double
    largest() const;
  };

  /// Looks at every part of a tetrahedron and at every face, using nothing but
  /// the stresses themselves.
  SpaceStressErrors
  check_stress(const SpaceBody &body, const SpaceStressField &field);
} // namespace ElastoPlastic

#endif
