// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_conic_program_h
#define bounds_conic_conic_program_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "bounds/conic/second_order_cone.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The unknowns of the optimality conditions of a ConicProgram without the
  /// slack variables, or the residuals of these conditions.
  struct KktVector
  {
    Vector<double> x;               ///< see ConicLayout::unknowns
    Vector<double> z;               ///< see ConicLayout::rows
    Vector<double> y;               ///< by equations
    double         load_factor = 0; ///< lambda
  };



  /// Of which size the slack s and the multiplier z of a cone are expected to
  /// be. The iteration begins with such values (times
  /// ConicProgram::expected_multipliers), and their product says how much of
  /// s^T z the cone may keep: for instance, what its triangle has of the area.
  struct ConeScale
  {
    double slack      = 1.;
    double multiplier = 1.;
  };



  /// What a convex optimisation problem says of some of its unknowns x, for
  /// instance the stresses on a triangle: their cost
  ///   1/2 x^T P x + c^T x,
  /// the second-order cones they must stay in,
  ///   h - G x in K,
  /// and what they contribute, A x, to the equations that couple the blocks.
  struct ConicBlock
  {
    /// P: n x n, symmetric, not negative; empty if there is none
    FullMatrix<double> quadratic_cost;
    Vector<double>     linear_cost; ///< c: n
    FullMatrix<double> cone_matrix; ///< G: m x n
    Vector<double>     cone_offset; ///< h: m
    /// K: sizes of cones, from 1 to SecondOrderCone::max_size, with the sum m
    std::vector<unsigned int> cone_sizes;
    std::vector<ConeScale>    cone_scales; ///< one for each cone
    FullMatrix<double>        coupling;    ///< A: k x n
    std::vector<unsigned int> rows; ///< the k equations that A contributes to

    /// A block of @p n unknowns without cost, cones and couplings.
    explicit ConicBlock(const unsigned int n)
      : linear_cost(n)
      , cone_matrix(0, n)
      , coupling(0, n)
    {}


    /// Adds a row to A.
    void
    add_to_equation(const unsigned int equation, const Vector<double> &row);

    /// Adds the condition row x <= 0 to the cones.
    void
    add_inequality(const Vector<double> &row);
  };



  /// Minimises the sum of the costs of all blocks so that their contributions
  /// to each equation sum up to the right-hand side b.
  ///
  /// The right-hand side may grow: it then is b + lambda d with a free unknown
  /// lambda, the load factor, whose cost is -lambda.
  ///
  /// Many programs are of this kind: the unknowns of a block are the stresses
  /// on a triangle, and the equations are equilibrium at sides or nodes. The
  /// Lagrange multipliers y of the equations then are displacements.
  struct ConicProgram
  {
    std::vector<ConicBlock> blocks;
    Vector<double>          right_hand_side; ///< b
    Vector<double>          live_load; ///< d; empty if there is no load factor
    /// By blocks, how much larger than their ConeScale says the multipliers of
    /// the cones are expected to be where the iteration begins; empty if
    /// nothing is known.
    std::vector<double> expected_multipliers;
    /// Whether many blocks contribute to the last equation (the force balance
    /// of an indenter). It is kept out of the sparse factorisation.
    bool has_dense_row = false;

    /// Makes @p n equations that say zero, with a load factor if loads grow.
    void
    set_equations(const unsigned int n, const bool has_load_factor)
    {
      right_hand_side.reinit(n);
      live_load.reinit(has_load_factor ? n : 0);
    }

    /// Sets expected_multipliers: of the first blocks to @p of_blocks, and of
    /// all a few times the mean more, because what is expected to be zero may
    /// not be. Nothing changes if there are none, or if their mean is zero.
    void
    expect_multipliers(const std::vector<double> &of_blocks);

    /// Adds to b, and to d if there is a load factor.
    void
    add_load(const unsigned int equation,
             const double       constant,
             const double       growing)
    {
      right_hand_side[equation] += constant;
      if (live_load.size() > 0)
        live_load[equation] += growing;
    }
  };



  /// Where the unknowns and the cones of the blocks are when those of all
  /// blocks are stored one after the other.
  struct ConicLayout
  {
    explicit ConicLayout(const ConicProgram &program);

    /// A cone: its first entry, how many there are, and which unknowns of its
    /// block it sees: all entries of G are in these columns.
    struct Cone
    {
      unsigned int begin;
      unsigned int size;
      unsigned int first_column;
      unsigned int end_column;
    };

    /// Of each block: its first unknown, its first row of cones, its first
    /// cone; and of the block after the last.
    std::vector<unsigned int> unknowns;
    std::vector<unsigned int> rows;
    std::vector<unsigned int> first_cones;
    std::vector<Cone>         cones;
    std::vector<ConeScale>    scales; ///< of the cones

    Vector<double> linear_cost; ///< c
    Vector<double> cone_offset; ///< h

    /// The entries of a cone.
    SecondOrderCone::View
    cone(Vector<double> &values, const unsigned int c) const
    {
      return {values.begin() + cones[c].begin, cones[c].size};
    }

    SecondOrderCone::ConstView
    cone(const Vector<double> &values, const unsigned int c) const
    {
      return {values.begin() + cones[c].begin, cones[c].size};
    }
  };



  /// The solution of a ConicProgram: its unknowns x, what is left to the
  /// boundary of the cones, s, and the Lagrange multipliers y and z. They
  /// satisfy
  ///   P x + c + A^T y + G^T z = 0, A x = b + lambda d, -d^T y = 1,
  ///   G x + s = h, s^T z = 0
  /// with s and z in the cones.
  struct ConicSolution : KktVector
  {
    Vector<double> s; ///< see ConicLayout::rows
    /// By blocks, the mean of the first entries of z in its cones, relative to
    /// their ConeScale: a program for a finer mesh can be told to
    /// expect_multipliers().
    std::vector<double> multipliers;

    double       cost         = 0; ///< 1/2 x^T P x + c^T x - lambda
    double       relative_gap = 0; ///< s^T z of the iterate, relative to cost
    double       primal_error = 0; ///< of A x = b + ... and G x + s = h
    double       dual_error   = 0; ///< of the first and the third, relative
    unsigned int n_iterations = 0;
    /// Whether gap and errors have come below their tolerances before rounding
    /// errors have ended the iteration.
    bool is_optimal = false;
  };
} // namespace ElastoPlastic

#endif
