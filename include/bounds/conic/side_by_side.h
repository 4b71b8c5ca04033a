// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_side_by_side_h
#define bounds_conic_side_by_side_h

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

#include <omp.h>

namespace ElastoPlastic
{
  /// Calls two functions. If there are several threads (OpenMP), each has half
  /// of them, and all when the other has ended: they minimize() at the same
  /// time, and do what else they do in turn (ExclusiveWork); the first one
  /// begins. If the second does not find enough memory beside the first
  /// (MemoryError), it is called again when that has ended. If both throw, the
  /// error of the first counts.
  void
  call_side_by_side(const std::function<void()> &first,
                    const std::function<void()> &second);



  /// While it lives, no other thread has one: what programs are made of, and
  /// what is made of their solutions, is the work of one thread at a time. For
  /// deal.II's matrices call the BLAS, and not every BLAS can be called by two
  /// threads at a time (see DensePanels); and METIS takes the random numbers of
  /// the C library.
  class ExclusiveWork
  {
  public:
    ExclusiveWork()
    {
      mutex().lock();
      is_held = true;
    }

    ~ExclusiveWork()
    {
      is_held = false;
      mutex().unlock();
    }

    ExclusiveWork(const ExclusiveWork &) = delete;
    ExclusiveWork &
    operator=(const ExclusiveWork &) = delete;

    /// Lets other threads begin until its end, if this thread has the work for
    /// itself.
    class Pause
    {
    public:
      Pause()
        : is_pause(is_held)
      {
        if (is_pause)
          {
            is_held = false;
            mutex().unlock();
          }
      }

      ~Pause()
      {
        if (is_pause)
          {
            mutex().lock();
            is_held = true;
          }
      }

      Pause(const Pause &) = delete;
      Pause &
      operator=(const Pause &) = delete;

    private:
      const bool is_pause;
    };

  private:
    static std::mutex &
    mutex()
    {
      static std::mutex the_mutex;
      return the_mutex;
    }

    /// By this thread.
    inline static thread_local bool is_held = false;
  };



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
