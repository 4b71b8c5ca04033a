// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <future>

#include "base/exceptions.h"
#include "bounds/conic/side_by_side.h"

#include <omp.h>

namespace ElastoPlastic
{
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
    std::future<void> end_of_second;
    {
      const ExclusiveWork work;
      end_of_second = std::async(std::launch::async, [&]() {
        const ExclusiveWork work_of_second;
        const SharedThreads sharing(n_threads);
        second();
      });
      const SharedThreads sharing(n_threads);
      first();
    }
    try
      {
        end_of_second.get();
      }
    catch (const MemoryError &)
      {
        second();
      }
  }
} // namespace ElastoPlastic
