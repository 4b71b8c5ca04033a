// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Velocities given by hand: their plastic work, exact or slightly more, and
// what the check finds wrong with those that are not admissible; where they
// slip.

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>

#include "bounds/equilibrium_output.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/inverse_square.h"
#include "bounds/stress/johnson_mercier.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double k = 1. / std::sqrt(3.); // the yield stress is 1



  Material<double>
  material(const double yield_stress)
  {
    Material<double> material;
    material.bulk_modulus  = 800.;
    material.shear_modulus = 400.;
    material.yield_radius  = std::sqrt(2. / 3.) * yield_stress;
    return material;
  }



  /// The rectangle between x = @p left and @p left + 1, and y = -1 and 0, of 2
  /// x 2 cells. It is fixed below; the indenter reaches all of its top. The
  /// upper half is stronger.
  SplitBody<2>
  make_body(const Kinematics kinematics, const double left)
  {
    static BoundaryConditionParameters parameters;
    parameters.free    = {"left", "right"};
    parameters.fixed   = {"bottom"};
    parameters.contact = {"top"};
    static const BoundaryConditions<2> conditions(
      parameters, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
    Triangulation<2> mesh;
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              {2, 2},
                                              Point<2>(left, -1.),
                                              Point<2>(left + 1., 0.),
                                              /* colorize = */ true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center()[1] > -0.5 ? 1 : 0);
    return make_split_body<2>(make_split_mesh(mesh),
                              conditions,
                              {material(1.), material(2.)},
                              {[](const Point<2> &) {
                                return 0.;
                              }},
                              /* time = */ 0.,
                              kinematics);
  }



  using Velocities = std::vector<SimplexVelocity<2>>;

  /// Interpolates cubic velocities.
  template <typename Function>
  Velocities
  interpolate(const SplitBody<2> &body, const Function &velocity)
  {
    Velocities result;
    for (const auto &triangle : body.mesh.simplices)
      {
        const auto corners = body.mesh.corners(triangle);
        result.push_back(
          interpolate_velocity<2>([&](const Barycentric<2> &point) {
            return velocity(ElastoPlastic::interpolate(point, corners),
                            body.mesh.cells[triangle.cell].material_id);
          }));
      }
    return result;
  }



  double
  total_work(const SplitBody<2> &body, const Velocities &velocities)
  {
    const auto work = plastic_work(body, velocities);
    return std::accumulate(work.begin(), work.end(), 0.);
  }



  /// How many lines the output of the places has where a mechanism slips.
  unsigned int
  n_slip_lines(const SplitBody<2> &body, const Velocities &velocities)
  {
    OutputParameters parameters;
    parameters.directory = ".";
    SlipOutput<2>(parameters).write(body, velocities, 0);
    std::ostringstream text;
    text << std::ifstream("slip_lines-000.vtu").rdbuf();
    const std::string key = "NumberOfCells=\"";
    return std::stoi(text.str().substr(text.str().find(key) + key.size()));
  }



  // The upper half slides along the lower one, which does not move: the weaker
  // of them yields.
  void
  test_slip()
  {
    const SplitBody<2> body = make_body(Kinematics::cartesian, 0.);
    const Velocities   velocity =
      interpolate(body,
                  [](const Point<2> &, const types::material_id material) {
                    return Tensor<1, 2>({material == 1 ? 0.3 : 0., 0.});
                  });
    output() << "A half that slides on the other" << std::endl;
    verify("work", std::abs(total_work(body, velocity) - 0.3 * k), 1e-14);
    verify("nothing separates",
           check_velocity(body, velocity).separation,
           1e-14);
    // (two sides of four parts)
    verify("slip lines", n_slip_lines(body, velocity) == 8);
  }



  // The base is fixed: the contraction slides along it. The work is
  // int (1 or 2) dV + 2 pi int k r r/2 dr.
  void
  test_upsetting()
  {
    const SplitBody<2> body = make_body(Kinematics::axisymmetric, 0.);
    const Velocities   velocity =
      interpolate(body, [](const Point<2> &x, const types::material_id) {
        return Tensor<1, 2>({0.5 * x[0], -1. - x[1]});
      });
    const double exact =
      numbers::PI * (0.5 * 1. + 0.5 * 2.) + 2. * numbers::PI * k / 6.;
    const auto errors = check_velocity(body, velocity);
    output() << "Upsetting of a cylinder" << std::endl;
    verify("work", std::abs(total_work(body, velocity) / exact - 1.), 1e-14);
    verify("volume", errors.divergence, 1e-14);
    verify("supports", errors.separation, 1e-14);
    verify("slip lines along the base", n_slip_lines(body, velocity) == 8);
  }



  // v_r = 1/r is that of the flux (0, -1): |e| = sqrt(2) / r^2 takes the work
  // 2 pi int sqrt(4/3) / r dr times 1 or 2, and what slides along the base k.
  void
  test_flux()
  {
    const SplitBody<2> body = make_body(Kinematics::axisymmetric, 1.);
    SimplexVelocity<2> outward;
    outward.flux[1] = -1.;
    const Velocities velocity(body.mesh.simplices.size(), outward);
    const double     exact =
      2. * numbers::PI * (std::sqrt(4. / 3.) * std::log(2.) * 1.5 + k);
    const double work = total_work(body, velocity);
    output() << "Flow out of a tube" << std::endl;
    verify("not less work", work >= exact);
    verify("hardly more", work / exact - 1., 1e-3);
    verify("volume", check_velocity(body, velocity).divergence, 1e-14);
  }



  void
  test_inverse_square()
  {
    const InverseSquare inverse_square(1., 1.5);
    double              error = 0;
    for (double r = 1.; r <= 1.5; r += 0.01)
      error = std::max(error, std::abs(inverse_square(r) - 1. / (r * r)));
    output() << "Polynomial for 1 / r^2" << std::endl;
    verify("within its error", error <= inverse_square.error());
    verify("which is not much larger", inverse_square.error() < 4. * error);
  }



  // Each stream function of an element conserves the volume, and its rates are
  // those of its velocity.
  void
  test_element(const Kinematics kinematics, const std::string &title)
  {
    const SplitBody<2>  body    = make_body(kinematics, 1.);
    const bool          is_ring = kinematics == Kinematics::axisymmetric;
    const StreamElement element(body, 3, is_ring);
    const auto          rates      = element.rates();
    const unsigned int  n          = element.n_rate_components();
    double              divergence = 0, difference = 0, largest = 0;
    for (unsigned int f = 0; f < element.functions.size(); ++f)
      {
        Velocities velocity(body.mesh.simplices.size());
        velocity[3] = element.functions[f];
        divergence =
          std::max(divergence, check_velocity(body, velocity).divergence);
        // The coefficient of a corner is the value there.
        for (unsigned int corner = 0; corner < 3; ++corner)
          {
            Barycentric<2> point = {};
            point[corner]        = 1.;
            double square        = 0;
            for (unsigned int c = 0; c < n; ++c)
              square += std::pow(rates.rates(n * corner + c, f), 2);
            const double exact =
              strain_rate_at(body, velocity[3], 3, point).norm();
            largest = std::max(largest, exact);
            difference =
              std::max(difference, std::abs(std::sqrt(square) - exact));
          }
      }
    output() << title << std::endl;
    verify("volume", divergence, 1e-12);
    verify("rates", difference / largest, is_ring ? 1e-3 : 1e-12);
  }



  void
  test_errors()
  {
    const SplitBody<2> body = make_body(Kinematics::cartesian, 0.);
    output() << "What is not admissible" << std::endl;
    const auto dilation =
      interpolate(body, [](const Point<2> &x, const types::material_id) {
        return Tensor<1, 2>({0., -1. - x[1]});
      });
    verify("change of volume", check_velocity(body, dilation).divergence > 0.2);
    verify("depth", std::abs(lowest_depth(body, dilation) - 1.), 1e-14);
    const auto opening =
      interpolate(body,
                  [](const Point<2> &, const types::material_id material) {
                    return Tensor<1, 2>({0., material == 1 ? 1. : 0.});
                  });
    const auto errors = check_velocity(body, opening);
    verify("a gap opens", errors.separation > 0.9);
    verify("penetration", errors.penetration > 1.9);
    const auto sinking =
      interpolate(body, [](const Point<2> &, const types::material_id) {
        return Tensor<1, 2>({0., -1.});
      });
    verify("moves through the base",
           check_velocity(body, sinking).separation > 0.9);
    Velocities no_number = sinking;
    no_number[0].coefficients[0] *= std::numeric_limits<double>::quiet_NaN();
    verify("no number",
           std::isinf(check_velocity(body, no_number).divergence) &&
             std::isinf(check_velocity(body, no_number).separation));
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_slip();
  test_upsetting();
  test_flux();
  test_inverse_square();
  test_element(Kinematics::cartesian, "Stream functions in plane strain");
  test_element(Kinematics::axisymmetric, "Stream functions around an axis");
  test_errors();
}
