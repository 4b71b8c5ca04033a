// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_stress_program_h
#define equilibrium_stress_program_h

#include <array>
#include <vector>

#include "equilibrium/conic_program.h"
#include "equilibrium/plane_body.h"
#include "equilibrium/stress_field.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A minimisation over Johnson-Mercier stresses in equilibrium that satisfy
  /// the yield condition everywhere, as a ConicProgram in the units of the
  /// body.
  ///
  /// Each triangle is a block. Its unknowns are the coefficients of the
  /// equilibrated basis (see LocalStresses); sigma_33 at the corners of the
  /// subtriangles, in plane strain; and zeta there, off the axis, the growth of
  /// the yield surface, if the material hardens. Each end of a side under the
  /// indenter is a block, too; its unknown is the force q >= 0 that the linear
  /// pressure stands for there. The equations, two at each end of the sides,
  /// say that the tractions of the two triangles, or of triangle and indenter,
  /// add up to zero, or to what is prescribed. There are none on the axis of a
  /// body of revolution, where nothing acts. Between the corners, the yield
  /// condition holds because stresses are linear and the set of admissible ones
  /// is convex; for a body of revolution, both sides of it are linear when
  /// multiplied by r.
  class StressProgram
  {
  public:
    /// What is known of sigma_33: it is a field of its own, which need not be
    /// continuous; or the mean of sigma_11 and sigma_22, with which the yield
    /// condition of plane strain admits most; or zero; or what the others
    /// leave to the equilibrium of a body of revolution.
    enum class OutOfPlaneStress
    {
      unknown,
      mean,
      zero,
      circumferential
    };

    /// @p body must live as long as this object. There is no cost yet.
    StressProgram(const PlaneBody &body, const OutOfPlaneStress out_of_plane);

    /// Add the energy int W*(tau) dx, with
    ///   W* = 1/2 tau : C^-1 tau + zeta^2 / (2 h),
    /// C being the elasticity and h = 2/3 (H + H_k), less the work
    /// of the prescribed displacements. In a body of revolution, it is computed
    /// by quadrature_over() and a little too large.
    void
    add_energy();

    /// Add int g p ds, with the gap g and the vertical part p of the indenter's
    /// pressure.
    void
    add_gap();

    /// Add @p factor int p ds.
    void
    add_force(const double factor);

    /// Require int p ds = @p force (of the whole body of revolution). The depth
    /// will be the Lagrange multiplier.
    void
    prescribe_force(const double force);

    /// @throws ConvergenceError
    StressField
    solve(const double tolerance) const;

  private:
    /// A number for each end of a side, and each component of its condition.
    template <typename Number>
    using ByEnds = std::array<std::array<Number, 2>, 2>;

    /// A side as a triangle sees it: the forces of its outward tractions in
    /// the directions of the condition, as linear functions of the unknowns.
    struct SideOfTriangle
    {
      unsigned int           side;
      ByEnds<Vector<double>> forces;
    };

    void
    number_equations();
    /// The forces at the ends of a side of the linear traction that has the
    /// same moments as a @p load.
    std::array<double, 2>
    end_forces(const unsigned int                             side,
               const std::function<double(const Point<2> &)> &load) const;
    void
    add_block(const unsigned int triangle);
    /// Of the stresses of a @p basis.
    void
    add_circumferential_stress(const unsigned int        triangle,
                               const FullMatrix<double> &basis);
    void
    add_yield_conditions(const unsigned int triangle);
    void
    add_sides(const unsigned int triangle);
    void
    add_indenter();

    /// The force at an @p end of side @p k of a triangle, in the direction of a
    /// @p component of its condition, as a linear function of the tractions
    /// (see JohnsonMercier::traction_index()).
    Vector<double>
    force_of_tractions(const unsigned int triangle,
                       const unsigned int k,
                       const unsigned int end,
                       const unsigned int component) const;

    /// Pressure and force of the indenter, from those of its blocks.
    void
    set_pressure(StressField &field, const double *forces) const;

    /// What int u v / r dx is as a bilinear form of functions u, v that are
    /// linear on the subtriangles, by their values at the corners (9 x 9); with
    /// r = 1 in the plane.
    FullMatrix<double>
    weighted_mass(const unsigned int triangle) const;

    /// What int C^-1 sigma : tau is as a bilinear form of the weighted stresses
    /// at the corners of the subtriangles (36 x 36).
    FullMatrix<double>
    elastic_energy(const unsigned int triangle) const;

    /// Adds int zeta^2 / (2 h) to the cost of a triangle.
    void
    add_hardening_energy(const unsigned int triangle);

    /// The derivative of cost and yield conditions with respect to the
    /// components 11, 22, 12 at the corners of the subtriangles: moments of the
    /// strain. @p stress (36) and the multipliers @p z of the yield conditions
    /// are those of the solution.
    Vector<double>
    strain_moments(const unsigned int    triangle,
                   const Vector<double> &stress,
                   const double         *z) const;

    /// What the force at an end of a side is multiplied by in the Lagrange
    /// function, a displacement with the opposite sign: the multiplier @p y of
    /// its equation, or that of a prescribed displacement.
    double
    multiplier(const unsigned int    side,
               const unsigned int    end,
               const unsigned int    component,
               const Vector<double> &y) const;

    /// That of a prescribed displacement.
    double
    given_multiplier(const unsigned int side,
                     const unsigned int end,
                     const unsigned int component) const;

    /// See StressField::displacement. @p y are the multipliers of the
    /// equations.
    std::array<Tensor<1, 2>, 3>
    displacement_of(const unsigned int    triangle,
                    const Vector<double> &strain_moments,
                    const Vector<double> &y) const;

    /// The block of an end under the indenter.
    ConicBlock &
    contact_block(const unsigned int i);

    /// What the force there is multiplied by to be vertical.
    double
    vertical_part(const unsigned int i) const;

    /// The work of the vertical part along this @p distance.
    void
    add_contact_cost(const unsigned int i, const double distance);

    double
    force_unit() const;

    /// int f phi ds for the two linear functions phi of a side, relative to
    /// half of its length.
    std::array<double, 2>
    moments(const unsigned int                             side,
            const std::function<double(const Point<2> &)> &f) const;

    const PlaneBody       &body;
    const OutOfPlaneStress out_of_plane;
    ConicProgram           program;
    bool                   has_energy = false;

    /// By sides; invalid where there is none.
    std::vector<ByEnds<unsigned int>> equations;

    /// By triangles: weighted stress at the corners of the subtriangles, four
    /// components each (36 x n); and their three sides.
    std::vector<FullMatrix<double>>            point_stresses;
    std::vector<std::array<SideOfTriangle, 3>> sides;

    struct EndOfSide
    {
      unsigned int side;
      unsigned int end;
    };

    /// Under the indenter, in the order of their blocks, which come after those
    /// of the triangles.
    std::vector<EndOfSide> contact_ends;
  };
} // namespace ElastoPlastic

#endif
