// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The return mapping of plane stress, for all laws: with the strain that it
// finds, the one for bodies in space leaves no stress across the sheet. Simple
// stress states against closed forms.

#include <deal.II/base/mpi.h>

#include "material/plane_stress.h"
#include "material/radial_return.h"
#include "sample_material.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// The stress at the end of a step.
  SymmetricTensor<2, 3>
  stress_after(const Material<double>      &material,
               SymmetricTensor<2, 3>        strain,
               const MaterialState<double> &old_state)
  {
    strain[2][2] = out_of_plane_strain(material, strain, old_state);
    auto stress =
      RadialReturn<double>(material, strain_deviator(strain), old_state)
        .deviatoric_stress();
    for (unsigned int d = 0; d < 3; ++d)
      stress[d][d] += material.bulk_modulus * trace(strain);
    return stress;
  }



  /// Strains from far inside the yield surface to far outside, with and without
  /// a history.
  void
  test_no_stress_across(const std::string &law)
  {
    const auto                  material = sample_material(law);
    const MaterialState<double> virgin(material.back_stresses.size());
    double                      largest = 0;
    for (const auto &state : {virgin, sample_state(material)})
      for (const double size : {1e-6, 1e-3, 3e-3, 1e-2, 0.1, 1.})
        for (unsigned int number = 0; number < 20; ++number)
          {
            auto strain  = sample_tensor<3>(number, size);
            strain[0][2] = strain[1][2] = 0;
            const auto stress           = stress_after(material, strain, state);
            largest = std::max(largest, std::abs(stress[2][2]) / stress.norm());
          }
    verify(law, largest < 1e-11);
  }



  /// The yield stress Y in simple states of a perfectly plastic sheet: both
  /// principal stresses Y; and Y / sqrt(3) in shear.
  void
  test_perfect_plasticity()
  {
    const auto                  material = sample_material("perfectly plastic");
    const MaterialState<double> virgin(0);
    SymmetricTensor<2, 3>       biaxial, shear;
    biaxial[0][0] = biaxial[1][1] = 0.01;
    shear[0][1]                   = 0.01;
    const auto tension            = stress_after(material, biaxial, virgin);
    verify("equal tension",
           std::abs(tension[0][0] - 400.) < 1e-9 &&
             std::abs(tension[1][1] - 400.) < 1e-9);
    verify("shear",
           std::abs(stress_after(material, shear, virgin)[0][1] -
                    400. / std::sqrt(3.)) < 1e-9);
  }



  void
  test_elasticity()
  {
    const auto                  material = sample_material("linear elastic");
    const MaterialState<double> virgin(material.back_stresses.size());
    SymmetricTensor<2, 3>       strain;
    strain[0][0]      = 1e-3;
    const auto stress = stress_after(material, strain, virgin);
    verify("elastic",
           std::abs(stress[0][0] - 200. / 0.91) < 1e-9 &&
             std::abs(stress[1][1] - 60. / 0.91) < 1e-9);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << "No stress across" << std::endl;
  for (const auto *laws : {&all_laws, &nonlinear_laws})
    for (const std::string &law : *laws)
      test_no_stress_across(law);
  test_elasticity();
  test_perfect_plasticity();
}
