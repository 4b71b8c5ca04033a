// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/evaluated_bounds.h"
#include "equilibrium/stress_problem.h"
#include "equilibrium/stress_program.h"

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
    complementary_energy(const PlaneBody &body)
    {
      StressProgram program(body,
                            out_of_plane_stress(body.kinematics,
                                                OutOfPlaneStress::unknown),
                            energy_degree);
      program.add_energy();
      program.add_gap();
      return program;
    }



    StressField
    solve_bounded(const StressProgram &program)
    {
      return explain_missing_limit(
        [&]() { return program.solve(limit_tolerance); });
    }
  } // namespace



  StressField
  equilibrate_with_force(const PlaneBody &body, const double force)
  {
    StressProgram program = complementary_energy(body);
    program.prescribe_force(force);
    return program.solve(energy_tolerance);
  }



  StressField
  equilibrate_with_depth(const PlaneBody &body, const double depth)
  {
    StressProgram program = complementary_energy(body);
    program.add_force(-depth);
    StressField field = program.solve(energy_tolerance);
    field.depth       = depth;
    return field;
  }



  StressField
  maximize_load(const PlaneBody &body, const unsigned int degree)
  {
    StressProgram program(body,
                          out_of_plane_stress(body.kinematics,
                                              OutOfPlaneStress::mean),
                          degree);
    const double  unit = body.strain_unit * body.length_unit;
    if (body.load_factor_unit == 0)
      program.add_force(-unit);
    StressField field = solve_bounded(program);
    for (auto &velocities : field.displacement)
      for (Tensor<1, 2> &velocity : velocities)
        velocity /= unit;
    return field;
  }
} // namespace ElastoPlastic
