// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_space_stress_h
#define equilibrium_space_stress_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "equilibrium/space_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Stresses in exact equilibrium in space, without the pressure of body
  /// forces (see PlaneBody), and the force of the indenter.
  struct SpaceStressField
  {
    /// By tetrahedra, at the corners of their parts: see
    /// TetrahedronStress::value_index().
    std::vector<Vector<double>> values;

    double       force        = 0;
    double       load_factor  = 0; ///< of the loads that grow, if any do
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the maximisation early.
    bool is_optimal = true;

    /// At a @p corner of a @p part of a tetrahedron.
    SymmetricTensor<2, 3>
    at(const unsigned int tetrahedron,
       const unsigned int part,
       const unsigned int corner) const;
  };



  /// The stresses with the largest load factor, or if no load grows, with the
  /// largest force of the indenter, that satisfy the yield condition
  /// everywhere: a ConicProgram. Each tetrahedron is a block, whose unknowns
  /// are the coefficients of its equilibrated basis; so is each corner of a
  /// face under the indenter, with the pressure there. The equations, three at
  /// each corner of a face, say that the tractions of the two tetrahedra, or of
  /// tetrahedron and indenter, add up to zero, or to what is prescribed. The
  /// result is a lower bound of the limit load.
  /// @throws ConvergenceError, in particular if there is no limit.
  SpaceStressField
  maximize_load(const SpaceBody &body,
                const double     tolerance = usual_space_tolerance);



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
    /// |dev tau| - sqrt(2/3) sigma_0
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
