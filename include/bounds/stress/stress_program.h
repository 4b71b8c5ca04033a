// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_program_h
#define bounds_stress_stress_program_h

#include <array>
#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/conic/conic_program.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A minimisation over Johnson-Mercier stresses of the first or second degree
  /// in equilibrium that satisfy the yield condition everywhere, as a
  /// ConicProgram in the units of the body.
  ///
  /// Stresses, tractions and pressures are polynomials, given by their
  /// Bernstein coefficients: those of the first degree are values at corners
  /// and ends of sides. "Points" are what the coefficients belong to.
  ///
  /// Each triangle is a block. Its unknowns are those of the equilibrated basis
  /// (see LocalStresses); the coefficients of sigma_33, in plane strain; and
  /// those of zeta, off the axis, the growth of the yield surface, if the
  /// material hardens. Each point of a side under the indenter is a block, too;
  /// its unknown is the force q >= 0, the coefficient of the pressure times its
  /// share of the side. The equations, two at each point of the sides, say that
  /// the tractions of the two triangles, or of triangle and indenter, add up to
  /// zero, or to what is prescribed. There are none on the axis of a body of
  /// revolution, where nothing acts. The yield condition holds everywhere if
  /// the coefficients satisfy it, because the set of admissible stresses is
  /// convex (see LocalStresses::yield_points()).
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
    StressProgram(const PlaneBody       &body,
                  const OutOfPlaneStress out_of_plane,
                  const unsigned int     degree);

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
    /// Something for each point of a side, and each component of its condition.
    template <typename Value>
    using ByPoints = std::vector<std::array<Value, 2>>;

    /// A side as a triangle sees it: the forces of its outward tractions in
    /// the directions of the condition, as linear functions of the unknowns.
    struct SideOfTriangle
    {
      unsigned int             side;
      ByPoints<Vector<double>> forces;
    };

    void
    number_equations();
    /// The share of a side in the integral of a polynomial that each of its
    /// coefficients has, in the unit of length.
    double
    share_of_side(const unsigned int side) const;
    /// The forces at the points of a side of the traction that has the same
    /// moments as a @p load.
    std::vector<double>
    point_forces(const unsigned int                             side,
                 const std::function<double(const Point<2> &)> &load) const;
    /// Whether nothing acts on a point of a side because it is on the axis.
    bool
    is_on_axis(const unsigned int side, const unsigned int point) const;
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

    /// The force at a @p point of side @p k of a triangle, along a @p component
    /// of its condition, as a linear function of the tractions (see
    /// JohnsonMercier::traction_index()).
    Vector<double>
    force_of_tractions(const unsigned int triangle,
                       const unsigned int k,
                       const unsigned int point,
                       const unsigned int component) const;

    /// Pressure and force of the indenter, from those of its blocks.
    void
    set_pressure(StressField &field, const double *forces) const;

    /// Adds the weighted stress of the next triangle, given by its @p values,
    /// four components at each point.
    void
    add_stress(StressField &field, const Vector<double> &values) const;

    /// What int u v / r dx is as a bilinear form of functions u, v on the
    /// subtriangles, by their coefficients; with r = 1 in the plane.
    FullMatrix<double>
    weighted_mass(const unsigned int triangle) const;

    /// What int C^-1 sigma : tau is as a bilinear form of the coefficients of
    /// the weighted stresses.
    FullMatrix<double>
    elastic_energy(const unsigned int triangle) const;

    /// Adds int zeta^2 / (2 h) to the cost of a triangle.
    void
    add_hardening_energy(const unsigned int triangle);

    /// The derivative of cost and yield conditions with respect to the
    /// coefficients of the components 11, 22, 12: moments of the strain.
    /// @p stress and the multipliers @p z of the yield conditions are those of
    /// the solution.
    Vector<double>
    strain_moments(const unsigned int    triangle,
                   const Vector<double> &stress,
                   const double         *z) const;

    /// What the force at a point of a side is multiplied by in the Lagrange
    /// function, a displacement with the opposite sign: the multiplier @p y of
    /// its equation, or that of a prescribed displacement.
    double
    multiplier(const unsigned int    side,
               const unsigned int    point,
               const unsigned int    component,
               const Vector<double> &y) const;

    /// That of a prescribed displacement.
    double
    given_multiplier(const unsigned int side,
                     const unsigned int point,
                     const unsigned int component) const;

    /// See StressField::displacement. @p y are the multipliers of the
    /// equations.
    std::array<Tensor<1, 2>, 3>
    displacement_of(const unsigned int    triangle,
                    const Vector<double> &strain_moments,
                    const Vector<double> &y) const;

    /// The block of a point under the indenter.
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

    /// int f B ds for Bernstein's functions B of a side, relative to its share
    /// of the length.
    std::vector<double>
    moments(const unsigned int                             side,
            const std::function<double(const Point<2> &)> &f) const;

    const PlaneBody       &body;
    const OutOfPlaneStress out_of_plane;
    const unsigned int     degree;
    ConicProgram           program;
    bool                   has_energy = false;

    /// By sides; invalid where there is none.
    std::vector<ByPoints<unsigned int>> equations;

    /// By triangles: the coefficients of the weighted stress, four components
    /// at each point, as functions of the unknowns; and the three sides.
    std::vector<FullMatrix<double>>            point_stresses;
    std::vector<std::array<SideOfTriangle, 3>> sides;

    struct PointOfSide
    {
      unsigned int side;
      unsigned int point;
    };

    /// Under the indenter, in the order of their blocks, which come after those
    /// of the triangles.
    std::vector<PointOfSide> contact_points;
  };
} // namespace ElastoPlastic

#endif
