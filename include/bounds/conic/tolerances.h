// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_tolerances_h
#define bounds_conic_tolerances_h

#include <array>

/// What counts as zero, as equal and as solved in bounds/: all numbers of this
/// kind, with what they are relative to, and why they are as large as they are.
namespace ElastoPlastic::Tolerance
{
  // Geometry.

  /// Of the cosine and sine of an angle: below, directions are at right angles
  /// or parallel, and faces are in one plane. Files of meshes round coordinates
  /// to seven digits and more, and faces are shorter than the body: so normals
  /// differ by up to some 1e-6 where one plane is meant, and no angle that is
  /// meant is so small.
  constexpr double small_angle = 2e-6;

  /// Of a radius, and of what has it as a factor, relative to the unit of
  /// length: below, it is on the axis of revolution, where it would be zero
  /// without rounding errors.
  constexpr double on_axis = 1e-12;

  /// Of the way from a point of a face to its centre. What jumps at a vertex,
  /// or at an edge of the indenter, has the value of a face a little inside
  /// it. Of a load, that is beyond the rounding errors of the coordinates, as
  /// far as this, and at most so far where the centre is near the point.
  constexpr double smallest_inset = 1e-12, largest_inset = 1e-2;

  /// The same for the gap of an indenter, which lets points count as its own
  /// that are beyond its edge by 1e-10 of its size (within()): more than that,
  /// also on faces that are much smaller.
  constexpr double inset_of_gap = 2e-6;

  /// Of the difference of gaps along a side, relative to its length: below, the
  /// indenter fits the side. As long as inset_of_gap is there.
  constexpr double fit_of_indenter = 1e-6;

  // Loads, which are expressions of the user.

  /// Of the values of an expression that is to be constant, linear or
  /// quadratic, relative to the largest of them: the difference that sums of
  /// large terms leave in it.
  constexpr double expression = 1e-9;

  /// The same of tractions on a side, to name it before anything is computed:
  /// what is smaller is found by the check of the stresses (admissibility).
  constexpr double traction = 1e-6;

  /// Of a load, relative to the largest: below, it does not grow.
  constexpr double smallest_load = 1e-10;

  // Conic programs. Their unknowns are scaled to be of order 1; the equations
  // are relative to the largest of their terms.

  /// Of cost and dual cost, relative to the cost, for limit loads: how close
  /// bounds come to the best ones of their mesh. That is below what meshes
  /// differ by, which is more in space, where an iteration costs more.
  template <int dim>
  constexpr double gap_of_bounds = dim == 2 ? 1e-6 : 1e-5;

  /// In space, where meshes are coarse, the gap may be this part of the last
  /// mesh's difference between the bounds, but not larger than the second.
  constexpr double part_of_difference = 0.01, largest_gap_in_space = 1e-3;

  /// With friction, which part of the strength stresses leave unused, at least:
  /// under a free surface of heavy ground, the strength may be less than a
  /// thousandth of that below, to which rounding errors are relative.
  constexpr double unused_strength = 1e-6;

  /// With friction, by how much more than they must the velocities dilate, over
  /// the slope of the strength: a power, relative to that of a stress unit,
  /// which is more than what is missing where the interior point method ends.
  /// So the velocities are strictly inside of the dual cones of the yield
  /// condition.
  constexpr double dilation_margin = 4e-10;

  /// Of the same, for the least energy: smaller, because with compliance the
  /// linear systems are regular, and rounding errors small.
  constexpr double gap_of_energy = 1e-9;

  /// With friction, rates must be in the dual cones of the yield condition.
  /// What they lack becomes smaller with the gap, which is this part of what it
  /// is without friction.
  constexpr double part_with_friction = 1e-3;

  /// If rounding errors end the iteration early, its best iterate is returned
  /// unless the gap is larger than this: it is made admissible, and its bounds
  /// are bounds, though not the best ones.
  constexpr double largest_gap = 1e-2;

