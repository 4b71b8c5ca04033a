// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_versions_h
#define output_versions_h

#include <string>

namespace ElastoPlastic
{
  /// What has made a result, in two lines that end with a line break and begin
  /// with @p prefix: program, revision and kind of build; deal.II, width of its
  /// batches and number of ranks. parameters.prm begins with them.
  std::string
  versions(const unsigned int n_ranks, const std::string &prefix = "");
} // namespace ElastoPlastic

#endif
