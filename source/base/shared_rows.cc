// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/shared_rows.h"

namespace ElastoPlastic
{
  SharedRows::SharedRows(const std::shared_ptr<const Matrix> &weights,
                         const std::shared_ptr<const Vector> &scale,
                         const Vector                        &active)
    : weights(weights)
    , scale(scale)
    , active(active)
  {}



  SharedRows::Vector
  SharedRows::sums(const Vector &u) const
  {
    Vector open(active.get_partitioner()), result(active.get_partitioner());
    for (unsigned int i = 0; i < open.locally_owned_size(); ++i)
      open.local_element(i) =
        (1. - active.local_element(i)) * u.local_element(i);
    weights->vmult(result, open);
    result.scale(*scale);
    return result;
  }



  SharedRows::Vector
  SharedRows::shares(const Vector &forces) const
  {
    Vector scaled(active.get_partitioner()), result(active.get_partitioner());
    for (unsigned int i = 0; i < scaled.locally_owned_size(); ++i)
      scaled.local_element(i) = active.local_element(i) *
                                scale->local_element(i) *
                                forces.local_element(i);
    weights->Tvmult(result, scaled);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) *= 1. - active.local_element(i);
    return result;
  }
} // namespace ElastoPlastic
