// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/evaluated_bounds.h"
#include "bounds/stress/space_stress_program.h"
#include "bounds/stress/stress_problem.h"
#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the gap between cost and dual cost. Without compliance, the linear
    /// systems are singular, and rounding errors larger.
    constexpr double energy_tolerance = 1e-9;
    constexpr double limit_tolerance  = 1e-6;

    /// Of the stresses with the least energy: ErrorBound is for linear ones.
    constexpr unsigned int energy_degree = 1;

    using OutOfPlaneStress = StressProgram::OutOfPlaneStress;



    /// @p in_plane_strain says what is known of it in plane strain.
    OutOfPlaneStress
    out_of_plane_stress(const Kinematics       kinematics,
                        const OutOfPlaneStress in_plane_strain)
    {
      switch (kinematics)
        {
          case Kinematics::plane_stress:
            return OutOfPlaneStress::zero;
          case Kinematics::axisymmetric:
            return OutOfPlaneStress::circumferential;
          default:
            return in_plane_strain;
        }
    }



    StressProgram
    program_for_energy(const PlaneBody &body)
    {
      return {body,
              out_of_plane_stress(body.kinematics, OutOfPlaneStress::unknown),
              energy_degree};
    }



    SpaceStressProgram
    program_for_energy(const SpaceBody &body)
    {
      return SpaceStressProgram(body);
    }



    template <typename Body>
    auto
    complementary_energy(const Body &body)
    {
      auto program = program_for_energy(body);
      program.add_energy();
      program.add_gap();
      return program;
    }



    template <typename Body>
    auto
    least_energy_with_force(const Body &body, const double force)
    {
      auto program = complementary_energy(body);
      program.prescribe_force(force);
      return program.solve(energy_tolerance);
    }



    template <typename Body>
    auto
    least_energy_with_depth(const Body &body, const double depth)
    {
      auto program = complementary_energy(body);
      program.add_force(-depth);
      auto field  = program.solve(energy_tolerance);
      field.depth = depth;
      return field;
    }



    /// The depth that costs 1 in the units of the body.
    template <typename Body>
    double
    depth_unit(const Body &body)
    {
      return body.strain_unit * body.length_unit;
    }



    template <typename Program, typename Body>
    auto
    largest_load(Program program, const Body &body, const double tolerance)
    {
      if (body.load_factor_unit == 0)
        program.add_force(-depth_unit(body));
      return explain_missing_limit([&]() { return program.solve(tolerance); });
    }
  } // namespace



  StressField
  equilibrate_with_force(const PlaneBody &body, const double force)
  {
    return least_energy_with_force(body, force);
  }



  SpaceStressField
  equilibrate_with_force(const SpaceBody &body, const double force)
  {
    return least_energy_with_force(body, force);
  }



  StressField
  equilibrate_with_depth(const PlaneBody &body, const double depth)
  {
    return least_energy_with_depth(body, depth);
  }



  SpaceStressField
  equilibrate_with_depth(const SpaceBody &body, const double depth)
  {
    return least_energy_with_depth(body, depth);
  }



  StressField
  maximize_load(const PlaneBody &body, const unsigned int degree)
  {
    StressField field =
      largest_load(StressProgram(body,
                                 out_of_plane_stress(body.kinematics,
                                                     OutOfPlaneStress::mean),
                                 degree),
                   body,
                   limit_tolerance);
    for (auto &velocities : field.displacement)
      for (Tensor<1, 2> &velocity : velocities)
        velocity /= depth_unit(body);
    return field;
  }



  SpaceStressField
  maximize_load(const SpaceBody &body, const double tolerance)
  {
    return largest_load(SpaceStressProgram(body), body, tolerance);
  }
} // namespace ElastoPlastic
