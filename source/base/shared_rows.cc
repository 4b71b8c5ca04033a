// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/shared_rows.h"

namespace ElastoPlastic
{
  SharedRows::SharedRows(
    const Rows                                               &rows,
    const std::vector<unsigned int>                          &entries,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &layout)
    : rows(rows)
    , entries(entries)
    , few(layout)
  {}



  // (Indices are exact as numbers of double precision.)
  std::vector<SharedRows::Entry>
  SharedRows::global_entries(const Utilities::MPI::Partitioner &layout) const
  {
    for (unsigned int k = 0; k < entries.size(); ++k)
      few.local_element(k) = layout.local_to_global(entries[k]);
    few.update_ghost_values();
    const auto index = [&](const unsigned int k) {
      return static_cast<types::global_dof_index>(few.local_element(k));
    };
    std::vector<Entry> result;
    rows.for_each_entry(
      [&](const unsigned int i, const unsigned int j, const double value) {
        result.push_back({index(i), index(j), value});
      });
    few.zero_out_ghost_values();
    return result;
  }
} // namespace ElastoPlastic
