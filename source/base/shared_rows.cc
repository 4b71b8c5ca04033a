// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <map>

#include "base/ghost_values.h"
#include "base/shared_rows.h"

namespace ElastoPlastic
{
  SharedRows::Weights::Weights(
    const std::vector<Entry>                                 &entries,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &layout)
  {
    std::map<unsigned int, std::map<unsigned int, double>> values;
    for (const auto &[row, column, value] : entries)
      values[layout->global_to_local(row)][layout->global_to_local(column)] +=
        value;
    for (const auto &[row, of_row] : values)
      {
        std::vector<NodalInterpolation<1, double>::Entry> weights;
        for (const auto &[column, value] : of_row)
          weights.push_back({column, value});
        rows.add(row, weights);
      }
    rows.finish();
  }



  void
  SharedRows::Weights::vmult(Vector &result, const Vector &vector) const
  {
    const GhostValues ghosts(vector);
    result = 0.;
    rows.interpolate(vector.begin(),
                     [&](const unsigned int row, const double value) {
                       result.local_element(row) = value;
                     });
    result.compress(VectorOperation::add);
  }



  void
  SharedRows::Weights::Tvmult(Vector &result, const Vector &vector) const
  {
    const GhostValues ghosts(vector);
    result = 0.;
    rows.add_transpose(result.begin(), [&](const unsigned int row) {
      return vector.local_element(row);
    });
    result.compress(VectorOperation::add);
  }



  SharedRows::SharedRows(const std::shared_ptr<const Weights> &weights,
                         const std::shared_ptr<const Vector>  &scale,
                         const Vector                         &active)
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
