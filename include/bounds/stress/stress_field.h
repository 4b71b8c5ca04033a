// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_field_h
#define bounds_stress_stress_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Stresses in exact equilibrium, without the pressure of body forces (see
  /// PlaneBody). In a body of revolution, it is the weighted
  /// stress that is a polynomial on each subtriangle, the stress times the
  /// distance r from the axis (see LocalStresses); in the plane, the weight is
  /// 1. Polynomials are given by their Bernstein coefficients.
  struct StressField
  {
    unsigned int degree = 1; ///< of the weighted stress
    /// By triangles: the components 11, 22, 12 of the weighted stress (rr, zz,
    /// rz), see JohnsonMercier::value_index().
    std::vector<Vector<double>> in_plane;
    /// By triangles: its component 33 on the subtriangles.
    std::vector<std::vector<double>> out_of_plane;
    /// By triangles of a body of revolution: the circumferential stress on the
    /// subtriangles, without weight, of a degree that is one less: the
    /// component 33 is this times r.
    std::vector<std::vector<double>> circumferential;
    /// By sides: the coefficients of the weighted pressure of the indenter,
    /// each over that of the weight; zero where it cannot touch. The first and
    /// the last are the pressures at the ends.
    std::vector<std::vector<double>> pressure;
    /// By triangles, at the corners: the Lagrange multiplier u_h of the
    /// equilibrium in J (4.1), linear on each triangle and not continuous. The
    /// velocity, when the indenter moves down by 1, of a limit load.
    std::vector<std::array<Tensor<1, 2>, 3>> displacement;

    /// Of the indenter, on the whole body of revolution. The depth is zero if
    /// neither it nor the force has been prescribed.
    double force = 0;
    double depth = 0;
    /// Of the loads that grow; zero if none does.
    double load_factor = 0;
    /// What has been minimised.
    double cost = 0;
    /// Between the cost and its lower bound in the space of these stresses.
    double       relative_gap = 0;
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;

    /// The coefficient number @p i of the weighted stress on a @p subtriangle
    /// of a triangle; the first three are the values at its corners.
    SymmetricTensor<2, 3>
    coefficient(const unsigned int triangle,
                const unsigned int subtriangle,
                const unsigned int i) const;

    /// The weighted stress at a @p point of a subtriangle.
    SymmetricTensor<2, 3>
    at(const unsigned int            triangle,
       const unsigned int            subtriangle,
       const Bernstein::Barycentric &point) const;

    /// The whole stress at a @p corner of a subtriangle, without weight. On the
    /// axis, where it may depend on the direction from which one comes, it is
    /// that on the way to the middle of the opposite side.
    SymmetricTensor<2, 3>
    without_weight(const PlaneBody   &body,
                   const unsigned int triangle,
                   const unsigned int subtriangle,
                   const unsigned int corner) const;

    /// The largest pressure of the indenter.
    double
    max_pressure() const;

    /// The area of what the indenter presses on: of a section, its length.
    double
    contact_area(const PlaneBody &body) const;
  };
} // namespace ElastoPlastic

#endif
