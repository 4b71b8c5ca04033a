// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include "solver/reduced_unknowns.h"

namespace ElastoPlastic
{
  ReducedUnknowns::ReducedUnknowns(const std::vector<unsigned int> &constrained,
                                   const std::vector<unsigned int> &coupled,
                                   const MPI_Comm communicator)
    : constrained(constrained)
    , coupled(coupled)
    , communicator(communicator)
    , leading_rank(
        Utilities::MPI::min(coupled.empty() ?
                              Utilities::MPI::n_mpi_processes(communicator) :
                              Utilities::MPI::this_mpi_process(communicator),
                            communicator))
  {}



  bool
  ReducedUnknowns::has_coupling() const
  {
    return leading_rank < Utilities::MPI::n_mpi_processes(communicator);
  }



  bool
  ReducedUnknowns::owns_leader() const
  {
    return leading_rank == Utilities::MPI::this_mpi_process(communicator);
  }



  void
  ReducedUnknowns::expand(Vector &increment) const
  {
    if (!has_coupling())
      return;
    const double value = leading_value(increment);
    for (const unsigned int i : coupled)
      increment.local_element(i) = value;
  }



  void
  ReducedUnknowns::contract(Vector &forces) const
  {
    double sum = 0;
    if (has_coupling())
      {
        for (const unsigned int i : coupled)
          sum += forces.local_element(i);
        sum = Utilities::MPI::sum(sum, communicator);
      }
    set_leading_value(forces, sum);
  }



  double
  ReducedUnknowns::leading_value(const Vector &vector) const
  {
    const double value =
      owns_leader() ? vector.local_element(coupled.front()) : 0.;
    return Utilities::MPI::broadcast(communicator, value, leading_rank);
  }



  void
  ReducedUnknowns::set_leading_value(Vector &vector, const double value) const
  {
    set_entries(vector, 0.);
    if (owns_leader())
      vector.local_element(coupled.front()) = value;
  }



  void
  ReducedUnknowns::set_entries(Vector &vector, const double value) const
  {
    for (const unsigned int i : constrained)
      vector.local_element(i) = value;
    for (const unsigned int i : coupled)
      vector.local_element(i) = value;
  }
} // namespace ElastoPlastic
