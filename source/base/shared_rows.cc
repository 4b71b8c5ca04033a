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
} // namespace ElastoPlastic
