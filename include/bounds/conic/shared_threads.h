// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_shared_threads_h
#define bounds_conic_shared_threads_h

#include <algorithm>
#include <atomic>

#include <omp.h>

namespace ElastoPlastic
{
  /// The threads of OpenMP, where several threads of the program minimize() at
  /// the same time: all have the same share, and the last one has all.
  class SharedThreads
  {
  public:
    /// While it lives, this thread takes part: it is one of those that share
    /// @p n_threads.
    explicit SharedThreads(const int n_threads)
    {
      omp_set_num_threads(n_threads);
      ++n_sharing();
    }

    ~SharedThreads()
    {
      --n_sharing();
    }

    SharedThreads(const SharedThreads &) = delete;
    SharedThreads &
    operator=(const SharedThreads &) = delete;

    /// Until the end of the scope, this thread begins as many as are its share
    /// at the beginning of the scope; all, if nothing is shared.
    class Share
    {
    public:
      Share()
        : all(omp_get_max_threads())
      {
        omp_set_num_threads(std::max(1, all / std::max(1, int(n_sharing()))));
      }

      ~Share()
      {
        omp_set_num_threads(all);
      }

      Share(const Share &) = delete;
      Share &
      operator=(const Share &) = delete;

    private:
      const int all;
    };

  private:
    static std::atomic<int> &
    n_sharing()
    {
      static std::atomic<int> n = 0;
      return n;
    }
  };
} // namespace ElastoPlastic

#endif
