// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_side_by_side_h
#define bounds_conic_side_by_side_h

#include <functional>

namespace ElastoPlastic
{
  /// Calls two functions. If there are several threads (OpenMP), each has half
  /// of them, and all when the other has ended: they minimize() at the same
  /// time, and do what else they do in turn (ExclusiveWork). One that does not
  /// find enough memory beside the other (MemoryError) is called again when
  /// that has ended. If both throw, the error of the first counts.
  void
  call_side_by_side(const std::function<void()> &first,
                    const std::function<void()> &second);
} // namespace ElastoPlastic

#endif
