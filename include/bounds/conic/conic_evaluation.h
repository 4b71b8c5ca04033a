// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_conic_evaluation_h
#define bounds_conic_conic_evaluation_h

#include "bounds/conic/kkt_system.h"

namespace ElastoPlastic
{
  /// Computes cost, gap and errors of a @p solution from its unknowns.
  /// @return what is missing to its first three equations, in the order x, z, y
  /// of their multipliers.
  KktVector
  evaluate(const ConicProgram &program,
           const ConicLayout  &layout,
           const KktSystem    &system,
           ConicSolution      &solution);

  /// Of which size slacks and multipliers of the cones are expected to be where
  /// the iteration begins.
  std::vector<ConeScale>
  expected_scales(const ConicProgram &program, const ConicLayout &layout);

  /// See ConicSolution::multipliers.
  std::vector<double>
  multipliers_of_blocks(const ConicLayout &layout, const Vector<double> &z);

  /// The scalings of cones whose slacks and multipliers are of the size that
  /// @p scales say: with those of the layout, the system that they make is well
  /// conditioned.
  KktSystem::Scalings
  expected_scalings(const ConicLayout            &layout,
                    const std::vector<ConeScale> &scales);

  /// Whether an @p iterate of an interior point method proves that a
  /// ConicProgram cannot be solved, up to rounding errors. Multipliers with
  ///   A^T y + G^T z = 0, b^T y + h^T z < 0, z in the cones
  /// contradict the conditions A x = b and G x + s = h. A direction with
  ///   P x = 0, A x = 0, G x + s = 0, c^T x < 0, s in the cones
  /// lowers the cost for ever. @p residual is what is missing to the first
  /// three equations of ConicSolution, in the order x, z, y of their
  /// multipliers.
  /// @throws NoSolutionError @throws UnboundedError
  void
  check_solvability(const ConicProgram  &program,
                    const ConicLayout   &layout,
                    const KktSystem     &system,
                    const ConicSolution &iterate,
                    const KktVector     &residual);

  /// Removes what rounding errors, and an iteration that they have ended, have
  /// left of the equations of a @p solution: A x = b and G x + s = h with s in
  /// the cones, and the first equation. Linear systems with the
  /// expected scalings do so with the least changes of the unknowns. If x is
  /// outside the cones then, it goes towards @p interior as far as necessary,
  /// provided that this iterate, whose equations are restored as well, is
  /// inside. z may leave the cones.
  /// @return whether x is in the cones; if not, it is outside by the change.
  /// @throws ConvergenceError
  bool
  make_admissible(const ConicProgram  &program,
                  const ConicLayout   &layout,
                  KktSystem           &system,
                  const ConicSolution &interior,
                  ConicSolution       &solution);



  /// Where an interior point step goes, in the notation of ConicSolution; W is
  /// the scaling of the cones.
  struct StepDirection
  {
    KktVector      change;
    Vector<double> scaled_s; ///< W^-1 ds
    Vector<double> scaled_z; ///< W dz
  };



  /// How far the cones allow to go.
  /// @param scaled lambda = W z = W^-1 s
  double
  largest_step(const ConicLayout    &layout,
               const Vector<double> &scaled,
               const StepDirection  &direction);



  /// What to add to the products of slacks and multipliers at the end of a step
  /// that is longer than the cones allow, so that they come near those on the
  /// central path: a correction of centrality as Gondzio's
  /// @cite gondzio_1996, for second-order cones. The eigenvalues of the
  /// product of each cone are brought into an interval around its target.
  /// @param length of the largest step
  /// @param targets by cones, the eigenvalues on the central path
  /// @return by rows of cones
  Vector<double>
  centrality_correction(const ConicLayout    &layout,
                        const Vector<double> &scaled,
                        const StepDirection  &direction,
                        const double          length,
                        const Vector<double> &targets);
} // namespace ElastoPlastic

#endif
