// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_initial_strains_h
#define mechanics_initial_strains_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/symmetric_tensor.h>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The elastic strains of the initial stress at the points of all cell
  /// batches, in the layout of the batches. They take no memory as long as
  /// there are none.
  class InitialStrains
  {
  public:
    using Strain = SymmetricTensor<2, 3, Simd<double>>;

    /// There are none.
    void
    clear()
    {
      strains.clear();
    }

    /// There are some, which are zero to begin with.
    void
    reinit(const unsigned int n_cell_batches, const unsigned int n_points)
    {
      n_points_per_cell = n_points;
      strains.clear();
      strains.resize(n_cell_batches * n_points, Strain());
    }

    bool
    are_present() const
    {
      return !strains.empty();
    }

    Strain &
    at(const unsigned int batch, const unsigned int point)
    {
      return strains[batch * n_points_per_cell + point];
    }

    const Strain &
    at(const unsigned int batch, const unsigned int point) const
    {
      return strains[batch * n_points_per_cell + point];
    }

  private:
    unsigned int          n_points_per_cell = 0;
    AlignedVector<Strain> strains;
  };
} // namespace ElastoPlastic

#endif
