// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_space_stress_program_h
#define bounds_stress_space_stress_program_h

#include <array>
#include <vector>

#include "bounds/conic/conic_program.h"
#include "bounds/stress/space_stress.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A minimisation over Johnson-Mercier stresses in equilibrium that satisfy
  /// the yield condition everywhere, as a ConicProgram in the units of the
  /// body: what StressProgram is in two dimensions.
  ///
  /// Each tetrahedron is a block. Its unknowns are the coefficients of its
  /// equilibrated basis; and zeta at the corners of its parts, the growth of
  /// the yield surface, if the material hardens. Each corner of a face under
  /// the indenter is a block, too, with the pressure there. The equations,
  /// three at each corner of a face, say that the tractions of the two
  /// tetrahedra, or of tetrahedron and indenter, add up to zero, or to what is
  /// prescribed.
  class SpaceStressProgram
  {
  public:
    /// @p body must live as long as this object. There is no cost yet, except
    /// that of a load factor.
    explicit SpaceStressProgram(const SpaceBody &body);

    /// See StressProgram::add_energy().
    void
    add_energy();

    /// Add int g p ds, with the gap g and the vertical part p of the indenter's
    /// pressure. The gap is integrated by a formula of degree 7.
    void
    add_gap();

    /// Add @p factor int p ds.
    void
    add_force(const double factor);

    /// Require int p ds = @p force. The depth will be the Lagrange multiplier.
    void
    prescribe_force(const double force);

    /// Can be called once: the program goes to the solver, which frees its
    /// memory. @throws ConvergenceError
    SpaceStressField
    solve(const double tolerance);

  private:
    struct CornerOfFace
    {
      unsigned int face;
      unsigned int corner;
    };

    void
    number_equations();
    void
    add_block(const unsigned int tetrahedron);
    void
    add_yield_conditions(ConicBlock               &block,
                         const FullMatrix<double> &basis,
                         const unsigned int        tetrahedron) const;
    void
    add_tractions(const unsigned int tetrahedron);
    void
    add_indenter();

    FullMatrix<double>
    basis_of(const unsigned int tetrahedron) const;

    /// The force that the traction at a corner @p i of face @p k of a
    /// tetrahedron stands for, in the direction of a @p component of the face's
    /// condition, as a linear function of the unknowns.
    Vector<double>
    force_at_corner(const unsigned int        tetrahedron,
                    const FullMatrix<double> &basis,
                    const unsigned int        k,
                    const unsigned int        i,
                    const unsigned int        component) const;

    /// Adds int C^-1 tau : tau to the cost of a tetrahedron, whose @p part of
    /// the energy's unit is its volume in units of the body.
    void
    add_elastic_energy(const unsigned int        tetrahedron,
                       const FullMatrix<double> &basis,
                       const double              part);

    /// Adds int zeta^2 / (2 h).
    void
    add_hardening_energy(const unsigned int tetrahedron, const double part);

    /// Subtracts that of the prescribed displacements.
    void
    add_work_of_supports(const unsigned int        tetrahedron,
                         const FullMatrix<double> &basis);

    /// Of the corner of a face under the indenter.
    ConicBlock &
    contact_block(const unsigned int i);

    /// The work of the pressure there along this @p distance.
    void
    add_contact_cost(const unsigned int i, const double distance);

    const SpaceBody &body;
    ConicProgram     program;

    /// By corners of faces (see SpaceBody::index()) and components; invalid
    /// where there is none.
    std::vector<std::array<unsigned int, 3>> equations;

    /// Under the indenter, in the order of their blocks, which come after those
    /// of the tetrahedra.
    std::vector<CornerOfFace> contact_corners;
  };
} // namespace ElastoPlastic

#endif
