// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Logarithmic strains against closed forms (rotation, stretch, simple shear),
// and the stress and tangent that follow from them against difference
// quotients, also where principal stretches coincide.

#include <cmath>

#include "mechanics/logarithmic_strain.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Matrix  = Tensor<2, 3>;
  using Tensor3 = SymmetricTensor<2, 3>;

  Matrix
  rotation(const double angle, const unsigned int i, const unsigned int j)
  {
    Matrix result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d][d] = 1.;
    result[i][i] = result[j][j] = std::cos(angle);
    result[i][j]                = -std::sin(angle);
    result[j][i]                = std::sin(angle);
    return result;
  }



  Matrix
  stretch(const double x, const double y, const double z)
  {
    Matrix result;
    result[0][0] = x;
    result[1][1] = y;
    result[2][2] = z;
    return result;
  }



  Matrix
  gradient_of(Matrix deformation)
  {
    for (unsigned int d = 0; d < 3; ++d)
      deformation[d][d] -= 1.;
    return deformation;
  }



  /// Some elastic law, not isotropic.
  Tensor3
  law(const Tensor3 &strain)
  {
    Tensor3 normal;
    normal[0][0]   = 0.3;
    normal[0][1]   = -0.4;
    normal[1][1]   = 0.1;
    normal[2][2]   = 0.5;
    Tensor3 stress = 2. * strain + (normal * strain) * normal;
    for (unsigned int d = 0; d < 3; ++d)
      stress[d][d] += 0.7 * trace(strain);
    return stress;
  }



  template <int dim>
  LogarithmicStrain<dim, double>
  logarithmic(const Matrix &gradient)
  {
    return LogarithmicStrain<dim, double>(gradient);
  }



  template <int dim>
  double
  energy(const Matrix &gradient)
  {
    const Tensor3 strain = logarithmic<dim>(gradient).strain();
    return 0.5 * (strain * law(strain));
  }



  template <int dim>
  Matrix
  nominal_stress(const Matrix &gradient)
  {
    const auto strain = logarithmic<dim>(gradient);
    return strain.nominal_stress(law(strain.strain()));
  }



  /// (f(F + h dF) - f(F - h dF)) / 2h, of fourth order.
  template <typename Function>
  auto
  quotient(const Function &f, const Matrix &gradient, const Matrix &direction)
  {
    const double h = 1e-3;
    return (8. * (f(gradient + h * direction) - f(gradient - h * direction)) -
            (f(gradient + 2. * h * direction) -
             f(gradient - 2. * h * direction))) /
           (12. * h);
  }



  void
  check_closed_forms()
  {
    const Matrix turn =
      rotation(0.7, 0, 1) * rotation(2.5, 1, 2) * rotation(-1.1, 0, 2);
    verify("rotation: no strain",
           logarithmic<3>(gradient_of(turn)).strain().norm(),
           1e-14);

    const auto bar = logarithmic<3>(gradient_of(turn * stretch(20., 0.1, 1.)));
    Tensor3    expected;
    expected[0][0] = std::log(20.);
    expected[1][1] = std::log(0.1);
    verify("large stretch", (bar.strain() - expected).norm(), 1e-12);
    verify("change of volume",
           std::abs(bar.volumetric() - std::log(2.)),
           1e-12);

    // F = 1 + gamma e_x e_y^T: the principal stretches are
    // exp(+-asinh(gamma/2))
    Matrix       shear;
    const double gamma  = 3.;
    shear[0][1]         = gamma;
    const double length = std::asinh(gamma / 2.);
    const auto   strain = logarithmic<2>(shear).strain();
    verify("simple shear",
           std::abs(strain[0][1] -
                    length / std::sqrt(1. + gamma * gamma / 4.)) +
             std::abs(strain[1][1] -
                      length * gamma / std::sqrt(4. + gamma * gamma)) +
             std::abs(strain[0][0] + strain[1][1]),
           1e-14);

    // small strain is the limit
    Matrix gradient = shear;
    gradient[1][0]  = 1.;
    gradient[2][2]  = -2.;
    for (const double size : {1e-3, 1e-6})
      verify("the difference to small strains falls with the square",
             (logarithmic<3>(size * gradient).strain() -
              size * symmetrize(gradient))
               .norm(),
             10. * size * size);

    verify("turned inside out: no strain",
           std::isnan(
             logarithmic<2>(gradient_of(stretch(1., -1., 1.))).volumetric()));
  }



  template <int dim>
  void
  check_derivatives(const std::string &name, const Matrix &gradient)
  {
    const auto strain  = logarithmic<dim>(gradient);
    const auto stress  = law(strain.strain());
    const auto tangent = strain.nominal_tangent(stress, law);

    double of_energy = 0, of_volume = 0, of_stress = 0;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        {
          Matrix unit;
          unit[i][j] = 1.;
          of_energy  = std::max(of_energy,
                               std::abs(quotient(energy<dim>, gradient, unit) -
                                        nominal_stress<dim>(gradient)[i][j]));
          of_volume =
            std::max(of_volume,
                     std::abs(quotient(
                                [](const Matrix &g) {
                                  return logarithmic<dim>(g).volumetric();
                                },
                                gradient,
                                unit) -
                              strain.volumetric_slope()[i][j]));
          of_stress = std::max(of_stress,
                               (quotient(nominal_stress<dim>, gradient, unit) -
                                as_matrix<dim>(tangent * as_entries<dim>(unit)))
                                 .norm());
        }
    output() << name << std::endl;
    verify("  stress is the derivative of the energy", of_energy, 1e-9);
    verify("  slope of the volumetric strain", of_volume, 1e-9);
    verify("  tangent is the derivative of the stress", of_stress, 1e-8);

    const Matrix deformation =
      gradient + gradient_of(2. * Matrix(unit_symmetric_tensor<3>()));
    const Matrix true_stress = nominal_stress<dim>(gradient) *
                               transpose(deformation) /
                               determinant(deformation);
    verify("  true stress",
           (true_stress - Matrix(strain.true_stress(stress))).norm(),
           1e-13);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_closed_forms();
  const Matrix turn = rotation(0.7, 0, 1) * rotation(0.5, 1, 2);
  const auto   of   = [&](const double x, const double y, const double z) {
    return gradient_of(turn * stretch(x, y, z) *
                       transpose(rotation(0.3, 0, 2)));
  };
  check_derivatives<3>("Three stretches", of(1.5, 0.7, 1.1));
  check_derivatives<3>("Two close ones", of(1.5, 1.5 + 1e-7, 0.6));
  check_derivatives<3>("Two equal ones", of(0.8, 0.8, 1.6));
  check_derivatives<3>("Three close ones", of(1.2, 1.21, 1.26));
  check_derivatives<3>("Three equal ones", of(1.3, 1.3, 1.3));
  check_derivatives<3>("No deformation", Matrix());
  const auto in_plane = [&](const double x, const double y, const double z) {
    return gradient_of(rotation(0.7, 0, 1) * stretch(x, y, z) *
                       rotation(-0.2, 0, 1));
  };
  check_derivatives<2>("In the plane", in_plane(1.5, 0.7, 1.1));
  check_derivatives<2>("In the plane, equal", in_plane(1.5, 1.5, 1.));
}
