// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include "bounds/conic/sparse_cholesky.h"
#include "bounds/mechanism/flux_unknowns.h"

namespace ElastoPlastic
{
  FluxElement::FluxElement(const SplitBody<3> &body, const unsigned int t)
    : corners(body.mesh.corners(body.mesh.simplices[t]))
    , gradients_of_corners(gradients(corners))
  {
    for (unsigned int k = 0; k < 4; ++k)
      normal_derivatives[k] =
        gradients_of_corners[k] *
        normal(
          body.mesh.corners(body.mesh.faces[body.mesh.simplices[t].faces[k]]));
  }



  FluxUnknowns::FluxUnknowns(const SplitBody<3> &body)
    : body(body)
  {
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      {
        const bool is_closed = body.support_of(f).is_closed;
        for (unsigned int i = 0; i < 3; ++i)
          numbering.push_back(is_closed ? numbers::invalid_unsigned_int :
                                          n_unknowns++);
      }
  }



  // The change is -D^T (D D^T)^-1 D, with a row of D for the flux out of each
  // tetrahedron; to repeat that removes rounding errors.
  void
  FluxUnknowns::remove_divergence(Vector<double> &fluxes) const
  {
    constexpr unsigned int n_repetitions = 3;

    const unsigned int     n = body.mesh.simplices.size();
    DynamicSparsityPattern couplings(n, n_unknowns), neighbors(n, n);
    for (unsigned int t = 0; t < n; ++t)
      for_each(t, [&](unsigned int, unsigned int, const unsigned int unknown) {
        couplings.add(t, unknown);
      });
    for (const auto &face : body.mesh.faces)
      for (const unsigned int s : face.neighbors)
        for (const unsigned int t : face.neighbors)
          if (s != numbers::invalid_unsigned_int &&
              t != numbers::invalid_unsigned_int)
            neighbors.add(s, t);
    SparsityPattern pattern, pattern_of_square;
    pattern.copy_from(couplings);
    pattern_of_square.copy_from(neighbors);

    SparseMatrix<double> divergence(pattern), square(pattern_of_square);
    for (unsigned int t = 0; t < n; ++t)
      {
        const FluxElement element(body, t);
        for_each(t, [&](const auto k, const auto v, const auto unknown) {
          divergence.set(t,
                         unknown,
                         volume(element.corners) * trace(element.rate(k, v)));
        });
      }
    for (unsigned int t = 0; t < n; ++t)
      for (auto entry = square.begin(t); entry != square.end(t); ++entry)
        for (auto d = divergence.begin(t); d != divergence.end(t); ++d)
          entry->value() +=
            d->value() * divergence.el(entry->column(), d->column());

    SparseCholesky factor(pattern_of_square);
    if (!factor.factorize(square))
      return; // what is left will be noticed
    Vector<double> flux(n), potential(n);
    for (unsigned int i = 0; i < n_repetitions; ++i)
      {
        divergence.vmult(flux, fluxes);
        factor.vmult(potential, flux);
        potential *= -1.;
        divergence.Tvmult_add(fluxes, potential);
      }
  }
} // namespace ElastoPlastic
