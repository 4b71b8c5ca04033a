// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_local_stresses_h
#define bounds_stress_local_stresses_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  /// What is known of sigma_33 in the plane: it is a field of its own, which
  /// need not be continuous; or the mean of sigma_11 and sigma_22, with which
  /// the yield condition of plane strain admits most (with Hill's criterion,
  /// see weights_out_of_plane()); or zero; or what the others leave to the
  /// equilibrium of a body of revolution. In space, it is like the other
  /// components.
  enum class OutOfPlane
  {
    unknown,
    mean,
    zero,
    circumferential,
    like_others
  };



  /// The stresses of a degree that the equilibrium method chooses from on one
  /// simplex. They are Johnson-Mercier stresses S of what the mesh shows; in a
  /// body of revolution, the stress times the distance r from the axis. With
  /// it, its equations
  ///   d_r S_rr + d_z S_rz - sigma_tt = 0,   d_r S_rz + d_z S_zz = 0
  /// are those of a plane but for the circumferential stress sigma_tt. That is
  /// defined by the first of them: on each part a polynomial whose degree is
  /// one less than that of S. On the axis, S is zero, as it is for all bounded
  /// stresses.
  ///
  /// "Weighted" is S, with 33 for its component r sigma_tt; weights are those
  /// of SplitBody, relative to its unit.
  template <int dim>
  class LocalStresses
  {
  public:
    /// @p body must live as long as this object.
    LocalStresses(const SplitBody<dim> &body,
                  const unsigned int    simplex,
                  const unsigned int    degree)
      : body(body)
      , simplex(simplex)
      , degree(degree)
    {}

    /// At the points that coefficients belong to: they are the coefficients of
    /// the weight, which is linear. They are zero on the axis only.
    std::vector<double>
    weights() const;

    /// At the corners of the parts.
    std::vector<double>
    weights_at_corners() const
    {
      return LocalStresses(body, simplex, /* degree = */ 1).weights();
    }

    /// At the centre of gravity.
    double
    weight_of_centre() const
    {
      return weights_at_corners()[place_of_centre<dim>(0)];
    }

    /// All weighted stresses, by values: see JohnsonMercier::basis(). There are
    /// less where the simplex touches the axis.
    FullMatrix<double>
    basis() const;

    /// Those that are in equilibrium, see JohnsonMercier::equilibrated_basis();
    /// in a body of revolution 12 of the first and 27 of the second degree,
    /// less at the axis.
    FullMatrix<double>
    equilibrated_basis() const;

    /// The coefficients of the weighted pressure of body forces over those of
    /// the weight, where these are positive, in the units of the body. In a
    /// body of revolution, the degree must be 2, that of the product.
    std::vector<double>
    pressures(const double load_factor) const;

    /// What turns @p n unknowns, the first of which are those of this @p basis,
    /// into the coefficients of the weighted stresses, all components at each
    /// point. If sigma_33 is unknown, its coefficients come next.
    FullMatrix<double>
    point_stresses(const FullMatrix<double> &basis,
                   const OutOfPlane          out_of_plane,
                   const unsigned int        n) const;

    /// The coefficients of the circumferential stress on the parts that goes
    /// with weighted stresses given by values, in the units of the body.
    FullMatrix<double>
    circumferential_matrix() const
    {
      return divergence_component(0);
    }

    /// What turns these coefficients into those of the weighted component 33.
    FullMatrix<double>
    weighting_matrix() const;

  private:
    using Element = JohnsonMercier<dim>;

    /// One @p component of the divergence on the parts, times the unit of
    /// length.
    FullMatrix<double>
    divergence_component(const unsigned int component) const;

    /// Adds the component 33 of the @p basis of a body of revolution.
    void
    add_circumferential_stress(FullMatrix<double>       &stresses,
                               const FullMatrix<double> &basis) const;

    const SplitBody<dim> &body;
    const unsigned int    simplex;
    const unsigned int    degree;
  };
} // namespace ElastoPlastic

#endif
