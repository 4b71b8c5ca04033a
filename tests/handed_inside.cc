// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces of nodes that the indenter has not reached go to their inner
// neighbours, over several nodes and ranks, and none is lost. Which those are.

#include "contact/edge_law.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// A line of nodes under a parabola with its tip at the first one. The ranks
  /// have consecutive nodes.
  struct Line
  {
    explicit Line(const unsigned int n)
    {
      const unsigned int rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      begin = rank * n / n_ranks;
      end   = (rank + 1) * n / n_ranks;
      std::vector<EdgeLaw::Node> nodes;
      std::vector<EdgeLaw::Pair> pairs;
      for (unsigned int k = begin; k < end; ++k)
        {
          nodes.push_back({k, k - begin, 0.5 * k * k, 1.});
          if (k + 1 < n)
            pairs.emplace_back(k, k + 1);
        }
      law.reinit(nodes, pairs, MPI_COMM_WORLD);
    }

    /// What each node has, of all ranks, of what value(k) is.
    template <typename Value>
    std::vector<double>
    handed_inside(const Value &value, const unsigned int n_kept) const
    {
      std::vector<double> values, forces;
      std::vector<bool>   keep;
      for (unsigned int k = begin; k < end; ++k)
        {
          values.push_back(value(k));
          forces.push_back(10. - k);
          keep.push_back(k < n_kept);
        }
      return of_all_ranks(law.handed_inside(values, keep, forces));
    }

    static std::vector<double>
    of_all_ranks(const std::vector<double> &values)
    {
      std::vector<double> all;
      for (const auto &of_rank :
           Utilities::MPI::all_gather(MPI_COMM_WORLD, values))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      return all;
    }

    unsigned int begin, end;
    EdgeLaw      law;
  };



  void
  print(const std::string &name, const std::vector<double> &values)
  {
    output() << name << ':';
    for (const double value : values)
      output() << ' ' << value;
    output() << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Line                       line(6);
  const auto                       value = [](const unsigned int k) {
    return 1. + k;
  };
  print("all are kept", line.handed_inside(value, 6));
  print("the last is handed on", line.handed_inside(value, 5));
  print("three are", line.handed_inside(value, 3));
  print("negative ones, too",
        line.handed_inside([&](const unsigned int k) { return -value(k); }, 3));
  // (gaps; which are closed, entering and open)
  const auto passed = [&](const std::vector<double> &gaps,
                          const std::string         &statuses) {
    std::vector<double>        own_gaps;
    std::vector<ContactStatus> own;
    for (unsigned int k = line.begin; k < line.end; ++k)
      {
        own_gaps.push_back(gaps[k]);
        own.push_back(statuses[k] == 'c' ? ContactStatus::closed :
                      statuses[k] == 'e' ? ContactStatus::entering :
                                           ContactStatus::open);
      }
    std::vector<double> flags;
    for (const bool has_passed : line.law.passed(own_gaps, own))
      flags.push_back(has_passed ? 1. : 0.);
    return line.of_all_ranks(flags);
  };
  print("passed: inside before the edge",
        passed({0., 0., -1., -1., 1., 2.}, "cceeoo"));
  print("passed: not outside of it",
        passed({0., 0., 0., 1., 2., 3.}, "ccceeo"));
  print("passed: in the middle", passed({0., 0., 1., 0., 0., 3.}, "ccecco"));
  print("at nodes nothing is",
        EdgeLaw().handed_inside({1., 2.}, {true, false}, {1., 1.}));
}
