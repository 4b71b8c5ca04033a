// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_verdict_h
#define tests_verdict_h

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>

#include "base/exceptions.h"

// What the tests have in common: properties that hold are reported in words,
// so that rounding and the number of ranks leave the output alone.

/// Standard output of the first rank; the others write nowhere.
inline std::ostream &
output()
{
  static std::ostream nowhere(nullptr);
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ?
           std::cout :
           nowhere;
}



/// Reports that a property holds.
inline void
verify(const std::string &property, const bool holds)
{
  output() << property << ": " << (holds ? "ok" : "FAILED") << std::endl;
}



/// Reports that @p error does not exceed @p tolerance, or by how much it does.
inline void
verify(const std::string &property, const double error, const double tolerance)
{
  output() << property << ": ";
  if (error <= tolerance)
    output() << "ok" << std::endl;
  else
    output() << "FAILED, " << error << " > " << tolerance << std::endl;
}



/// Does on the first rank what the others wait for.
template <typename Task>
void
on_first_rank(const Task &task)
{
  MPI_Barrier(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    task();
  MPI_Barrier(MPI_COMM_WORLD);
}



/// Prints with which exit status and message @p action fails, if it does.
template <typename Action>
void
print_error(const std::string &title, const Action &action)
{
  output() << title << std::endl;
  try
    {
      action();
    }
  catch (const ElastoPlastic::Error &error)
    {
      output() << "  exit status " << static_cast<int>(error.status) << ": "
               << error.what() << std::endl;
    }
}

#endif
