// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "solver/reduced_unknowns.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    add_along_force_slope(ReducedUnknowns::Vector &forces,
                          const SlopedBound       &bound,
                          const double             force)
    {
      for (unsigned int j = 0; j < bound.n_others; ++j)
        forces.local_element(bound.others[j]) += bound.force_slope[j] * force;
    }
  } // namespace



  ReducedUnknowns::ReducedUnknowns(
    const std::vector<unsigned int>         &constrained,
    const std::vector<unsigned int>         &coupled,
    const MPI_Comm                           communicator,
    const std::vector<unsigned int>         &active,
    const std::shared_ptr<const SharedRows> &shared_rows)
    : constrained(constrained)
    , coupled(coupled)
    , active(active)
    , shared_rows(shared_rows)
    , communicator(communicator)
    , leading_rank(
        Utilities::MPI::min(coupled.empty() ?
                              Utilities::MPI::n_mpi_processes(communicator) :
                              Utilities::MPI::this_mpi_process(communicator),
                            communicator))
  {}



  void
  ReducedUnknowns::set_sloped_bounds(const std::vector<SlopedBound> &bounds)
  {
    sloped_bounds = bounds;
    is_sloped     = true;
    has_friction =
      Utilities::MPI::logical_or(std::any_of(bounds.begin(),
                                             bounds.end(),
                                             [](const SlopedBound &bound) {
                                               return bound.force_slope !=
                                                      bound.slope;
                                             }),
                                 communicator);
  }



  double
  ReducedUnknowns::along_slope(const SlopedBound &bound, const Vector &u)
  {
    double sum = 0;
    for (unsigned int j = 0; j < bound.n_others; ++j)
      sum += bound.slope[j] * u.local_element(bound.others[j]);
    return sum;
  }



  bool
  ReducedUnknowns::has_coupling() const
  {
    return leading_rank < Utilities::MPI::n_mpi_processes(communicator);
  }



  bool
  ReducedUnknowns::is_trivial() const
  {
    return !has_coupling() && !shared_rows && !is_sloped;
  }



  bool
  ReducedUnknowns::owns_leader() const
  {
    return leading_rank == Utilities::MPI::this_mpi_process(communicator);
  }



  void
  ReducedUnknowns::expand(Vector &increment) const
  {
    if (is_trivial())
      return;
    const double motion = has_coupling() ? leading_value(increment) : 0.;
    for (const unsigned int i : coupled)
      increment.local_element(i) = motion;
    if (shared_rows)
      {
        Vector relative = increment;
        relative.add(-motion);
        for (const SlopedBound &bound : sloped_bounds)
          relative.local_element(bound.index) -= along_slope(bound, increment);
        const Vector sums = shared_rows->sums(relative);
        for (const unsigned int i : active)
          increment.local_element(i) -= sums.local_element(i);
      }
    for (const SlopedBound &bound : sloped_bounds)
      if (bound.active)
        increment.local_element(bound.index) += along_slope(bound, increment);
  }



  void
  ReducedUnknowns::add_curvature(Vector &forces, const Vector &increment) const
  {
    for (const SlopedBound &bound : sloped_bounds)
      for (unsigned int j = 0; j < bound.n_others; ++j)
        for (unsigned int l = 0; l < bound.n_others; ++l)
          forces.local_element(bound.others[j]) -=
            bound.force * bound.curvature[j][l] *
            increment.local_element(bound.others[l]);
  }



  void
  ReducedUnknowns::contract(Vector &forces) const
  {
    double sum = 0;
    for (const unsigned int i : coupled)
      sum += forces.local_element(i);
    if (shared_rows)
      {
        const Vector shares = shared_rows->shares(forces);
        forces -= shares;
        for (unsigned int i = 0; i < shares.locally_owned_size(); ++i)
          sum += shares.local_element(i);
        for (const SlopedBound &bound : sloped_bounds)
          if (!bound.active)
            add_along_force_slope(forces,
                                  bound,
                                  shares.local_element(bound.index));
      }
    for (const SlopedBound &bound : sloped_bounds)
      if (bound.active)
        add_along_force_slope(forces, bound, forces.local_element(bound.index));
    set_leading_value(forces,
                      has_coupling() ? Utilities::MPI::sum(sum, communicator) :
                                       0.);
  }



  // (What is shared, and what slopes couple, is left out.)
  void
  ReducedUnknowns::contract_diagonal(Vector &diagonal) const
  {
    double sum = 0;
    for (const unsigned int i : coupled)
      sum += diagonal.local_element(i);
    for (const SlopedBound &bound : sloped_bounds)
      for (unsigned int j = 0; bound.active && j < bound.n_others; ++j)
        diagonal.local_element(bound.others[j]) +=
          bound.slope[j] * bound.slope[j] * diagonal.local_element(bound.index);
    set_leading_value(diagonal,
                      has_coupling() ? Utilities::MPI::sum(sum, communicator) :
                                       0.);
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



  void
  ReducedUnknowns::set_slopes(Vector &vector) const
  {
    for (const SlopedBound &bound : sloped_bounds)
      for (unsigned int j = 0; bound.active && j < bound.n_others; ++j)
        vector.local_element(bound.others[j]) = bound.slope[j];
  }
} // namespace ElastoPlastic
