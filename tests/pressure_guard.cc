// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Which contact pressures are beyond what a yield stress can bear.

#include <cmath>
#include <limits>

#include "evaluation/step_guards.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// With Young's modulus 1000 and Poisson's ratio 0.25.
  Material<double>
  material(const double yield_stress)
  {
    Material<double> result;
    result.bulk_modulus      = 1000. / 1.5;
    result.shear_modulus     = 400.;
    result.yield_radius      = std::sqrt(2. / 3.) * yield_stress;
    result.isotropic_modulus = 0.;
    return result;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // E / (3 (1 - nu) Y) = 444.4: the cavity; 2.222: three times Y.
  verify("spherical cavity",
         std::abs(largest_indentation_pressure(material(1.), 0.) -
                  2. / 3. * (1. + std::log(1000. / 2.25))),
         1e-12);
  verify("mean pressure under a punch",
         std::abs(largest_indentation_pressure(material(200.), 0.) - 600.),
         1e-10);
  verify("elastic",
         std::isinf(largest_indentation_pressure(
           material(std::numeric_limits<double>::infinity()), 0.)));

  // H = 3/2 isotropic_modulus = 300, C = 3/2 modulus = 150; a recovery of
  // sqrt(2/3) gamma with gamma = 30 limits the back stress to C / gamma = 5.
  Material<double> hardening  = material(200.);
  hardening.isotropic_modulus = 200.;
  hardening.back_stresses.push_back({100., 0.});
  hardening.back_stresses.push_back({100., std::sqrt(2. / 3.) * 30.});
  verify("with hardening",
         std::abs(largest_indentation_pressure(hardening, 0.1) -
                  3. * (200. + 30. + 15. + 5.)),
         1e-10);

  PressureGuard guard({material(100.), material(200.)});
  verify("limit: twice that of the hardest",
         std::abs(guard.limit(0.) - 1200.),
         1e-10);
  verify("not exceeded", !guard.is_exceeded(1199., 0.));
  verify("exceeded", guard.is_exceeded(1201., 0.));
  verify("said once", !guard.is_exceeded(1300., 0.));
}
