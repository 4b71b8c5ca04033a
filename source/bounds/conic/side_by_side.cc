// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <future>

#include "base/exceptions.h"
#include "bounds/conic/side_by_side.h"

#include <omp.h>

namespace ElastoPlastic
{
  namespace
  {
    /// @return whether there was enough memory.
    bool
    call_beside(const std::function<void()> &function, const int n_threads)
    {
      const SharedThreads sharing(n_threads);
      try
        {
          function();
        }
      catch (const MemoryError &)
        {
          return false;
        }
      return true;
    }
  } // namespace



  void
  call_side_by_side(const std::function<void()> &first,
                    const std::function<void()> &second)
  {
    const int n_threads = omp_get_max_threads();
    if (n_threads == 1)
      {
        first();
        second();
        return;
      }
    std::future<bool> end_of_second;
    bool              first_has_ended = false;
    {
      const ExclusiveWork work; // the first one begins
      end_of_second   = std::async(std::launch::async, [&]() {
        const ExclusiveWork work_of_second;
        return call_beside(second, n_threads);
      });
      first_has_ended = call_beside(first, n_threads);
    }
    const bool second_has_ended = end_of_second.get();
    if (!first_has_ended)
      first();
    if (!second_has_ended)
      second();
  }
} // namespace ElastoPlastic
