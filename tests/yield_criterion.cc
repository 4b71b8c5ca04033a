// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The yield criteria of Hosford and Hill at a point: yield stresses and strain
// ratios of tension in several directions, von Mises and Tresca as special
// cases, turned axes, and batches.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "base/text.h"
#include "sample_criteria.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Tensor3 = SymmetricTensor<2, 3>;



  /// dq/ds by differences.
  Tensor3
  slope(const GeneralCriterion &criterion, const Tensor3 &stress)
  {
    const double step = 1e-5 * stress.norm();
    Tensor3      result;
    for (unsigned int i = 0; i < 6; ++i)
      {
        Tensor3 change;
        change.access_raw_entry(i) = step;
        result.access_raw_entry(i) =
          (equivalent_stress(criterion, stress + change) -
           equivalent_stress(criterion, stress - change)) /
          (i < 3 ? 2. * step : 4. * step);
      }
    return result;
  }



  Tensor3
  tension(const double degrees)
  {
    const double angle = degrees * numbers::PI / 180.;
    Tensor3      result;
    result[0][0] = std::cos(angle) * std::cos(angle);
    result[1][1] = std::sin(angle) * std::sin(angle);
    result[0][1] = std::cos(angle) * std::sin(angle);
    return result;
  }



  /// Hill (1948): yield stress and ratio of the strains across to those through
  /// the thickness.
  void
  check_tension()
  {
    const HillRatios       r = {{1.05, 1.1, 0.85, 0.95, 1.2, 0.9}};
    const GeneralCriterion hill(HillCriterion(r, unit_symmetric_tensor<3>()));
    const auto             inverse = [&](const unsigned int i) {
      return 1. / r[i] / r[i];
    };
    const double F = (inverse(1) + inverse(2) - inverse(0)) / 2.,
                 G = (inverse(2) + inverse(0) - inverse(1)) / 2.,
                 H = (inverse(0) + inverse(1) - inverse(2)) / 2.,
                 N = 1.5 * inverse(3);
    verify("Hill: tension along 1 and 2",
           std::abs(1. / equivalent_stress(hill, tension(0.)) - r[0]) +
             std::abs(1. / equivalent_stress(hill, tension(90.)) - r[1]),
           1e-14);
    for (const double degrees : {0., 22.5, 45., 90.})
      {
        const double s = std::pow(std::sin(degrees * numbers::PI / 180.), 2),
                     c = 1. - s;
        const double square =
          (G + H) * c * c + (F + H) * s * s + 2. * (N - H) * c * s;
        const double ratio =
          (H + (2. * N - F - G - 4. * H) * s * c) / (F * s + G * c);
        const Tensor3 n      = normal(hill, tension(degrees));
        const double  across = n * tension(degrees + 90.);
        verify("  yield stress and R at " + to_text(degrees) + " degrees",
               std::abs(equivalent_stress(hill, tension(degrees)) -
                        std::sqrt(square)) +
                 std::abs(across / n[2][2] - ratio),
               1e-13);
      }
    for (unsigned int k = 0; k < 3; ++k)
      {
        Tensor3 shear;
        shear[k == 2 ? 1 : 0][k == 0 ? 1 : 2] = std::sqrt(1. / 3.);
        verify("  shear " + std::to_string(k),
               std::abs(1. / equivalent_stress(hill, shear) - r[3 + k]),
               1e-14);
      }
  }



  void
  check_norms()
  {
    double von_mises = 0, tresca = 0, normals = 0;
    for (unsigned int number = 0; number < 30; ++number)
      {
        const Tensor3 stress = sample_tensor<3>(number, 100.);
        const double  mises  = std::sqrt(1.5) * deviator(stress).norm();
        for (const double a : {2., 4.})
          von_mises =
            std::max(von_mises,
                     std::abs(equivalent_stress(HosfordCriterion(a), stress) -
                              mises) /
                       mises);
        const auto values = eigenvalues(stress);
        tresca =
          std::max(tresca,
                   std::abs(equivalent_stress(HosfordCriterion(100.), stress) /
                              (values[0] - values[2]) -
                            1.));
        for (const std::string &name : all_criteria)
          {
            const auto &criterion =
              *material_with(name, "perfectly plastic").criteria[0];
            normals = std::max(
              normals,
              (normal(criterion, stress) - slope(criterion, stress)).norm());
          }
      }
    verify("Hosford with the exponents 2 and 4 is von Mises", von_mises, 1e-14);
    // 2^(1/a) in shear, where the difference is largest
    verify("Hosford with a large exponent is almost Tresca",
           tresca,
           std::pow(2., 0.01) - 1.);
    verify("normals are derivatives", normals, 1e-7);
    verify("ratios whose surface is not closed",
           !HillCriterion::are_convex({{1., 1., 0.5, 1., 1., 1.}}) &&
             !HillCriterion::are_convex({{0.4, 1., 1., 1., 1., 1.}}) &&
             !HillCriterion::are_convex({{1., 1., 1., 1., 0., 1.}}) &&
             HillCriterion::are_convex({{1., 1., 0.51, 9., 9., 9.}}));
  }



  /// As with the criterion of von Mises, by the radial return.
  void
  check_special_cases()
  {
    for (const std::string criterion : {"Hosford 2", "Hosford 4"})
      for (const RateLawType rate_law : {RateLawType::none,
                                         RateLawType::perzyna,
                                         RateLawType::norton,
                                         RateLawType::cowper_symonds,
                                         RateLawType::duvaut_lions})
        {
          double difference = 0;
          for (const std::string &law : lasting_laws)
            {
              const auto material  = material_with(criterion, law, rate_law);
              auto       radial    = material;
              radial.criteria[0]   = nullptr;
              const auto old_state = sample_state(material);
              for (unsigned int number = 0; number < 10; ++number)
                {
                  const Tensor3 strain =
                    deviator(sample_tensor<3>(number, 0.004 * number));
                  const RadialReturn<double> a(material, strain, old_state),
                    b(radial, strain, old_state);
                  difference = std::max(
                    {difference,
                     (a.deviatoric_stress() - b.deviatoric_stress()).norm() /
                       400.,
                     std::abs(a.state().equivalent_plastic_strain -
                              b.state().equivalent_plastic_strain),
                     (a.state().plastic_strain - b.state().plastic_strain)
                       .norm(),
                     std::abs(a.energy() - b.energy()) / 400.,
                     std::abs(a.hardening_energy() - b.hardening_energy()) /
                       400.});
                }
            }
          verify(criterion + " is von Mises, rate law " +
                   Patterns::Tools::Convert<RateLawType>::to_string(rate_law),
                 difference,
                 1e-10);
        }
  }



  /// Strain and axes that are turned together turn the stress.
  void
  check_turned_axes()
  {
    const auto turned = [](const double angle) {
      MaterialParameters parameters = sample_parameters("combined hardening");
      set_criterion(parameters, "Hill");
      parameters.criteria.axes = {to_text(angle) + " | 40 | 70"};
      return parameters.materials().front();
    };
    const double angle = 0.7;
    Tensor<2, 3> rotation;
    rotation[0][0] = rotation[1][1] = std::cos(angle);
    rotation[1][0]                  = std::sin(angle);
    rotation[0][1]                  = -std::sin(angle);
    rotation[2][2]                  = 1.;
    const Tensor3 strain            = deviator(sample_tensor<3>(3, 0.02));
    const Tensor3 turned_strain =
      symmetrize(rotation * Tensor<2, 3>(strain) * transpose(rotation));
    const MaterialState<double> virgin(1);
    const auto                  first = turned(20.);
    const auto second = turned(20. + 180. / numbers::PI * angle);
    const RadialReturn<double> a(first, strain, virgin);
    const RadialReturn<double> b(second, turned_strain, virgin);
    verify("turned axes",
           (symmetrize(rotation * Tensor<2, 3>(a.deviatoric_stress()) *
                       transpose(rotation)) -
            b.deviatoric_stress())
               .norm() /
             a.deviatoric_stress().norm(),
           1e-8);
    verify("axes are turned, not the material alone",
           (RadialReturn<double>(second, strain, virgin).deviatoric_stress() -
            a.deviatoric_stress())
               .norm() > 1.);
  }



  /// Each lane has a material of its own.
  void
  check_batch()
  {
    using Number                                  = Simd<double>;
    const std::vector<Material<double>> materials = {
      material_with("Hill", "Voce"),
      material_with("Hosford 40", "combined hardening"),
      material_with("Hosford 6", "perfectly plastic")};
    std::array<const Material<double> *, Number::size()> of_lane;
    SymmetricTensor<2, 3, Number>                        strain;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        of_lane[lane] = &materials[lane % materials.size()];
        // (the last is elastic)
        const Tensor3 of_number = deviator(
          sample_tensor<3>(lane, lane + 1 < Number::size() ? 0.02 : 1e-4));
        for (unsigned int i = 0; i < 6; ++i)
          strain.access_raw_entry(i)[lane] = of_number.access_raw_entry(i);
      }
    const auto                  batch = join_lanes<Number>(of_lane, 1);
    const MaterialState<Number> virgin(1);
    const RadialReturn<Number>  point(batch, strain, virgin);
    const auto                  product = point.general_tangent() * strain;
    double                      error   = 0;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        const auto                  material = lane_of(batch, lane);
        const MaterialState<double> of_lane(1);
        const Tensor3               of_strain = lane_of(strain, lane);
        const RadialReturn<double>  alone(material, of_strain, of_lane);
        error = std::max(
          {error,
           (lane_of(point.deviatoric_stress(), lane) -
            alone.deviatoric_stress())
             .norm(),
           (lane_of(product, lane) - alone.general_tangent() * of_strain)
             .norm()});
      }
    verify("lanes of a batch", error, 1e-9);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_tension();
  check_norms();
  check_special_cases();
  check_turned_axes();
  check_batch();
}
