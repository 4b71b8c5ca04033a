// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The independent checks of soil. Of velocities: the plastic work of
// polynomials is that of their divergence, and what they lack of dilatation
// that of a uniform rate, in the plane, in revolution and in space; what is
// wrong beside the axis of a body of revolution counts as elsewhere. Of
// stresses: what exceeds the strength is relative to it, also on heavy ground,
// and the pressure of a weight remains where vertices move.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bounds/mechanism/velocity_check.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"
#include "section_body.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Velocity = std::function<Tensor<1, dim>(const Point<dim> &)>;

  constexpr double slope = 0.4, radius = 1.2;

  template <int dim>
  SplitBody<dim>
  make_body(const Kinematics      kinematics,
            const Tensor<1, dim> &body_force = Tensor<1, dim>())
  {
    Triangulation<dim> mesh;
    GridGenerator::subdivided_hyper_cube(mesh, 3);
    SplitBody<dim> body;
    body.mesh        = make_split_mesh(mesh);
    body.kinematics  = kinematics;
    body.body_force  = body_force;
    body.length_unit = body.mesh.size();
    body.stress_unit = body.strain_unit = 1.;
    body.materials.assign(body.mesh.simplices.size(),
                          SectionBody::material(radius, 0.));
    body.conditions.resize(body.mesh.faces.size());
    body.set_friction({slope});
    return body;
  }



  template <int dim>
  std::vector<SimplexVelocity<dim>>
  velocities(const SplitBody<dim> &body, const Velocity<dim> &velocity)
  {
    std::vector<SimplexVelocity<dim>> result;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      result.push_back(
        interpolate_velocity<dim>([&](const Barycentric<dim> &point) {
          return velocity(interpolate(point, body.corners_of(t)));
        }));
    return result;
  }



  template <int dim>
  void
  test_work(const SplitBody<dim>                            &body,
            const Velocity<dim>                             &velocity,
            const std::function<double(const Point<dim> &)> &divergence)
  {
    const auto field   = velocities(body, velocity);
    double     largest = 0.;
    for (unsigned int t = 0; t < field.size(); ++t)
      {
        const auto corners = body.corners_of(t);
        double     mean    = 0.;
        for (const auto &[point, weight] : simplex_quadrature<dim>())
          {
            const Point<dim> x = interpolate(point, corners);
            mean += weight * body.weight(x) * divergence(x);
          }
        const double work = radius / (std::sqrt(2.) * slope) * body.angle() *
                            volume(corners) * mean;
        largest =
          std::max(largest,
                   std::abs(work_of_soil(body, field[t], t) / work - 1.));
      }
    verify("plastic work", largest, 1e-12);
    verify("admissible", check_velocity(body, field).largest(), 1e-12);
  }



  /// With the rates -1 along the last axis and @p across along the others, the
  /// rate of shear is (1 + across) times a factor.
  template <int dim>
  void
  test_missing_dilatation(const SplitBody<dim> &body, const double factor)
  {
    constexpr double across = 0.3;
    const auto       field =
      velocities<dim>(body, [](const Point<dim> &x) -> Tensor<1, dim> {
        Tensor<1, dim> v = across * x;
        v[dim - 1]       = -x[dim - 1];
        return v;
      });
    const double theta =
      across * (dim == 3 || body.is_axisymmetric() ? 2. : 1.) - 1.;
    const double missing = slope * factor * (1. + across) - theta;
    double       largest = 0.;
    for (unsigned int t = 0; t < field.size(); ++t)
      {
        const double size = std::pow(volume(body.corners_of(t)), 1. / dim);
        largest           = std::max(largest,
                           std::abs(missing_dilatation(body, field[t], t) -
                                    missing * size));
      }
    verify("missing dilatation", largest, 1e-12);
  }



  /// Velocities x, of which one triangle at the axis has another.
  void
  test_axis(const SplitBody<2> &body)
  {
    constexpr double change = 1e-6;
    const auto field = velocities<2>(body, [](const Point<2> &x) { return x; });
    unsigned int at_axis = 0;
    while (body.corners_of(at_axis)[0][0] > 1e-9 ||
           body.corners_of(at_axis)[1][0] > 1e-9)
      ++at_axis;
    auto damaged = field;
    for (auto &coefficient : damaged[at_axis].coefficients)
      coefficient[1] += change;
    verify("jump beside the axis",
           std::abs(check_velocity(body, damaged).separation / change - 1.),
           0.3);

    damaged = field;
    for (auto &coefficient : damaged[at_axis].coefficients)
      coefficient[0] += change;
    verify("radial velocity on the axis",
           missing_dilatation(body, damaged[at_axis], at_axis) >=
             change * (1. - 1e-6));
  }



  /// With the mean stress @p mean, and a deviator that is greater than the
  /// strength by a part @p excess of it.
  StressField<2>
  uniform_stress(const SplitBody<2> &body,
                 const double        mean,
                 const double        excess)
  {
    const double strength = radius - std::sqrt(2.) * slope * mean,
                 shear    = (1. + excess) * strength / std::sqrt(2.);
    StressField<2> field;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        std::vector<double> values;
        for (unsigned int k = 0; k < JohnsonMercier<2>::n_parts; ++k)
          for (const Point<2> &x :
               JohnsonMercier<2>::part_of(body.corners_of(t), k))
            {
              const double with_weight =
                mean + body.pressure_of_body_force(x, 0.);
              values.insert(
                values.end(),
                {with_weight + shear, with_weight - shear, 0., with_weight});
            }
        field.values.emplace_back(values.begin(), values.end());
      }
    return field;
  }



  void
  test_strength()
  {
    constexpr double excess = 1e-3;
    const auto       heavy =
      make_body<2>(Kinematics::cartesian, Tensor<1, 2>({0., -100.}));
    verify("a unit of stress that is much more than the cohesion",
           heavy.stress_unit > 10. * radius);
    const auto error = [&](const double mean) {
      return check_stress(heavy, uniform_stress(heavy, mean, excess))
        .yield_excess;
    };
    verify("excess over the strength under pressure",
           std::abs(error(-1.) / excess - 1.),
           1e-9);
    verify("excess over the strength under tension",
           std::abs(
             error(1.) / (excess * (1. - std::sqrt(2.) * slope / radius)) - 1.),
           1e-9);
    auto moved = heavy;
    for (Point<2> &vertex : moved.mesh.vertices)
      vertex += Tensor<1, 2>({0.1, 0.1});
    const Point<2> x(0.3, 0.4);
    verify("pressure of the weight",
           moved.pressure_of_body_force(x, 0.) ==
             heavy.pressure_of_body_force(x, 0.));
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  output() << "Plane strain" << std::endl;
  const auto plane = make_body<2>(Kinematics::cartesian);
  test_work<2>(
    plane,
    [](const Point<2> &x) {
      return Tensor<1, 2>(
        {x[0] + 0.1 * x[0] * x[1], x[1] - 0.05 * x[0] * x[0]});
    },
    [](const Point<2> &x) { return 2. + 0.1 * x[1]; });
  test_missing_dilatation(plane, 1.);

  output() << "Revolution" << std::endl;
  const auto revolution = make_body<2>(Kinematics::axisymmetric);
  test_work<2>(
    revolution,
    [](const Point<2> &x) {
      return Tensor<1, 2>(
        {x[0] * (1. + 0.1 * x[0] * x[1]), x[1] + 0.05 * x[0] * x[1] * x[1]});
    },
    [](const Point<2> &x) { return 3. + 0.4 * x[0] * x[1]; });
  test_missing_dilatation(revolution, std::sqrt(4. / 3.));
  test_axis(revolution);

  output() << "Space" << std::endl;
  const auto space = make_body<3>(Kinematics::cartesian);
  test_work<3>(
    space,
    [](const Point<3> &x) {
      return Tensor<1, 3>({x[0] + 0.1 * x[1] * x[2],
                           x[1] - 0.1 * x[0] * x[1],
                           x[2] + 0.05 * x[2] * x[2]});
    },
    [](const Point<3> &x) { return 3. - 0.1 * x[0] + 0.1 * x[2]; });
  test_missing_dilatation(space, std::sqrt(4. / 3.));

  output() << "Stresses" << std::endl;
  test_strength();
}