  /// Of the gap: below, rounding errors of another direction may be larger
  /// than what a longer step gains.
  constexpr double smallest_corrected_gap = 1e-12;

  /// Of the equations of an iterate that counts as solved, or as one from which
  /// slacks inside the cones are known. The difference is made up in the end.
  constexpr double equations = 1e-6;

  /// Of the equations of an iterate that is to be strictly inside the cones
  /// itself: nothing is made up then.
  constexpr double interior = 1e-12;

  /// Of the equations in the end: those of the stresses, by which bounds are
  /// rigorous, to rounding errors; and the others, which the compliance of
  /// kernels spoils. Those of the forces count as stresses on small sides.
  constexpr double primal_equations = 1e-13, dual_equations = 1e-10;

  /// Of the powers of a function in a block, relative to the largest of all:
  /// below, the function vanishes there but for rounding errors.
  constexpr double power = 1e-13;

  /// Slacks outside their cones by less, relative to their expected size, count
  /// as inside: less than what the yield condition is checked to
  /// (admissibility).
  constexpr double cone = 1e-10;

  /// Costs and their derivatives below this count as zero: nothing is loaded.
  constexpr double smallest_cost = 1e-12;

  /// Of the equations in a certificate, relative to its inequality: that no
  /// solution exists, and that the cost has no lower bound. Where that is so,
  /// the iteration comes closer to them in each step.
  constexpr double certificate_of_multipliers = 1e-7,
                   certificate_of_direction   = 1e-5;

  // Linear systems.

  /// Of the residual, relative to the right-hand side: what repeated solving
  /// reaches; and of the predictor, of which only the length of a step and
  /// products of second order remain.
  constexpr double residual = 1e-11, residual_of_predictor = 1e-4;

  /// The compliance of a block in the directions that no cone sees, relative
  /// to the largest eigenvalue of its W^-2 across the directions of s and z;
  /// those along them tend to zero and infinity in the course of the
  /// iteration. With 1e-4, repeated solving leaves a divergence of 1e-8 of the
  /// rate of strain.
  constexpr double kernel_compliance = 1e-7;

  /// What is added to the diagonals of a block, relative to each entry: more
  /// than the rounding errors of its Cholesky factorisation.
  constexpr double rounding_of_block = 1e-14;

  /// What is added to the diagonal of the sum of all blocks, relative to each
  /// entry, one after the other until it can be factorised.
  constexpr std::array<double, 4> roundings_of_sum = {
    {0., 1e-14, 1e-12, 1e-10}};

  /// Of the pivots of A^T A, relative to the largest: below, columns of the
  /// local matrix A depend on each other, but for the root of this.
  constexpr double pivot = 1e-12;

  // Results.

  /// By how much stresses may violate equilibrium and yield condition, relative
  /// to the yield stress; velocities their conditions, relative to the largest
  /// of them; and a displacement its supports, relative to it: these are
  /// rounding errors, else there is no bound.
  constexpr double admissibility = 1e-8;


  /// Of the bound that velocities give by themselves and that which has been
  /// minimised, relative to it: above, the minimum has been lost to rounding
  /// errors, which the result says.
  constexpr double loss_of_minimum = 1e-3;

  /// On triangles of a size h that are far from the axis, r^2 chi is close to
  /// any phi, so that rounding errors could hardly tell them apart. So phi
  /// costs the work of this part of r / h times its rate at least, which is
  /// this part of what slips of the same velocity cost.
  constexpr double flux_penalty = 1e-4;

  /// Of a pressure, relative to the largest: below, there is no contact. An
  /// interior point leaves a little pressure everywhere.
  constexpr double smallest_pressure = 1e-4;

  /// Of a slip, relative to the largest velocity: below, no line of slip is
  /// drawn.
  constexpr double smallest_slip = 1e-3;
} // namespace ElastoPlastic::Tolerance

#endif
