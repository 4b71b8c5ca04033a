// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_edge_law_samples_h
#define tests_edge_law_samples_h

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "contact/edge_law.h"

/// Nodes of a line and of a square without any body, under indenters of several
/// shapes.
namespace EdgeLawSamples
{
  using namespace ElastoPlastic;

  using Gap = std::function<double(const double, const double)>;

  inline double
  largest_difference(const std::vector<double> &one,
                     const std::vector<double> &other)
  {
    double difference = 0;
    for (unsigned int k = 0; k < one.size(); ++k)
      difference = std::max(difference, std::abs(one[k] - other[k]));
    return Utilities::MPI::max(difference, MPI_COMM_WORLD);
  }



  inline double
  largest(const std::vector<double> &values)
  {
    return largest_difference(values, std::vector<double>(values.size()));
  }



  /// Nodes at integer coordinates, n_x times n_y of them, with the distance 1;
  /// neighbours also across the diagonals of faces. Between their unknowns are
  /// others.
  class Grid
  {
  public:
    Grid(const unsigned int n_x, const unsigned int n_y, const Gap &gap)
      : n_x(n_x)
    {
      for (unsigned int y = 0; y < n_y; ++y)
        for (unsigned int x = 0; x < n_x; ++x)
          {
            const unsigned int k = nodes.size();
            // (nodes on the rim have less)
            double area = 1.;
            for (const bool at_rim :
                 {x == 0 || x == n_x - 1, n_y > 1 && (y == 0 || y == n_y - 1)})
              area *= (at_rim ? 0.5 : 1.);
            nodes.push_back({dof(k), 3 * k + 1, gap(x, y), area});
          }
      const auto add_face = [&](const std::vector<unsigned int> &corners) {
        for (const unsigned int one : corners)
          for (const unsigned int other : corners)
            if (one < other)
              pairs.emplace_back(dof(one), dof(other));
      };
      for (unsigned int x = 1; x < n_x; ++x)
        {
          if (n_y == 1)
            add_face({at(x - 1, 0), at(x, 0)});
          for (unsigned int y = 1; y < n_y; ++y)
            add_face({at(x - 1, y - 1), at(x, y - 1), at(x - 1, y), at(x, y)});
        }
      // a neighbour that is no node
      pairs.emplace_back(dof(0), dof(0) + 1);
    }

    /// On all ranks the same.
    EdgeLaw
    law() const
    {
      EdgeLaw result;
      result.reinit(nodes, pairs, MPI_COMM_SELF);
      return result;
    }

    std::vector<double>
    gaps(const double depth) const
    {
      std::vector<double> result;
      for (const EdgeLaw::Node &node : nodes)
        result.push_back(node.gap - depth);
      return result;
    }

    unsigned int
    at(const unsigned int x, const unsigned int y) const
    {
      return x + n_x * y;
    }

    std::vector<EdgeLaw::Node> nodes;
    std::vector<EdgeLaw::Pair> pairs;

  private:
    static types::global_dof_index
    dof(const unsigned int node)
    {
      return 2 + 5 * node;
    }

    const unsigned int n_x;
  };



  inline Gap
  paraboloid(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.01 * (std::pow(x - tip_x, 2) + 1.3 * std::pow(y - tip_y, 2));
    };
  }



  inline Gap
  cone(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.1 * std::hypot(x - tip_x, y - tip_y);
    };
  }



  /// Its edges along diagonals, its contours along the mesh.
  inline Gap
  pyramid(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.1 * std::max(std::abs(x - tip_x), std::abs(y - tip_y));
    };
  }



  inline double
  rough(const double x, const double y)
  {
    return 0.003 * (x + y) + 0.01 * std::sin(1.1 * x + 0.3 * y) +
           0.008 * std::sin(2.7 * x - 1.9 * y);
  }



  struct Sample
  {
    std::string name;
    Grid        grid;
  };



  inline const std::vector<Sample> samples = {
    {"paraboloid on a line", {14, 1, paraboloid(1.3, 0.)}},
    {"paraboloid", {12, 11, paraboloid(4.3, 5.1)}},
    {"cone", {12, 11, cone(4.3, 5.1)}},
    {"pyramid", {17, 11, pyramid(5., 5.)}},
    {"rough surface", {12, 12, rough}}};



  inline std::vector<double>
  unit(const unsigned int n, const unsigned int k)
  {
    std::vector<double> result(n);
    result[k] = 1.;
    return result;
  }



  /// A place as contact problems have it: closed are those that touch.
  inline std::vector<ContactStatus>
  touching(const EdgeLaw &law, const std::vector<double> &gaps)
  {
    std::vector<ContactStatus> statuses;
    const auto                 place = law.largest_openings(gaps);
    for (unsigned int k = 0; k < gaps.size(); ++k)
      {
        const double distance = gaps[k] + place.allowances[k];
        statuses.push_back(distance <= 0. ? ContactStatus::closed :
                                            law.status_at(k, distance));
      }
    return statuses;
  }



  inline double
  depth_of(const Grid &grid)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const EdgeLaw::Node &node : grid.nodes)
      smallest = std::min(smallest, node.gap);
    double largest = smallest;
    for (const EdgeLaw::Node &node : grid.nodes)
      largest = std::max(largest, node.gap);
    return 0.5 * (smallest + largest);
  }
} // namespace EdgeLawSamples

#endif
