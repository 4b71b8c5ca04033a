// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The scalar equation of the return to the yield surface: its slope, its
// closed solution for linear laws, and that it is solved however extreme its
// data are.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

#include "material/return_equation.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// With linear hardening; its yield surface has the radius 300 where alpha is
  /// @p old_alpha.
  constexpr double old_alpha = 0.001;

  Material<double>
  sample_material()
  {
    Material<double> material;
    material.shear_modulus     = 75000.;
    material.isotropic_modulus = 1000.;
    material.yield_radius      = 300. - 1000. * std::sqrt(1.5) * old_alpha;
    material.is_linear         = false;
    return material;
  }



  /// A stress @p excess beyond the yield surface of @p material, and no back
  /// stresses.
  ReturnEquation
  equation_of(const double excess, const Material<double> &material)
  {
    ReturnEquation equation = {FlowResistance(material, old_alpha, 0), {}};
    equation.products[0][0] = std::pow(300. + excess, 2);
    return equation;
  }



  /// The same with a back stress of the length @p fraction c / g, at an angle
  /// with the trial stress that has the given @p cosine.
  ReturnEquation
  with_back_stress(const double      excess,
                   Material<double> &material,
                   const double      modulus,
                   const double      recovery,
                   const double      fraction,
                   const double      cosine)
  {
    material.back_stresses.assign(1, {modulus, recovery});
    ReturnEquation equation = equation_of(excess, material);
    const double   length   = fraction * modulus / recovery;
    equation.products[1][1] = length * length;
    equation.products[0][1] = equation.products[1][0] =
      cosine * length * (300. + excess);
    return equation;
  }



  /// The left side at a multiplier, and its derivative with respect to the
  /// unknown.
  ReturnEquation::Value
  evaluate(const ReturnEquation &equation, const double multiplier)
  {
    return equation.evaluate(
      equation.resistance.flow_stress.unknown(std::sqrt(2. / 3.) * multiplier));
  }



  /// Whether the solution changes the sign of the left side, up to rounding,
  /// which the @p exponent of a rate law enlarges.
  bool
  is_solved(const ReturnEquation &equation, const double exponent = 1.)
  {
    const double x        = equation.solve();
    const double rounding = 1e-14 * exponent;
    const double noise    = rounding * evaluate(equation, x).norm;
    return x > 0 && evaluate(equation, x * (1. - rounding)).excess >= -noise &&
           evaluate(equation, x * (1. + rounding)).excess <= noise;
  }



  double
  slope_error(const ReturnEquation &equation)
  {
    double error = 0;
    for (const double x : {1e-4, 1e-3, 1e-2})
      {
        const double unknown =
          equation.resistance.flow_stress.unknown(std::sqrt(2. / 3.) * x);
        const double step     = 1e-5 * unknown;
        const double quotient = (equation.evaluate(unknown + step).excess -
                                 equation.evaluate(unknown - step).excess) /
                                (2. * step);
        error =
          std::max(error,
                   std::abs(quotient / equation.evaluate(unknown).slope - 1.));
      }
    return error;
  }



  void
  check_linear()
  {
    const auto material  = sample_material();
    auto       kinematic = material;
    kinematic.back_stresses.push_back({2000., 0.});
    ReturnEquation equation = equation_of(50., kinematic);
    equation.products[1][1] = 1e4;
    equation.products[0][1] = equation.products[1][0] = 1e4;
    verify("linear laws: closed form",
           std::abs(equation.solve() / (50. / 153000.) - 1.),
           1e-14);
    verify("inside the yield surface: no flow",
           equation_of(-1., material).solve() == 0.);
    verify("data that are no numbers: not a number",
           std::isnan(
             equation_of(std::numeric_limits<double>::quiet_NaN(), material)
               .solve()));
  }



  void
  check_curves()
  {
    const std::vector<HardeningCurve> curves = {
      HardeningCurve({200., 15.}, {400., 0.2, 0.002}, {}),
      HardeningCurve({300., 1e8}, {400., 0.1, 1e-12}, {}),
      HardeningCurve({},
                     {},
                     {{0.0011, 0.},
                      {0.0012, 1e4},
                      {0.01, 1e4},
                      {0.01 + 1e-12, 1e5},
                      {1e3, 1e9}})};
    auto material      = sample_material();
    material.curves[0] = std::make_shared<HardeningCurve>(curves[0]);
    verify("slope with a curve",
           slope_error(equation_of(300., material)),
           1e-6);
    bool solved = true;
    for (const HardeningCurve &curve : curves)
      for (double excess = 1e6; excess > 1e-6; excess *= 0.1)
        {
          material = sample_material();
          material.yield_radius -= std::sqrt(2. / 3.) * curve.value(old_alpha);
          material.curves[0] = std::make_shared<HardeningCurve>(curve);
          solved = solved && is_solved(equation_of(excess, material));
        }
    verify("smooth, steep and kinked curves are solved", solved);
  }



  void
  check_recovery()
  {
    auto material = sample_material();
    for (const double cosine : {-0.3, 0.9})
      verify("slope with recovery",
             slope_error(
               with_back_stress(300., material, 20000., 150., 0.7, cosine)),
             1e-6);
    bool solved = true, decreases = true;
    for (double excess = 1e6; excess > 1e-6; excess *= 0.1)
      for (const double modulus : {1., 1e4, 1e8})
        for (const double recovery : {1e-3, 1e2, 1e8})
          for (const double fraction : {0., 0.5, 1.})
            for (const double cosine : {-1., -0.5, 0., 1.})
              {
                const auto equation = with_back_stress(
                  excess, material, modulus, recovery, fraction, cosine);
                solved = solved && is_solved(equation);
                decreases =
                  decreases && equation.evaluate(equation.solve()).slope <=
                                 -0.999999 * 150000.;
              }
    verify("small and large moduli and rates are solved", solved);
    verify("the left side decreases at least elastically", decreases);
  }



  /// Whatever the exponent, the rate and the duration are.
  void
  check_rates()
  {
    double slope           = 0;
    bool   solved          = true;
    auto   material        = sample_material();
    material.step_duration = 0.1;
    for (const RateLawType type : {RateLawType::perzyna,
                                   RateLawType::norton,
                                   RateLawType::cowper_symonds})
      for (const double exponent : {1., 3.5, 20.})
        for (const double stress : {1e-3, 1e2, 1e6})
          for (const double rate : {1e-30, 1e-3, 1e3, 1e30})
            {
              material.rate_laws[0] = {type, exponent, rate, stress, 1.};
              if (rate == 1e-3)
                slope =
                  std::max(slope, slope_error(equation_of(300., material)));
              for (double excess = 1e6; excess > 1e-6; excess *= 0.1)
                solved =
                  solved && is_solved(equation_of(excess, material), exponent);
            }
    verify("slope with rate dependence", slope, 1e-6);
    verify("slow and fast flow is solved", solved);
    material.step_duration = 0.;
    verify("no time, no flow", equation_of(50., material).solve() == 0.);
  }



  /// No history leads to them; interpolation of states does.
  void
  check_large_back_stresses()
  {
    auto material = sample_material();
    bool solved   = true;
    for (double excess = 1e6; excess > 1e-3; excess *= 0.1)
      for (const double modulus : {1e4, 1e6, 1e8})
        for (const double recovery : {1e2, 1e5})
          for (const double fraction : {1.2, 2., 10.})
            for (const double cosine : {-1., 0., 0.9, 1.})
              solved =
                solved &&
                is_solved(with_back_stress(
                  excess, material, modulus, recovery, fraction, cosine));
    material = sample_material();
    verify("back stresses beyond saturation are solved", solved);
    verify("no finite solution: not a number",
           std::isnan(
             equation_of(std::numeric_limits<double>::infinity(), material)
               .solve()));
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_linear();
  check_curves();
  check_recovery();
  check_rates();
  check_large_back_stresses();
}
