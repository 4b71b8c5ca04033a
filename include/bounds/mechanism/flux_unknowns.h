// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_flux_unknowns_h
#define bounds_mechanism_flux_unknowns_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "bounds/body/split_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The linear velocities on a tetrahedron whose unknowns are the normal
  /// components at the corners of its faces: the element of Brezzi, Douglas and
  /// Marini in space @cite nedelec_1986. Where faces meet in a corner, the
  /// velocity follows from those of the three.
  class FluxElement
  {
  public:
    FluxElement(const SplitBody<3> &body, const unsigned int tetrahedron);

    /// At corner @p v, of the function whose normal component on face @p k is 1
    /// there, in the direction of normal(), and zero on the other two faces. At
    /// the other corners, it vanishes.
    Tensor<1, 3>
    velocity(const unsigned int k, const unsigned int v) const
    {
      return normal_derivatives[k] * (corners[k] - corners[v]);
    }

    /// Its strain rate, which is constant.
    SymmetricTensor<2, 3>
    rate(const unsigned int k, const unsigned int v) const
    {
      return symmetrize(outer_product(velocity(k, v), gradients_of_corners[v]));
    }

    const Corners<3> corners;

  private:
    const std::array<Tensor<1, 3>, 4> gradients_of_corners;
    std::array<double, 4>             normal_derivatives;
  };



  /// The unknowns of such velocities, whose normal components are continuous,
  /// and zero on closed faces.
  class FluxUnknowns
  {
  public:
    /// @p body must live as long as this object.
    explicit FluxUnknowns(const SplitBody<3> &body);

    unsigned int
    size() const
    {
      return n_unknowns;
    }

    /// That of face @p k of a tetrahedron at its corner @p v;
    /// invalid_unsigned_int if it vanishes.
    unsigned int
    at(const unsigned int tetrahedron,
       const unsigned int k,
       const unsigned int v) const
    {
      return numbering[3 * body.mesh.simplices[tetrahedron].faces[k] +
                       (v < k ? v : v - 1)];
    }

    /// Calls @p action(k, v, unknown) for those of a tetrahedron.
    template <typename Action>
    void
    for_each(const unsigned int tetrahedron, const Action &action) const
    {
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int v = 0; v < 4; ++v)
          if (v != k && at(tetrahedron, k, v) != numbers::invalid_unsigned_int)
            action(k, v, at(tetrahedron, k, v));
    }

    /// Removes the divergence by the smallest change of the @p fluxes.
    void
    remove_divergence(Vector<double> &fluxes) const;

  private:
    const SplitBody<3>       &body;
    std::vector<unsigned int> numbering; ///< by faces and their corners
    unsigned int              n_unknowns = 0;
  };
} // namespace ElastoPlastic

#endif
