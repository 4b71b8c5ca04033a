// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_soil_bounds_h
#define tests_soil_bounds_h

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "bounds/limit_load.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/stress_check.h"
#include "material/yield_criterion_parameters.h"
#include "section_body.h"
#include "verdict.h"

// Bodies of soil, and bounds of their limit loads, looked at.

namespace SoilBounds
{
  using namespace ElastoPlastic;

  /// With the cohesion 1.
  inline SoilParameters
  soil(const double degrees)
  {
    SoilParameters parameters;
    parameters.cohesions       = {1.};
    parameters.friction_angles = {degrees};
    return parameters;
  }



  /// The pressure along one axis that goes with the pressure @p q across, where
  /// the body becomes shorter along the axis: the deviator is sqrt(2/3) (p -
  /// q), and the mean stress -(p + 2 q) / 3.
  inline double
  pressure_in_compression(const double degrees, const double q)
  {
    const auto [radius, slope] = soil(degrees).drucker_prager(0);
    const double a = std::sqrt(2. / 3.), b = std::sqrt(2.) * slope / 3.;
    return (radius + q * (a + 2. * b)) / (a - b);
  }



  /// The traction on the side of ground as an expression of the height, which
  /// is 0 at its surface: with it, the stress is that of compression by this
  /// @p weight, everywhere.
  inline std::string
  traction_beside_heavy_ground(const double       degrees,
                               const double       weight,
                               const std::string &height)
  {
    const double without = pressure_in_compression(degrees, 0.),
                 slope   = pressure_in_compression(degrees, 1.) - without;
    std::ostringstream text;
    text.precision(16);
    text << '(' << without << " + " << weight << '*' << height << ")/" << slope;
    return text.str();
  }



  /// A body with the cohesion 1 and these @p angles of friction, by material
  /// id, in degrees. Tractions and @p weight grow unless it is in contact.
  template <int dim>
  SplitBody<dim>
  make_body(const SplitMesh<dim>              &mesh,
            const BoundaryNames               &names,
            const BoundaryConditionParameters &parameters,
            const IndenterOnBody<dim>         &indenter,
            const std::vector<double>         &angles,
            const Kinematics                   kinematics,
            const std::string &weight = dim == 2 ? "0; 0" : "0; 0; 0")
  {
    const bool is_plane = dim == 2 && kinematics == Kinematics::cartesian;
    std::vector<Material<double>> materials;
    std::vector<double>           slopes;
    for (const double degrees : angles)
      {
        const auto [radius, slope] = is_plane ? soil(degrees).mohr_coulomb(0) :
                                                soil(degrees).drucker_prager(0);
        materials.push_back(
          SectionBody::material(radius, /* hardening = */ 0.));
        slopes.push_back(slope);
      }
    const BoundaryConditions<dim> conditions(parameters, names);
    const BodyForce<dim>          body_force(weight);
    auto                          body =
      make_split_body<dim>(mesh,
                           conditions,
                           materials,
                           indenter,
                           parameters.contact.empty() ?
                             Loads<dim>::growing(mesh, conditions, body_force) :
                             Loads<dim>(/* time = */ 0., body_force),
                           kinematics);
    body.set_friction(slopes);
    return body;
  }



  /// Verifies that stress and velocity are admissible, and that the gaps of the
  /// simplices are not negative and add up to the difference of the bounds,
  /// which are those of stresses of this @p degree. What the velocity violates
  /// is rounding: in rings much wider than thick, what is left of differences
  /// of large numbers.
  template <int dim>
  LimitLoad<dim>
  checked_bounds(const SplitBody<dim> &body,
                 const unsigned int    degree,
                 const double          rounding = 1e-12)
  {
    const auto bounds = bound_limit_load(body, degree);
    verify("admissible stress",
           check_stress(body, bounds.stress).largest(),
           1e-9);
    verify("admissible velocity", bounds.velocity.error, rounding);
    const double power =
      body.load_factor_unit > 0 ?
        power_of_loads(body, bounds.velocity.velocity).growing :
        1.;
    verify("gaps",
           std::all_of(bounds.gaps.begin(),
                       bounds.gaps.end(),
                       [](const double gap) { return gap > -1e-6; }));
    verify("sum of the gaps",
           std::abs(
             std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) /
               power -
             (bounds.upper_bound - bounds.lower_bound)),
           1e-5 * bounds.upper_bound);
    return bounds;
  }
} // namespace SoilBounds

#endif
