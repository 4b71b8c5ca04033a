// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_basis.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What forces, multiplied by weighted velocities, are divided by.
    template <int dim>
    double
    weighted_force_unit(const SplitBody<dim> &body)
    {
      return body.force_unit() / body.angle();
    }



    /// What the functions of the simplices beside a face do there.
    template <int dim>
    struct FunctionsOnFace
    {
      std::vector<unsigned int> equations;
      /// By functions: the coefficients of the weighted velocities, those of
      /// the second neighbour with the opposite sign.
      std::vector<std::vector<Tensor<1, dim>>> jumps;

      FunctionsOnFace(const SplitBody<dim>     &body,
                      const VelocityBasis<dim> &basis,
                      const unsigned int        degree,
                      const FaceView<dim>      &view)
      {
        for (unsigned int i = 0; i < view.face.n_neighbors(); ++i)
          for (const auto &function :
               basis.on_simplices[view.face.neighbors[i]])
            {
              equations.push_back(function.number);
              jumps.push_back(Bernstein<dim - 1>::interpolate(
                degree, [&](const auto &position) {
                  return (i == 0 ? 1. : -1.) *
                         weighted_velocity(body,
                                           function.velocity,
                                           view.face.neighbors[i],
                                           view.point(position, i));
                }));
            }
      }

      /// A row with coefficient @p p of all in one direction.
      void
      fill(FullMatrix<double>   &matrix,
           const unsigned int    row,
           const unsigned int    p,
           const Tensor<1, dim> &direction) const
      {
        for (unsigned int f = 0; f < jumps.size(); ++f)
          matrix(row, f) = jumps[f][p] * direction;
      }
    };



    // In space, where velocities are linear, few functions count for each
    // coefficient, which has a block of its own. Where the weight vanishes on
    // the axis, so do coefficients.
    template <int dim>
    void
    add_face(ConicProgram             &program,
             const SplitBody<dim>     &body,
             const VelocityBasis<dim> &basis,
             const unsigned int        degree,
             const FaceView<dim>      &view)
    {
      const auto weights =
        Bernstein<dim - 1>::interpolate(degree, [&](const auto &position) {
          return body.weight(interpolate(position, view.corners));
        });
      const FunctionsOnFace<dim> functions(body, basis, degree, view);
      const unsigned int         n = weights.size();
      const double               share =
        view.area * body.stress_unit / n / weighted_force_unit(body);
      const auto           along   = tangents(view.corners);
      const Tensor<1, dim> outward = view.condition.contact().direction;
      std::vector<DissipationBlock> blocks(
        dim == 2 ? 1 : n, DissipationBlock(functions.equations.size()));
      for (unsigned int p = 0; p < n; ++p)
        {
          DissipationBlock  &block = blocks[p % blocks.size()];
          FullMatrix<double> slips(dim - 1, functions.jumps.size()),
            work(slips.m(), slips.n()), against(1, slips.n());
          for (unsigned int d = 0; d + 1 < dim; ++d)
            functions.fill(slips, d, p, along[d]);
          functions.fill(against, 0, p, outward);
          if (view.resists_slip())
            {
              slip_factor(body, view.number).mmult(work, slips);
              block.add_norm(work,
                             0,
                             dim - 1,
                             share,
                             body.shear_strength(view.number) /
                               body.stress_unit);
            }
          const double bound = weights[p] * (view.support.velocity * outward);
          if (view.condition.is_reached &&
              std::max(against.linfty_norm(), std::abs(bound)) >
                Tolerance::on_axis * body.weight_unit())
            block.add_condition(against, 0, share, bound);
        }
      for (const DissipationBlock &block : blocks)
        if (!block.empty())
          program.blocks.push_back(block.make(functions.equations));
    }
  } // namespace



  template <int dim>
  ConicProgram
  program_of_loads(const SplitBody<dim> &body, const VelocityBasis<dim> &basis)
  {
    ConicProgram program;
    program.set_equations(basis.size, body.load_factor_unit > 0);
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      for (const auto &[point, constant, growing] : forces_on(body, t))
        for (const auto &[number, function] : basis.on_simplices[t])
          {
            const Tensor<1, dim> velocity =
              weighted_velocity(body, function, t, point) /
              weighted_force_unit(body);
            program.add_load(number,
                             constant * velocity,
                             body.load_factor_unit * growing * velocity);
          }
    return program;
  }



  template <int dim>
  void
  add_faces(ConicProgram             &program,
            const SplitBody<dim>     &body,
            const VelocityBasis<dim> &basis,
            const unsigned int        degree)
  {
    for (const auto &view : views_of_faces(body))
      if (view.resists_slip() || view.condition.is_reached)
        add_face(program, body, basis, degree, view);
  }



  template <int dim>
  VelocityField<dim>
  field_of(const SplitBody<dim>     &body,
           const VelocityBasis<dim> &basis,
           const ConicSolution      &solution)
  {
    VelocityField<dim> field;
    field.bound =
      -solution.cost *
      (body.load_factor_unit > 0 ? body.load_factor_unit : body.force_unit());
    field.multipliers.assign(solution.multipliers.begin(),
                             solution.multipliers.begin() +
                               basis.on_simplices.size());
    field.n_iterations = solution.n_iterations;
    field.is_optimal   = solution.is_optimal;
    for (const auto &functions : basis.on_simplices)
      {
        SimplexVelocity<dim> &velocity = field.velocity.emplace_back();
        for (const auto &[number, function] : functions)
          velocity.add(-solution.y[number], function);
      }
    return field;
  }



  template ConicProgram
  program_of_loads(const SplitBody<2> &, const VelocityBasis<2> &);
  template ConicProgram
  program_of_loads(const SplitBody<3> &, const VelocityBasis<3> &);
  template void
  add_faces(ConicProgram &,
            const SplitBody<2> &,
            const VelocityBasis<2> &,
            const unsigned int);
  template void
  add_faces(ConicProgram &,
            const SplitBody<3> &,
            const VelocityBasis<3> &,
            const unsigned int);
  template VelocityField<2>
  field_of(const SplitBody<2> &,
           const VelocityBasis<2> &,
           const ConicSolution &);
  template VelocityField<3>
  field_of(const SplitBody<3> &,
           const VelocityBasis<3> &,
           const ConicSolution &);
} // namespace ElastoPlastic
