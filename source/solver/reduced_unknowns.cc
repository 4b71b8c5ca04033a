// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "solver/reduced_unknowns.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the series of 1 / (1 - t).
    constexpr unsigned int n_terms = 3;

  } // namespace



  ReducedUnknowns::ReducedUnknowns(const std::vector<unsigned int> &constrained,
                                   const std::vector<unsigned int> &coupled,
                                   const MPI_Comm      communicator,
                                   const SharedForces &shared)
    : constrained(constrained)
    , coupled(coupled)
    , shared(shared)
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
    slopes = force_slopes = entering_slopes = {};
    for (const SlopedBound &bound : bounds)
      for (unsigned int j = 0; j < bound.n_others; ++j)
        {
          slopes.add(bound.index, bound.others[j], bound.slope[j]);
          force_slopes.add(bound.index, bound.others[j], bound.force_slope[j]);
          if (bound.entering)
            entering_slopes.add(bound.index, bound.others[j], -bound.slope[j]);
        }
    has_friction =
      Utilities::MPI::logical_or(std::any_of(bounds.begin(),
                                             bounds.end(),
                                             [](const SlopedBound &bound) {
                                               return bound.force_slope !=
                                                      bound.slope;
                                             }),
                                 communicator);
  }



  bool
  ReducedUnknowns::are_held_as_in(const ReducedUnknowns &other) const
  {
    const bool differ = constrained != other.constrained ||
                        coupled != other.coupled ||
                        is_sloped != other.is_sloped ||
                        have_entering() != other.have_entering() ||
                        !std::equal(shared.entering.begin(),
                                    shared.entering.end(),
                                    other.shared.entering.begin(),
                                    other.shared.entering.end(),
                                    [](const auto &a, const auto &b) {
                                      return a.index == b.index;
                                    });
    return !Utilities::MPI::logical_or(differ, communicator);
  }



  void
  ReducedUnknowns::expand(Vector &increment) const
  {
    if (is_trivial())
      return;
    const double motion = has_coupling() ? leading_value(increment) : 0.;
    std::vector<std::pair<unsigned int, double>> sums;
    if (shared.rows)
      shared.rows->sums(increment, [&](const unsigned int i, const double sum) {
        sums.emplace_back(i, sum);
      });
    for (const unsigned int i : coupled)
      increment.local_element(i) = motion;
    for (const EnteringUnknown &unknown : shared.entering)
      increment.local_element(unknown.index) += motion;
    for (const auto &[i, sum] : sums)
      increment.local_element(i) -= sum;
    slopes.expand(increment);
  }



  void
  ReducedUnknowns::reduce_product(Vector       &forces,
                                  const Vector &expanded,
                                  const Vector &reduced) const
  {
    for (const SlopedBound &bound : sloped_bounds)
      for (unsigned int j = 0; j < bound.n_others; ++j)
        for (unsigned int l = 0; l < bound.n_others; ++l)
          forces.local_element(bound.others[j]) -=
            bound.force * bound.curvature[j][l] *
            expanded.local_element(bound.others[l]);
    contract(forces);
    for (const auto &[index, stiffness] : shared.entering)
      forces.local_element(index) += stiffness * reduced.local_element(index);
  }



  void
  ReducedUnknowns::contract(Vector &forces) const
  {
    double sum = 0;
    for (const unsigned int i : coupled)
      sum += forces.local_element(i);
    for (const EnteringUnknown &unknown : shared.entering)
      sum += forces.local_element(unknown.index);
    force_slopes.contract(forces);
    if (shared.rows)
      // (zero but for entering ones)
      shared.rows->shares(forces,
                          [&](const unsigned int i, const double share) {
                            forces.local_element(i) -= share;
                          });
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
    slopes.contract_diagonal(diagonal);
    for (const auto &[index, stiffness] : shared.entering)
      {
        sum += diagonal.local_element(index);
        diagonal.local_element(index) += stiffness;
      }
    set_leading_value(diagonal,
                      has_coupling() ? Utilities::MPI::sum(sum, communicator) :
                                       0.);
  }



  // (1 - t)^-1 and its transpose, by the first terms of their series: from one
  // entering unknown to the next, t is at most a half, mostly.
  void
  ReducedUnknowns::release_entering(Vector &forces) const
  {
    if (!shared.rows)
      return;
    const std::vector<double> own = entering_values(forces);
    for (unsigned int n = 0; n < n_terms; ++n)
      {
        unsigned int k = 0;
        shared.rows->shares(forces,
                            [&](const unsigned int i, const double share) {
                              if (k < own.size() &&
                                  shared.entering[k].index == i)
                                forces.local_element(i) = own[k++] + share;
                            });
      }
    entering_slopes.contract(forces);
  }



  void
  ReducedUnknowns::bind_entering(Vector &increment) const
  {
    if (!shared.rows)
      return;
    entering_slopes.expand(increment);
    const std::vector<double> own = entering_values(increment);
    for (unsigned int n = 0; n < n_terms; ++n)
      {
        unsigned int k = 0;
        shared.rows->sums(increment,
                          [&](const unsigned int i, const double sum) {
                            while (k < own.size() &&
                                   shared.entering[k].index < i)
                              ++k;
                            if (k < own.size() && shared.entering[k].index == i)
                              increment.local_element(i) = own[k] + sum;
                          });
      }
  }



  std::vector<double>
  ReducedUnknowns::entering_values(const Vector &vector) const
  {
    std::vector<double> values;
    for (const EnteringUnknown &unknown : shared.entering)
      values.push_back(vector.local_element(unknown.index));
    return values;
  }



  void
  ReducedUnknowns::reduce_motion(Vector &vector, const double motion) const
  {
    for (const EnteringUnknown &unknown : shared.entering)
      vector.local_element(unknown.index) -= motion;
    bind_entering(vector);
    set_leading_value(vector, motion);
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
      for (unsigned int j = 0; !bound.entering && j < bound.n_others; ++j)
        vector.local_element(bound.others[j]) = bound.slope[j];
  }



  void
  ReducedUnknowns::set_springs(Vector &vector) const
  {
    for (const auto &[index, stiffness] : shared.entering)
      vector.local_element(index) = stiffness;
  }
} // namespace ElastoPlastic
