// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_ghost_values_h
#define base_ghost_values_h

#include <deal.II/lac/la_parallel_vector.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Lets a vector know the values of its ghost entries, as long as this object
  /// lives. It must have none before, and has none afterwards. Collective.
  template <typename Number>
  class GhostValues
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    explicit GhostValues(const Vector &vector)
      : vector(vector)
    {
      Assert(!vector.has_ghost_elements(), ExcInternalError());
      vector.update_ghost_values();
    }

    ~GhostValues()
    {
      vector.zero_out_ghost_values();
    }

    GhostValues(const GhostValues &) = delete;
    GhostValues &
    operator=(const GhostValues &) = delete;

  private:
    const Vector &vector;
  };
} // namespace ElastoPlastic

#endif
