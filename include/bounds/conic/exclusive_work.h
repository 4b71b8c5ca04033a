// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_exclusive_work_h
#define bounds_conic_exclusive_work_h

#include <mutex>

namespace ElastoPlastic
{
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
} // namespace ElastoPlastic

#endif
