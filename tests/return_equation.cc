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
  /// A stress @p excess beyond the yield surface, without nonlinear terms.
  ReturnEquation
  equation_of(const double excess)
  {
    ReturnEquation equation;
    equation.elastic_modulus           = 150000.;
    equation.isotropic_modulus         = 1000.;
    equation.radius                    = 300.;
    equation.equivalent_plastic_strain = 0.001;
    equation.curve                     = nullptr;
    equation.products[0][0]            = std::pow(300. + excess, 2);
    return equation;
  }



  /// The same with a back stress of the length @p fraction c / g, at an angle
  /// with the trial stress that has the given @p cosine.
  ReturnEquation
  with_back_stress(const double excess,
                   const double modulus,
                   const double recovery,
                   const double fraction,
                   const double cosine)
  {
    ReturnEquation equation = equation_of(excess);
    equation.back_stresses.push_back({modulus, recovery});
    const double length     = fraction * modulus / recovery;
    equation.products[1][1] = length * length;
    equation.products[0][1] = equation.products[1][0] =
      cosine * length * (300. + excess);
    return equation;
  }



  /// Whether the solution changes the sign of the left side, up to rounding.
  bool
  is_solved(const ReturnEquation &equation)
  {
    const double x     = equation.solve();
    const auto   value = equation.evaluate(x);
    const double noise = 1e-14 * value.norm;
    return x > 0 && equation.evaluate(x * (1. - 1e-14)).excess >= -noise &&
           equation.evaluate(x * (1. + 1e-14)).excess <= noise;
  }



  double
  slope_error(const ReturnEquation &equation)
  {
    double error = 0;
    for (const double x : {1e-4, 1e-3, 1e-2})
      {
        const double step     = 1e-5 * x;
        const double quotient = (equation.evaluate(x + step).excess -
                                 equation.evaluate(x - step).excess) /
                                (2. * step);
        error =
          std::max(error, std::abs(quotient / equation.evaluate(x).slope - 1.));
      }
    return error;
  }



  void
  check_linear()
  {
    ReturnEquation equation = equation_of(50.);
    equation.back_stresses.push_back({2000., 0.});
    equation.products[1][1] = 1e4;
    equation.products[0][1] = equation.products[1][0] = 1e4;
    verify("linear laws: closed form",
           std::abs(equation.solve() / (50. / 153000.) - 1.),
           1e-14);
    verify("inside the yield surface: no flow", equation_of(-1.).solve() == 0.);
    verify("data that are no numbers: not a number",
           std::isnan(
             equation_of(std::numeric_limits<double>::quiet_NaN()).solve()));
  }



  void
  check_curves()
  {
    const HardeningCurve smooth({200., 15.}, {400., 0.2, 0.002}, {});
    const HardeningCurve steep({300., 1e8}, {400., 0.1, 1e-12}, {});
    const HardeningCurve kinks({},
                               {},
                               {{0.0011, 0.},
                                {0.0012, 1e4},
                                {0.01, 1e4},
                                {0.01 + 1e-12, 1e5},
                                {1e3, 1e9}});
    ReturnEquation       equation = equation_of(300.);
    equation.curve                = &smooth;
    verify("slope with a curve", slope_error(equation), 1e-6);
    bool solved = true;
    for (const HardeningCurve *curve : {&smooth, &steep, &kinks})
      for (double excess = 1e6; excess > 1e-6; excess *= 0.1)
        {
          equation        = equation_of(excess);
          equation.radius = 300. - std::sqrt(2. / 3.) * curve->value(0.001);
          equation.curve  = curve;
          solved          = solved && is_solved(equation);
        }
    verify("smooth, steep and kinked curves are solved", solved);
  }



  void
  check_recovery()
  {
    verify(
      "slope with recovery",
      std::max(slope_error(with_back_stress(300., 20000., 150., 0.7, -0.3)),
               slope_error(with_back_stress(300., 20000., 150., 0.7, 0.9))),
      1e-6);
    bool solved = true, decreases = true;
    for (double excess = 1e6; excess > 1e-6; excess *= 0.1)
      for (const double modulus : {1., 1e4, 1e8})
        for (const double recovery : {1e-3, 1e2, 1e8})
          for (const double fraction : {0., 0.5, 1.})
            for (const double cosine : {-1., -0.5, 0., 1.})
              {
                const auto equation =
                  with_back_stress(excess, modulus, recovery, fraction, cosine);
                solved = solved && is_solved(equation);
                decreases =
                  decreases && equation.evaluate(equation.solve()).slope <=
                                 -0.999999 * 150000.;
              }
    verify("small and large moduli and rates are solved", solved);
    verify("the left side decreases at least elastically", decreases);
  }



  /// No history leads to them; interpolation of states does.
  void
  check_large_back_stresses()
  {
    bool solved = true;
    for (double excess = 1e6; excess > 1e-3; excess *= 0.1)
      for (const double modulus : {1e4, 1e6, 1e8})
        for (const double recovery : {1e2, 1e5})
          for (const double fraction : {1.2, 2., 10.})
            for (const double cosine : {-1., 0., 0.9, 1.})
              solved =
                solved && is_solved(with_back_stress(
                            excess, modulus, recovery, fraction, cosine));
    verify("back stresses beyond saturation are solved", solved);
    verify("no finite solution: not a number",
           std::isnan(
             equation_of(std::numeric_limits<double>::infinity()).solve()));
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_linear();
  check_curves();
  check_recovery();
  check_large_back_stresses();
}
