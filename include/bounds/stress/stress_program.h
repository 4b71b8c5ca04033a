// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_program_h
#define bounds_stress_stress_program_h

#include <array>
#include <vector>

#include "bounds/conic/conic_program.h"
#include "bounds/stress/local_stresses.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// A minimisation over Johnson-Mercier stresses in equilibrium that satisfy
  /// the yield condition everywhere, as a ConicProgram in the units of the
  /// body.
  ///
  /// Stresses, tractions and pressures are polynomials, given by their
  /// Bernstein coefficients: those of the first degree are values at corners.
  /// "Points" are what the coefficients belong to.
  ///
  /// Each simplex is a block. Its unknowns are those of the equilibrated basis
  /// (see LocalStresses); the coefficients of sigma_33, if that is unknown;
  /// those of zeta, off the axis, the growth of the yield surface, if the
  /// material hardens; and with friction, where the weight grows, the load
  /// factor, whose pressure counts. Each point of a face under the indenter is
  /// a block, too; its unknown is the coefficient of the pressure (see
  /// contact_unit()). The equations, one for each component at each point of
  /// the faces, say that the tractions of the two simplices, or of simplex and
  /// indenter, add up to zero, or to what is prescribed. There are none on the
  /// axis of a body of revolution, where nothing acts. The last equations, one
  /// for each simplex, say that its load factor is that of all. The yield
  /// condition holds everywhere if the coefficients over those of the weight
  /// satisfy it, because the set of admissible stresses is convex: with
  /// coefficients S_a of S and r_a of r,
  ///   |dev S| <= sum_a B_a |dev S_a| <= sum_a B_a r_a R = r R.
  template <int dim>
  class StressProgram
  {
  public:
    /// @p body must live as long as this object. There is no cost yet, except
    /// that of a load factor.
    StressProgram(const SplitBody<dim> &body,
                  const OutOfPlane      out_of_plane,
                  const unsigned int    degree);

    /// Add the energy int W*(tau) dx, with
    ///   W* = 1/2 (tau - sigma_0) : C^-1 (tau - sigma_0) + zeta^2 / (2 h),
    /// C being the elasticity, sigma_0 the initial stress and h = 2/3 (H +
    /// H_k), less the work of the prescribed displacements. In a body of
    /// revolution, it is computed by quadrature_over() and a little too large.
    void
    add_energy();

    /// Add int g p ds, with the gap g and the vertical part p of the indenter's
    /// pressure, by integrate_on_face().
    void
    add_gap();

    /// Add @p factor int p ds.
    void
    add_force(const double factor);

    /// Require int p ds = @p force (of the whole body of revolution). The depth
    /// will be the Lagrange multiplier.
    void
    prescribe_force(const double force);

    /// By simplices, see ConicProgram::expect_multipliers().
    void
    expect_multipliers(const std::vector<double> &of_simplices)
    {
      program.expect_multipliers(of_simplices);
    }

    /// Can be called once: the program goes to the solver, which frees its
    /// memory. @throws ConvergenceError
    StressField<dim>
    solve(const double tolerance);

  private:
    using Element = JohnsonMercier<dim>;

    /// Of the components of a stress, what makes a number out of it.
    using StressFunctional = std::array<double, Element::n_components>;

    struct PointOfFace
    {
      unsigned int face;
      unsigned int point;
    };

    // What concerns the simplices.
    LocalStresses<dim>
    local(const unsigned int simplex) const
    {
      return {body, simplex, degree};
    }
    void
    add_block(const unsigned int simplex);
    unsigned int
    n_growths(const unsigned int simplex) const;
    /// Whether each simplex needs to know the load factor.
    bool
    has_growing_pressure() const
    {
      return body.has_friction() && body.live_body_force.norm() > 0.;
    }
    /// The part of the strength of a simplex that its stresses may use.
    double
    usable_part(const unsigned int simplex) const
    {
      return body.has_friction() && body.friction_slopes[simplex] > 0. ?
               1. - Tolerance::unused_strength :
               1.;
    }
    void
    add_friction_to(const unsigned int        simplex,
                    const FullMatrix<double> &stresses);
    FullMatrix<double>
    point_stresses(const unsigned int simplex) const;

    /// int C^-1 sigma B dx for all functions B, the shear components counting
    /// twice, if @p stresses has coefficients of stresses sigma as columns.
    FullMatrix<double>
    strain_moments(const unsigned int        simplex,
                   const FullMatrix<double> &stresses) const;

    /// int u v / r dx as a bilinear form of functions u, v on one of the parts,
    /// by their coefficients; with r = 1 in the plane and in space. In units of
    /// the energy.
    FullMatrix<double>
    weighted_mass(const unsigned int simplex, const unsigned int part) const;

    /// Adds int zeta^2 / (2 h) to the cost of a simplex.
    void
    add_hardening_energy(const unsigned int simplex);

    /// int e_0 B dx as strain_moments(), in the units of the body,
    /// with the elastic strain e_0 of the initial stress.
    Vector<double>
    moments_of_initial_strain(const unsigned int simplex) const;

    /// int e_0 : C e_0 / 2 dx of the whole body.
    double
    energy_of_initial_stress() const;

    /// Subtracts that of the prescribed displacements.
    void
    add_work_of_supports(const unsigned int        simplex,
                         const FullMatrix<double> &stresses);

    // What concerns the faces.
    void
    number_equations();
    /// The number of a point among those of all faces.
    unsigned int
    index(const PointOfFace &point) const
    {
      return Element::n_face_points(degree) * point.face + point.point;
    }

    /// The share of a face in the integral of a polynomial that each of its
    /// coefficients has, in units of the body.
    double
    share_of_face(const unsigned int face) const
    {
      return body.relative_area(face) / Element::n_face_points(degree);
    }

    /// int f B ds for Bernstein's functions B of a face, relative to its share
    /// of the area.
    template <typename Function>
    std::vector<double>
    moments(const unsigned int face, const Function &f) const;

    /// The forces at the points of a face of the traction that has the same
    /// moments as a @p load.
    template <typename Load>
    std::vector<double>
    point_forces(const unsigned int face, const Load &load) const;

    /// Whether nothing acts on a point of a face because it is on the axis.
    bool
    is_on_axis(const PointOfFace &point) const
    {
      return body.is_on_axis(
        point_on_face<dim>(body.corners_of_face(point.face),
                           Bernstein<dim - 1>::points(degree)[point.point])
          .x);
    }


    void
    add_tractions(const unsigned int        simplex,
                  const FullMatrix<double> &stresses);

    /// The force at point @p i of face @p k of a simplex, along a @p component
    /// of its condition: what it is of the stress at the point of the simplex
    /// with the number @p value.
    struct PointForce
    {
      StressFunctional functional;
      unsigned int     value;
    };
    PointForce
    point_force(const unsigned int simplex,
                const unsigned int k,
                const unsigned int i,
                const unsigned int component) const;

    /// As a linear function of the unknowns.
    Vector<double>
    row_of(const PointForce &force, const FullMatrix<double> &stresses) const;

    // What concerns the indenter.
    void
    add_indenter();
    /// The block of a point under the indenter.
    ConicBlock &
    contact_block(const unsigned int i)
    {
      return program.blocks[body.mesh.simplices.size() + i];
    }
    /// What the unknown there is multiplied by to be a force: 1 in the plane,
    /// where it is the force; in space, it is the pressure.
    double
    contact_unit(const unsigned int face) const
    {
      return dim == 2 ? 1. : share_of_face(face);
    }
    /// What the force there is multiplied by to be vertical.
    double
    vertical_part(const unsigned int i) const
    {
      return body.conditions[contact_points[i].face]
        .contact()
        .direction[dim - 1];
    }
    /// Adds the work of the vertical part along this @p distance.
    void
    add_contact_cost(const unsigned int i, const double distance)
    {
      contact_block(i).linear_cost[0] += contact_unit(contact_points[i].face) *
                                         vertical_part(i) * distance /
                                         (body.strain_unit * body.length_unit);
    }

    // What concerns the solution.
    /// Pressure and force of the indenter, from the unknowns of its blocks.
    void
    set_pressure(StressField<dim> &field, const double *unknowns) const;

    /// Adds the stress of the next simplex, given by its @p values in units of
    /// the body.
    void
    add_stress(StressField<dim> &field, const Vector<double> &values) const;

    /// The derivative of cost and yield conditions with respect to the
    /// coefficients of the element: moments of the strain. @p values are those
    /// of the stress, @p z the multipliers of the yield conditions.
    Vector<double>
    strain_moments_of_solution(const unsigned int    simplex,
                               const Vector<double> &values,
                               const double         *z) const;

    /// What the force at a point of a face is multiplied by in the Lagrange
    /// function, a displacement with the opposite sign: the multiplier @p y of
    /// its equation, or that of a prescribed displacement.
    double
    multiplier(const PointOfFace    &point,
               const unsigned int    component,
               const Vector<double> &y) const;

    /// That of a prescribed displacement.
    double
    given_multiplier(const PointOfFace &point,
                     const unsigned int component) const;

    /// See StressField::displacement. @p y are the multipliers of the
    /// equations.
    std::array<Tensor<1, dim>, dim + 1>
    displacement_of(const unsigned int    simplex,
                    const Vector<double> &strain_moments,
                    const Vector<double> &y) const;

    const SplitBody<dim> &body;
    const OutOfPlane      out_of_plane;
    const unsigned int    degree;
    ConicProgram          program;
    bool                  has_energy = false;

    /// By simplices of a body of revolution, where it takes long to find them:
    /// the equilibrated bases.
    std::vector<FullMatrix<double>> bases;

    /// By points of the faces; invalid where there is none.
    std::vector<std::array<unsigned int, dim>> equations;

    /// Under the indenter, in the order of their blocks, which come after those
    /// of the simplices.
    std::vector<PointOfFace> contact_points;
  };
} // namespace ElastoPlastic

#endif
