// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Hardening curves: closed forms, slope and integral against differences and
// quadrature, and what is known of their shape.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <iomanip>

#include "material/hardening_curve.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const HardeningCurve::Voce               no_voce;
  const HardeningCurve::PowerLaw           no_power_law;
  const std::vector<HardeningCurve::Point> no_table;

  const HardeningCurve voce({200., 15.}, no_power_law, no_table);
  const HardeningCurve power(no_voce, {400., 0.2, 0.002}, no_table);
  const HardeningCurve
    table(no_voce, no_power_law, {{0.01, 50.}, {0.05, 90.}, {0.1, 90.}});
  const HardeningCurve sum({200., 15.},
                           {400., 0.2, 0.002},
                           {{0.01, 50.}, {0.05, 90.}, {0.1, 90.}});
  const HardeningCurve convex(no_voce, no_power_law, {{0.01, 0.}, {0.05, 90.}});



  /// The points of the tables are ends of the intervals.
  void
  check_calculus(const std::string &name, const HardeningCurve &curve)
  {
    const dealii::QGauss<1> quadrature(8);
    const double            step  = 1e-6;
    double                  slope = 0, integral = 0;
    double                  last_alpha = 0, last_integral = 0;
    for (double alpha = 0.0005; alpha < 0.3; alpha += 0.0005)
      {
        const double middle  = alpha - 0.00025;
        slope                = std::max(slope,
                         std::abs((curve.value(middle + step) -
                                   curve.value(middle - step)) /
                                    (2 * step) -
                                  curve.slope(middle)) /
                           (1. + curve.slope(middle)));
        double by_quadrature = 0;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          by_quadrature += curve.value(last_alpha + quadrature.point(q)[0] *
                                                      (alpha - last_alpha)) *
                           quadrature.weight(q) * (alpha - last_alpha);
        integral      = std::max(integral,
                            std::abs(curve.integral(alpha) - last_integral -
                                     by_quadrature) /
                              by_quadrature);
        last_alpha    = alpha;
        last_integral = curve.integral(alpha);
      }
    output() << name << " at 0, 0.002, 0.03, 0.2: " << curve.value(0.) << ' '
             << curve.value(0.002) << ' ' << curve.value(0.03) << ' '
             << curve.value(0.2) << std::endl;
    verify("  integral from 0", curve.integral(0.) == 0.);
    verify("  slope", slope, 1e-6);
    verify("  integral", integral, 1e-9);
  }



  void
  check_closed_forms()
  {
    const double alpha = 0.03;
    verify("Voce",
           std::abs(voce.value(alpha) - 200. * (1. - std::exp(-0.45))),
           1e-11);
    verify("Voce, slope",
           std::abs(voce.slope(alpha) - 3000. * std::exp(-0.45)),
           1e-9);
    verify("power law",
           std::abs(power.value(alpha) - 400. * (std::pow(16., 0.2) - 1.)),
           1e-10);
    verify("power law, slope",
           std::abs(power.slope(alpha) - 40000. * std::pow(16., -0.8)),
           1e-8);
    verify("table",
           std::abs(table.value(alpha) - 70.) +
             std::abs(table.slope(alpha) - 1000.),
           1e-9);
    verify("table at and beyond its points",
           table.value(0.01) == 50. && table.slope(0.01) < 1001. &&
             table.value(1.) == 90. && table.slope(1.) == 0.);
    verify("a sum",
           std::abs(sum.value(alpha) - voce.value(alpha) - power.value(alpha) -
                    table.value(alpha)),
           1e-10);
    verify("without anything",
           HardeningCurve(no_voce, no_power_law, no_table).value(1.) == 0.);
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << std::fixed << std::setprecision(6);
  check_closed_forms();
  check_calculus("Voce", voce);
  check_calculus("power law", power);
  check_calculus("table", table);
  check_calculus("sum", sum);
  verify("bounded", voce.is_bounded() && table.is_bounded());
  verify("not bounded", !power.is_bounded() && !sum.is_bounded());
  verify("concave", voce.is_concave() && table.is_concave());
  verify("not concave", !convex.is_concave());
}
