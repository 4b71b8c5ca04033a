// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/stress/stress_field.h"
#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the stresses with the least energy: ErrorBound is for linear ones.
    constexpr unsigned int energy_degree = 1;

    /// @p in_plane_strain says what is known of it in plane strain.
    template <int dim>
    OutOfPlane
    out_of_plane_stress(const Kinematics kinematics,
                        const OutOfPlane in_plane_strain)
    {
      if (dim == 3)
        return OutOfPlane::like_others;
      switch (kinematics)
        {
          case Kinematics::plane_stress:
            return OutOfPlane::zero;
          case Kinematics::axisymmetric:
            return OutOfPlane::circumferential;
          default:
            return in_plane_strain;
        }
    }



    template <int dim>
    StressProgram<dim>
    complementary_energy(const SplitBody<dim> &body)
    {
      StressProgram<dim> program(body,
                                 out_of_plane_stress<dim>(body.kinematics,
                                                          OutOfPlane::unknown),
                                 energy_degree);
      program.add_energy();
      program.add_gap();
      return program;
    }



    /// The stresses with the largest force. @throws ConvergenceError or
    /// EquilibriumError that says why there are none.
    template <int dim>
    StressField<dim>
    solve_or_explain(StressProgram<dim> &program, const double tolerance)
    {
      try
        {
          return program.solve(tolerance);
        }
      catch (const UnboundedError &)
        {
          throw ConvergenceError(
            "There is no limit load: the supports enclose the body, which "
            "bears any load, or the indenter reaches a point that is held. Let "
            "'Indenter/Reach' end before what is held.");
        }
      catch (const NoSolutionError &)
        {
          throw EquilibriumError(
            "No stresses on this mesh bear the constant loads alone, those in "
            "'Boundary conditions/Traction' and 'Body force'. Prescribe "
            "smaller ones, begin with a finer mesh if the body should just "
            "bear them, or look for the part of them that it bears with "
            "'Limit load/Load = tractions'.");
        }
    }
  } // namespace



  template <int dim>
  StressField<dim>
  equilibrate_with_force(const SplitBody<dim> &body, const double force)
  {
    auto program = complementary_energy(body);
    program.prescribe_force(force);
    return program.solve(Tolerance::gap_of_energy);
  }



  template <int dim>
  StressField<dim>
  equilibrate_with_depth(const SplitBody<dim> &body, const double depth)
  {
    auto program = complementary_energy(body);
    program.add_force(-depth);
    auto field  = program.solve(Tolerance::gap_of_energy);
    field.depth = depth;
    return field;
  }



  template <int dim>
  StressField<dim>
  maximize_load(const SplitBody<dim>      &body,
                const unsigned int         degree,
                const double               tolerance,
                const std::vector<double> &expected_multipliers)
  {
    const double depth_unit = body.strain_unit * body.length_unit;

    StressProgram<dim> program(body,
                               out_of_plane_stress<dim>(body.kinematics,
                                                        OutOfPlane::mean),
                               degree);
    if (body.load_factor_unit == 0)
      program.add_force(-depth_unit);
    program.expect_multipliers(expected_multipliers);
    StressField<dim> field = solve_or_explain(program, tolerance);
    for (auto &velocities : field.displacement)
      for (auto &velocity : velocities)
        velocity /= depth_unit;
    return field;
  }



  template StressField<2>
  equilibrate_with_force(const SplitBody<2> &, const double);
  template StressField<3>
  equilibrate_with_force(const SplitBody<3> &, const double);
  template StressField<2>
  equilibrate_with_depth(const SplitBody<2> &, const double);
  template StressField<3>
  equilibrate_with_depth(const SplitBody<3> &, const double);
  template StressField<2>
  maximize_load(const SplitBody<2> &,
                const unsigned int,
                const double,
                const std::vector<double> &);
  template StressField<3>
  maximize_load(const SplitBody<3> &,
                const unsigned int,
                const double,
                const std::vector<double> &);
} // namespace ElastoPlastic
