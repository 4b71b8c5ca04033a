// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "equilibrium/certificate.h"
#include "equilibrium/interior_point.h"
#include "equilibrium/kkt_system.h"
#include "equilibrium/local_algebra.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int max_iterations = 100;

    /// How much of the way to the boundary of the cones a step goes.
    constexpr double largest_part = 0.99;

    /// So well must the equations be satisfied in the iteration, relative to
    /// the largest of their terms, and the first of them in the end. The
    /// difference is made up by a last linear system.
    constexpr double       equation_tolerance = 1e-6;
    constexpr double       primal_tolerance   = 1e-10;
    constexpr unsigned int max_restorations   = 5;

    /// Costs and their derivatives below this count as zero: nothing is loaded.
    constexpr double smallest_cost = 1e-12;

    using SecondOrderCone::ConstView;
    using SecondOrderCone::View;



    /// The part of s^T z that a cone may keep.
    double
    weight(const ConeScale &scale)
    {
      return scale.slack * scale.multiplier;
    }



    /// The iteration of minimize(), in the notation of ConicSolution; W is the
    /// scaling.
    class InteriorPoint
    {
    public:
      InteriorPoint(const ConicProgram &program, const double tolerance);

      ConicSolution
      run();

    private:
      void
      begin();
      void
      move_into_cones(Vector<double> &values,
                      const double ConeScale::*scale) const;
      void
      compute_residuals();
      bool
      converged() const;
      void
      scale();
      void
      step();
      void
      find_direction(const Vector<double> &complementarity, const double part);
      double
      largest_step() const;
      void
      restore_equations();

      View
      cone(Vector<double> &values, const unsigned int c) const
      {
        return {values.begin() + layout.cones[c].begin, layout.cones[c].size};
      }

      ConstView
      cone(const Vector<double> &values, const unsigned int c) const
      {
        return {values.begin() + layout.cones[c].begin, layout.cones[c].size};
      }

      const ConicProgram &program;
      const ConicLayout   layout;
      const unsigned int  n_cones;
      double              total_weight = 0;
      const double        tolerance;
      KktSystem           system;
      KktSystem::Scalings scalings;

      ConicSolution  current;
      double         gap = 0; ///< s^T z
      KktVector      residual;
      KktVector      change;
      Vector<double> scaled;   ///< lambda = W z = W^-1 s
      Vector<double> scaled_s; ///< W^-1 ds
      Vector<double> scaled_z; ///< W dz
    };



    InteriorPoint::InteriorPoint(const ConicProgram &program,
                                 const double        tolerance)
      : program(program)
      , layout(program)
      , n_cones(layout.cones.size())
      , tolerance(tolerance)
      , system(program, layout)
    {
      for (const ConeScale &scale : layout.scales)
        total_weight += weight(scale);
      current.x.reinit(layout.unknowns.back());
      current.s.reinit(layout.rows.back());
      current.z.reinit(layout.rows.back());
      current.y.reinit(program.right_hand_side.size());
      scaled = scaled_s = scaled_z = current.z;
    }



    ConicSolution
    InteriorPoint::run()
    {
      begin();
      compute_residuals();
      while (!converged())
        {
          if (current.n_iterations == max_iterations)
            throw ConvergenceError(
              "The interior point method has not converged.");
          ++current.n_iterations;
          step();
          compute_residuals();
          check_solvability(program, layout, current, residual);
        }
      restore_equations();
      return current;
    }



    // Without the cones and with the expected scales, this is a linear system,
    // s being -W^2 z. Its solution is moved into the cones.
    void
    InteriorPoint::begin()
    {
      for (unsigned int c = 0; c < n_cones; ++c)
        {
          cone(current.s, c)[0] = layout.scales[c].slack;
          cone(current.z, c)[0] = layout.scales[c].multiplier;
        }
      scale();

      current.s = current.z = 0.;
      compute_residuals();
      system.solve(change, residual);
      current.x = change.x;
      current.y = change.y;
      current.z = change.z;
      compute_residuals();
      current.s = residual.z;
      move_into_cones(current.s, &ConeScale::slack);
      move_into_cones(current.z, &ConeScale::multiplier);
    }



    void
    InteriorPoint::move_into_cones(Vector<double> &values,
                                   const double ConeScale::*scale) const
    {
      double outside = -std::numeric_limits<double>::max();
      for (unsigned int c = 0; c < n_cones; ++c)
        {
          const ConstView v = cone(values, c);
          outside           = std::max(outside,
                             (SecondOrderCone::norm_of_tail(v) - v[0]) /
                               (layout.scales[c].*scale));
        }
      if (outside >= 0)
        for (unsigned int c = 0; c < n_cones; ++c)
          cone(values, c)[0] += (1. + outside) * (layout.scales[c].*scale);
    }



    void
    InteriorPoint::compute_residuals()
    {
      residual.x.reinit(current.x.size());
      residual.z.reinit(current.z.size());
      residual.y = program.right_hand_side;
      residual.z -= current.s;
      double         quadratic_cost = 0, linear_cost = 0, dual_size = 0;
      Vector<double> product;
      for (unsigned int b = 0; b < program.blocks.size(); ++b)
        {
          const ConicBlock   &block = program.blocks[b];
          const double *const x     = current.x.begin() + layout.unknowns[b];
          const unsigned int  n     = block.linear_cost.size();
          product.reinit(n);
          LocalAlgebra::add_product(product.begin(), block.quadratic_cost, x);
          for (unsigned int i = 0; i < n; ++i)
            {
              residual.x[layout.unknowns[b] + i] = -block.linear_cost[i];
              quadratic_cost += x[i] * product[i];
              linear_cost += x[i] * block.linear_cost[i];
              dual_size = std::max({dual_size,
                                    std::abs(product[i]),
                                    std::abs(block.linear_cost[i])});
            }
          for (unsigned int i = 0; i < block.cone_offset.size(); ++i)
            residual.z[layout.rows[b] + i] += block.cone_offset[i];
        }
      const double primal_size = std::max(1., residual.y.linfty_norm());
      system.subtract_product(residual, {current.x, current.z, current.y});

      gap          = current.s * current.z;
      current.cost = 0.5 * quadratic_cost + linear_cost;
      current.relative_gap =
        gap / std::max(smallest_cost, std::abs(current.cost));
      current.primal_error =
        std::max(residual.y.linfty_norm(), residual.z.linfty_norm()) /
        primal_size;
      current.dual_error =
        residual.x.linfty_norm() / std::max(smallest_cost, dual_size);
    }



    bool
    InteriorPoint::converged() const
    {
      return current.relative_gap <= tolerance &&
             std::max(current.primal_error, current.dual_error) <=
               equation_tolerance;
    }



    void
    InteriorPoint::scale()
    {
      scalings.clear();
      for (unsigned int c = 0; c < n_cones; ++c)
        {
          scalings.emplace_back(cone(std::as_const(current.s), c),
                                cone(std::as_const(current.z), c));
          const View lambda = cone(scaled, c);
          std::copy_n(cone(current.z, c).begin(),
                      lambda.size(),
                      lambda.begin());
          scalings[c].multiply(lambda);
        }
      if (!system.factorize(scalings))
        throw ConvergenceError(
          "The interior point method has not converged: "
          "rounding errors are too large.");
    }



    void
    InteriorPoint::step()
    {
      scale();

      // The predictor tells how much smaller the gap can become in one step,
      Vector<double> complementarity(scaled.size());
      for (unsigned int c = 0; c < n_cones; ++c)
        SecondOrderCone::multiply(cone(complementarity, c),
                                  cone(std::as_const(scaled), c),
                                  cone(std::as_const(scaled), c));
      find_direction(complementarity, 1.);
      const double centering = std::pow(1. - std::min(1., largest_step()), 3);

      // the corrector adds its second-order terms, and goes to the central
      // path.
      for (unsigned int c = 0; c < n_cones; ++c)
        {
          const View v = cone(scaled_s, c);
          SecondOrderCone::multiply(v, v, cone(std::as_const(scaled_z), c));
          v[0] -= centering * gap * weight(layout.scales[c]) / total_weight;
        }
      complementarity += scaled_s;
      find_direction(complementarity, 1. - centering);

      const double length = std::min(1., largest_part * largest_step());
      current.x.add(length, change.x);
      current.y.add(length, change.y);
      current.z.add(length, change.z);
      for (unsigned int c = 0; c < n_cones; ++c)
        scalings[c].multiply(cone(scaled_s, c));
      current.s.add(length, scaled_s);
    }



    // Newton's direction for a part of the residuals and for
    //   lambda o (W dz + W^-1 ds) = -complementarity
    void
    InteriorPoint::find_direction(const Vector<double> &complementarity,
                                  const double          part)
    {
      // W^-1 ds = -(lambda \ complementarity) - W dz
      scaled_s.equ(-1., complementarity);
      KktVector right_hand_side = residual;
      right_hand_side.x *= part;
      right_hand_side.y *= part;
      right_hand_side.z *= part;
      Vector<double> slack = scaled_s;
      for (unsigned int c = 0; c < n_cones; ++c)
        {
          const View quotient = cone(scaled_s, c);
          SecondOrderCone::divide(quotient,
                                  quotient,
                                  cone(std::as_const(scaled), c));
          std::copy_n(quotient.begin(),
                      quotient.size(),
                      cone(slack, c).begin());
          scalings[c].multiply(cone(slack, c));
        }
      right_hand_side.z -= slack;
      system.solve(change, right_hand_side);

      scaled_z = change.z;
      for (unsigned int c = 0; c < n_cones; ++c)
        scalings[c].multiply(cone(scaled_z, c));
      scaled_s -= scaled_z;
    }



    double
    InteriorPoint::largest_step() const
    {
      double inverse = std::numeric_limits<double>::min();
      for (unsigned int c = 0; c < n_cones; ++c)
        inverse = std::max(
          {inverse,
           SecondOrderCone::inverse_step(cone(scaled, c), cone(scaled_s, c)),
           SecondOrderCone::inverse_step(cone(scaled, c), cone(scaled_z, c))});
      return 1. / inverse;
    }



    // What rounding errors have left of the equations: the unknowns change so
    // little that the cones need not be looked at again.
    void
    InteriorPoint::restore_equations()
    {
      for (unsigned int k = 0;
           k < max_restorations && current.primal_error > primal_tolerance;
           ++k)
        {
          system.solve(change, residual);
          current.x += change.x;
          current.y += change.y;
          current.s.add(1., residual.z);
          for (unsigned int b = 0; b < program.blocks.size(); ++b)
            LocalAlgebra::add_product(current.s.begin() + layout.rows[b],
                                      program.blocks[b].cone_matrix,
                                      change.x.begin() + layout.unknowns[b],
                                      -1.);
          compute_residuals();
        }
    }
  } // namespace



  ConicSolution
  minimize(const ConicProgram &program, const double tolerance)
  {
    return InteriorPoint(program, tolerance).run();
  }
} // namespace ElastoPlastic
