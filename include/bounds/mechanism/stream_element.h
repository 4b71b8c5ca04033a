// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_stream_element_h
#define bounds_mechanism_stream_element_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The velocities on a triangle that have a stream function: they do not
  /// change the volume, whatever its coefficients.
  ///
  /// In plane strain, v = (-d_y psi, d_x psi) with a cubic psi. In a body of
  /// revolution, psi = r^2 chi + phi and v = (-d_z psi, d_r psi) / r, so that
  ///   v = r (-d_z chi, d_r chi) + (0, 2 chi) + (-d_z phi, d_r phi) / r,
  /// with a cubic chi and, away from the axis, a linear phi: alone, r^2 chi
  /// cannot carry a flow between the axis and an indenter that does not touch
  /// it (doc/theory, "Limit loads").
  ///
  /// The local functions are the ten cubic ones of Bernstein's basis for psi or
  /// chi, and the three linear ones for phi. Matrices have a column for each.
  class StreamElement
  {
  public:
    /// @param has_flux whether there is a phi.
    StreamElement(const SplitBody<2> &body,
                  const unsigned int  triangle,
                  const bool          has_flux);

    /// The velocities of the local functions.
    const std::vector<SimplexVelocity<2>> functions;

    /// A strain rate is given by so many components, of Euclidean norm |e|, or
    /// with Hill's criterion |M^-T e|.
    unsigned int
    n_rate_components() const
    {
      return body.is_axisymmetric() ? 3 : 2;
    }

    /// Strain rates e_a, and weights w_a: the plastic work is at most
    /// sqrt(2/3) sigma_0 times the sum of all w_a |e_a|. The e_a are the
    /// coefficients of a polynomial in Bernstein's basis, and, if there is a
    /// phi, what bounds its distance from e.
    struct WeightedRates
    {
      FullMatrix<double>  rates; ///< components of e_0, e_1, ...
      std::vector<double> weights;
    };

    WeightedRates
    rates() const;

  private:
    const SplitBody<2> &body;
    const unsigned int  triangle;
    const Corners<2>    corners;
    const bool          has_flux;
  };
} // namespace ElastoPlastic

#endif
