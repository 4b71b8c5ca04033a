// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  std::string
  list_of_names(const BoundaryNames &names)
  {
    std::string list;
    for (const auto &[name, id] : names)
      list += (list.empty() ? "" : ", ") + name;
    return list;
  }
} // namespace ElastoPlastic
