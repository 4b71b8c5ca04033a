// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_same_past_h
#define loading_same_past_h

#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  /// Checks that the load history @p now can go on where @p before has got to
  /// at @p time: the steps until then end at the same times under the same
  /// loads. What comes after may be different, and longer or shorter.
  /// @throws InputError that names the first difference
  void
  check_same_past(const LoadingParameters &before,
                  const LoadingParameters &now,
                  const double             time);
} // namespace ElastoPlastic

#endif
