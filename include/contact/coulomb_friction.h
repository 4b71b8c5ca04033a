// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_coulomb_friction_h
#define contact_coulomb_friction_h

#include <cmath>
#include <cstdint>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// A vector in the tangent plane of an indenter, by its horizontal components
  /// v: with the slope b of the indenter, the vertical one is b . v.
  template <int dim>
  using TangentVector = Tensor<1, dim - 1>;

  /// The product of two such vectors.
  template <int n>
  double
  tangent_product(const Tensor<1, n> &v,
                  const Tensor<1, n> &w,
                  const Tensor<1, n> &slope)
  {
    return v * w + (slope * v) * (slope * w);
  }



  /// The force of a node of the body on the indenter, and how it splits.
  template <int dim>
  struct ContactForce
  {
    /// In the direction of the normal (-b, 1)/sqrt(1 + b^2).
    double             normal;
    TangentVector<dim> tangential;

    ContactForce(const double              vertical,
                 const TangentVector<dim> &horizontal,
                 const TangentVector<dim> &slope);
  };



  /// What a contact node has done in the load step under way: it has stuck to
  /// the indenter, or slipped along it.
  template <int dim>
  struct FrictionState
  {
    bool sticks = true;
    /// Of the force, of length 1; and by how much it turns, per length, with
    /// the slip across it.
    TangentVector<dim> direction;
    double             turning = 0.;
    /// How often it has left the indenter again.
    unsigned int n_releases = 0;

    /// A number, less than 2^20, that tells states apart: stick, and directions
    /// that differ by more than one hundredth.
    std::uint64_t
    fingerprint() const;
  };



  /// How the horizontal forces on a body follow from the vertical ones: those
  /// of an indenter that presses down with f are -f times this slope, the slope
  /// of the indenter without friction. And its derivatives with respect to the
  /// horizontal displacements.
  template <int dim>
  struct ForceSlope
  {
    TangentVector<dim> value;
    Tensor<2, dim - 1> derivative;
  };



  /// Coulomb's law for the slip of a load step: its force on the indenter is
  /// at most the coefficient mu times the normal one, and so large in the
  /// direction of the slip where there is some; not regularised
  /// (doc/theory, "Friction").
  template <int dim>
  class CoulombFriction
  {
  public:
    /// @p coefficient mu >= 0; infinite for nodes that never slip. @p modulus
    /// is one of elasticity, the scale of forces over displacements; it has no
    /// influence on what the law says.
    CoulombFriction(const double coefficient, const double modulus)
      : coefficient(coefficient)
      , modulus(modulus)
    {}


    bool
    exists() const
    {
      return coefficient > 0.;
    }

    /// Whether nodes may slip, so that there is no energy.
    bool
    dissipates() const
    {
      return exists() && std::isfinite(coefficient);
    }

    /// Whether a node in contact with this @p state counts as sticking: with an
    /// infinite coefficient all do, those also that begin to in this load step.
    bool
    sticks(const FrictionState<dim> &state) const
    {
      return exists() && (state.sticks || !dissipates());
    }

    /// A load step begins, with a node that @p touches the indenter or not.
    void
    begin_step(FrictionState<dim> &state, const bool touches) const;

    /// A node has left the indenter. One that is torn off where it sticks, and
    /// comes back where it does not, again and again, has a normal force that
    /// vanishes where it is: it slips.
    void
    release(FrictionState<dim> &state) const
    {
      ++state.n_releases;
    }

    /// A node has come into contact: if its @p slip and its @p penetration were
    /// forces, the law would say whether it sticks.
    void
    touch(FrictionState<dim>       &state,
          const TangentVector<dim> &slip,
          const TangentVector<dim> &slope,
          const double              penetration) const;

    /// The switching test: a node sticks if its force and the stiffness of the
    /// surface times its @p slip add up to less than friction, else it slips in
    /// the direction of that sum @cite hueeber_stadler_wohlmuth_2008, but
    /// sticks first before it turns back. @p length times the modulus is that
    /// stiffness.
    /// @return by how much force the node has violated the law if it has begun
    /// to stick or to slip; else 0.
    double
    update(FrictionState<dim>       &state,
           const ContactForce<dim>  &force,
           const TangentVector<dim> &slip,
           const TangentVector<dim> &slope,
           const double              length) const;

    /// The law at a node that slips, with the present @p slip.
    /// @throws ConvergenceError where the flank is so steep that friction
    /// carries the whole vertical force.
    ForceSlope<dim>
    force_slope(const IndenterSurface<dim> &surface,
                const FrictionState<dim>   &state,
                const TangentVector<dim>   &slip) const;

  private:
    const double coefficient, modulus;
  };
} // namespace ElastoPlastic

#endif
