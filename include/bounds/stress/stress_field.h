// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_field_h
#define bounds_stress_stress_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  /// Stresses in exact equilibrium, without the pressure of body forces (see
  /// SplitBody), and what the indenter does. In a body of revolution, it is the
  /// weighted stress that is a polynomial on each part of a simplex, the stress
  /// times the distance r from the axis (see LocalStresses); else the weight is
  /// 1. Polynomials are given by their Bernstein coefficients.
  template <int dim>
  struct StressField
  {
    unsigned int degree = 1; ///< of the weighted stress
    /// By simplices: the weighted stress on the parts, in the order of
    /// JohnsonMercier, with n_stress_components at each point.
    std::vector<Vector<double>> values;
    /// By triangles of a body of revolution: the circumferential stress on the
    /// parts, without weight, of a degree that is one less: the component 33 is
    /// this times r.
    std::vector<std::vector<double>> circumferential;
    /// By faces, where the indenter can press: the coefficients of the vertical
    /// part of its weighted pressure, each over that of the weight. Those of
    /// the corners are the pressures there.
    std::vector<std::vector<double>> pressure;
    /// By triangles, at the corners: the Lagrange multiplier u_h of the
    /// equilibrium in J (4.1), linear on each triangle and not continuous. The
    /// velocity, when the indenter moves down by 1, of a limit load. There is
    /// none in space.
    std::vector<std::array<Tensor<1, dim>, dim + 1>> displacement;

    /// Of the indenter, on the whole body of revolution. The depth is zero if
    /// neither it nor the force has been prescribed.
    double force = 0;
    double depth = 0;
    /// Of the loads that grow; zero if none does.
    double load_factor = 0;
    /// What has been minimised.
    double cost = 0;
    /// By simplices, see ConicSolution::multipliers.
    std::vector<double> multipliers;
    unsigned int        n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;

    /// The coefficient number @p i of the weighted stress on a @p part of a
    /// simplex; the first ones are the values at its corners.
    SymmetricTensor<2, 3>
    coefficient(const unsigned int simplex,
                const unsigned int part,
                const unsigned int i) const
    {
      return stress_from<dim>(
        values[simplex].begin() +
        n_stress_components<dim> *
          (Bernstein<dim>::n_functions(degree) * part + i));
    }

    /// The weighted stress at a @p point of a part.
    SymmetricTensor<2, 3>
    at(const unsigned int      simplex,
       const unsigned int      part,
       const Barycentric<dim> &point) const;

    /// The coefficients of the weighted traction of a simplex on its face
    /// @p k, across which points @p normal, in the order of the face.
    std::vector<Tensor<1, dim>>
    tractions(const SplitMesh<dim> &mesh,
              const unsigned int    simplex,
              const unsigned int    k,
              const Tensor<1, dim> &normal) const;

    /// The whole stress at a @p corner of a part, without weight. On the axis,
    /// where it may depend on the direction from which one comes, it is that on
    /// the way to the middle of the opposite side.
    SymmetricTensor<2, 3>
    without_weight(const SplitBody<dim> &body,
                   const unsigned int    simplex,
                   const unsigned int    part,
                   const unsigned int    corner) const;

    /// The largest pressure of the indenter.
    double
    max_pressure() const;

    /// The area of what the indenter presses on: of a section, its length.
    double
    contact_area(const SplitBody<dim> &body) const;
  };



  /// The stresses of least complementary energy
  ///   J(tau) = int_Omega W*(tau) dx + int_Gamma_0 g p ds
  /// among all Johnson-Mercier stresses in equilibrium with a given @p force of
  /// the indenter, J (4.1) in @cite johnson_1978: one Hencky step from
  /// the virgin state.
  /// @throws ConvergenceError, in particular beyond the limit load.
  template <int dim>
  StressField<dim>
  equilibrate_with_force(const SplitBody<dim> &body, const double force);

  /// The same with a given @p depth of the indenter: the stresses minimise
  /// J - depth times force.
  template <int dim>
  StressField<dim>
  equilibrate_with_depth(const SplitBody<dim> &body, const double depth);

  /// The stresses with the largest load factor, or if no load grows, with the
  /// largest force of the indenter, that satisfy the yield condition
  /// everywhere. This is a lower bound of the limit load. The strength may
  /// depend on the pressure, see SplitBody::friction_slopes.
  /// @param degree of the stresses, 1 or 2; in space 1
  /// @param expected_multipliers by simplices, or empty if nothing is known,
  /// see ConicProgram::expect_multipliers()
  /// @throws ConvergenceError, in particular if there is no limit.
  template <int dim>
  StressField<dim>
  maximize_load(const SplitBody<dim> &body,
                const unsigned int    degree,
                const double          tolerance = Tolerance::gap_of_bounds<dim>,
                const std::vector<double> &expected_multipliers = {});
} // namespace ElastoPlastic

#endif
