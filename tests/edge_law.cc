// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The law of the edge of a contact that ends within faces, on nodes of a line
// and of a square without any body: its coefficients and what they do not
// depend on, its derivatives, and that the set of displacements is convex.

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "contact/edge_law.h"
#include "contact/rise_of_gap.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Gap = std::function<double(const double, const double)>;

  /// P(y), without its continuation: what EdgeLaw::share() is the derivative
  /// of.
  double
  penetration(const double opening)
  {
    return (1. - std::pow(1. - opening, 3)) / 6.;
  }



  double
  largest_difference(const std::vector<double> &one,
                     const std::vector<double> &other)
  {
    double difference = 0;
    for (unsigned int k = 0; k < one.size(); ++k)
      difference = std::max(difference, std::abs(one[k] - other[k]));
    return Utilities::MPI::max(difference, MPI_COMM_WORLD);
  }



  double
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
            if (x > 0)
              pairs.emplace_back(dof(k - 1), dof(k));
            if (y == 0)
              continue;
            pairs.emplace_back(dof(k - n_x), dof(k));
            if (x > 0)
              pairs.emplace_back(dof(k - n_x - 1), dof(k));
            if (x < n_x - 1)
              pairs.emplace_back(dof(k - n_x + 1), dof(k));
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



  Gap
  paraboloid(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.01 * (std::pow(x - tip_x, 2) + 1.3 * std::pow(y - tip_y, 2));
    };
  }



  Gap
  cone(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.1 * std::hypot(x - tip_x, y - tip_y);
    };
  }



  /// Its edges along diagonals, its contours along the mesh.
  Gap
  pyramid(const double tip_x, const double tip_y)
  {
    return [=](const double x, const double y) {
      return 0.1 * std::max(std::abs(x - tip_x), std::abs(y - tip_y));
    };
  }



  double
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



  const std::vector<Sample> samples = {
    {"paraboloid on a line", {14, 1, paraboloid(1.3, 0.)}},
    {"paraboloid", {12, 11, paraboloid(4.3, 5.1)}},
    {"cone", {12, 11, cone(4.3, 5.1)}},
    {"pyramid", {13, 11, pyramid(5., 5.)}},
    {"rough surface", {12, 12, rough}}};



  std::vector<double>
  unit(const unsigned int n, const unsigned int k)
  {
    std::vector<double> result(n);
    result[k] = 1.;
    return result;
  }



  /// c_jb R_b, row by row.
  std::vector<double>
  products_with_rises(const Grid &grid)
  {
    const EdgeLaw       law = grid.law();
    const unsigned int  n   = grid.nodes.size();
    std::vector<double> result;
    for (unsigned int j = 0; j < n; ++j)
      {
        const auto row = law.forces_inside(unit(n, j));
        for (unsigned int b = 0; b < n; ++b)
          result.push_back(row[b] * law.rise(b));
      }
    return result;
  }



  std::vector<double>
  rises(const EdgeLaw &law, const unsigned int n)
  {
    std::vector<double> result;
    for (unsigned int k = 0; k < n; ++k)
      result.push_back(law.rise(k));
    return result;
  }



  /// A place as contact problems have it: closed are those that touch.
  std::vector<ContactStatus>
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



  double
  depth_of(const Grid &grid)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const EdgeLaw::Node &node : grid.nodes)
      smallest = std::min(smallest, node.gap);
    double largest = smallest;
    for (const EdgeLaw::Node &node : grid.nodes)
      largest = std::max(largest, node.gap);
    return 0.73 * smallest + 0.27 * largest;
  }



  /// Which nodes have a part in the contact of others.
  void
  check_parts()
  {
    output() << "Parts" << std::endl;
    const Grid    punch(5, 4, [](const double, const double) { return 0.3; });
    const EdgeLaw flat = punch.law();
    bool          none = flat.exists();
    for (unsigned int k = 0; k < punch.nodes.size(); ++k)
      none = none && !flat.has_part(k) && flat.rise(k) == 0.;
    verify("  a flat punch is bounded as if its contact ended at nodes",
           none &&
             largest(
               flat
                 .place(punch.gaps(0.2),
                        std::vector<ContactStatus>(20, ContactStatus::open))
                 .allowances) == 0.);

    const Grid    line(8, 1, cone(3., 0.));
    const EdgeLaw law      = line.law();
    bool          expected = true;
    for (unsigned int k = 0; k < 8; ++k)
      expected = expected && law.has_part(k) == (k < 2 || k > 4);
    verify("  neither a tip nor its neighbours have part", expected);
    verify("  what presses on a tip is shared with none",
           largest(law.forces_inside(unit(8, 3))) == 0.);
    verify("  rises are those of the gap, or a quarter of the height",
           std::max({std::abs(law.rise(4) - 0.025),
                     std::abs(law.rise(5) - 0.05),
                     std::abs(law.rise(7) - 0.1),
                     law.rise(3)}),
           1e-15);
    verify("  coefficients are quotients of areas",
           std::max(std::abs(law.forces_inside(unit(8, 5))[6] - 1.),
                    std::abs(law.forces_inside(unit(8, 6))[7] - 0.5)),
           1e-15);

    EdgeLaw no_law;
    verify("  without nodes there is no law",
           !no_law.exists() && !no_law.has_part(0) && no_law.rise(0) == 0. &&
             no_law.rows({}, {}) == nullptr &&
             largest(no_law.place({0.1}, {ContactStatus::open}).allowances) ==
               0. &&
             no_law.status_at(0, 1e-9) == ContactStatus::open);
  }



  /// Of all nodes around a node, at most twice its own area is outside.
  void
  check_areas(const Grid &grid)
  {
    const RiseOfGap rise(grid.nodes, grid.pairs, MPI_COMM_SELF);
    double          sum_of_areas = 0;
    bool            upwards = true, parts = true;
    for (unsigned int j = 0; j < grid.nodes.size(); ++j)
      {
        double sum = 0;
        for (const auto &[b, coefficient] : rise.outer_neighbors[j])
          {
            sum += coefficient;
            upwards = upwards && coefficient > 0. &&
                      grid.nodes[b].gap > grid.nodes[j].gap;
            parts = parts && rise.have_part[b] && rise.rises[b] > 0.;
          }
        sum_of_areas = std::max(sum_of_areas, sum);
      }
    verify("  at most twice the area is outside", sum_of_areas, 2. + 1e-14);
    verify("  outer neighbours are higher", upwards && parts);
  }



  /// P' = share, its derivative and the rows, from places.
  void
  check_derivatives(const Grid &grid)
  {
    const EdgeLaw                          law      = grid.law();
    const unsigned int                     n        = grid.nodes.size();
    const std::vector<double>              gaps     = grid.gaps(depth_of(grid));
    std::vector<ContactStatus>             statuses = touching(law, gaps);
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> uniform(0.05, 0.95);

    // (A higher node that is entering changes what those below it are allowed;
    // here, only the nodes next to the closed ones are.)
    std::vector<bool> inside(n);
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int j = 0; j < n; ++j)
        if (statuses[j] == ContactStatus::closed &&
            law.forces_inside(unit(n, j))[b] > 0.)
          inside[b] = true;
    double       error = 0, error_of_stiffness = 0, error_of_integral = 0;
    unsigned int n_entering = 0;
    for (unsigned int b = 0; b < n; ++b)
      {
        if (statuses[b] == ContactStatus::closed || !inside[b])
          continue;
        ++n_entering;
        // to the opening y, or beyond the bound
        for (const double y : {0.05, uniform(random), 0.98, -0.2})
          {
            auto at = [&](const double opening) {
              std::vector<double> moved(n, 1.);
              auto                changed = statuses;
              for (unsigned int k = 0; k < n; ++k)
                {
                  if (statuses[k] == ContactStatus::closed)
                    moved[k] = 0.;
                  else
                    changed[k] = ContactStatus::open;
                }
              changed[b] = ContactStatus::entering;
              moved[b]   = 0.;
              moved[b] =
                opening * law.rise(b) - law.place(moved, changed).allowances[b];
              return law.place(moved, changed);
            };
            const double h     = 1e-5;
            const auto   there = at(y), before = at(y - h), after = at(y + h);
            error = std::max(error, std::abs(there.openings(b) - y));
            for (unsigned int j = 0; j < n; ++j)
              if (statuses[j] == ContactStatus::closed)
                {
                  const double c = law.forces_inside(unit(n, j))[b];
                  const double quotient =
                    (after.allowances[j] - before.allowances[j]) /
                    (2. * h * law.rise(b));
                  error =
                    std::max(error, std::abs(quotient - c * law.share(y)));
                }
            if (y > 0.)
              error_of_stiffness =
                std::max(error_of_stiffness,
                         std::abs((law.share(y - h) - law.share(y + h)) /
                                    (2. * h * law.rise(b)) -
                                  law.stiffness(b, y)) *
                           law.rise(b));
          }
      }
    for (double y = 0.; y < 1.; y += 0.1)
      {
        const double h = 1e-5;
        error_of_integral =
          std::max(error_of_integral,
                   std::abs((penetration(y + h) - penetration(y - h)) /
                              (2. * h) -
                            EdgeLaw::share(y)));
      }
    verify("  some nodes are entering", n_entering > 0);
    verify("  shares are the derivatives of what is allowed", error, 1e-8);
    verify("  stiffness is the derivative of shares", error_of_stiffness, 1e-8);
    verify("  the integral of shares", error_of_integral, 1e-8);
    verify("  an open node has no share, one at its bound the full one",
           EdgeLaw::share(1.) == 0. && EdgeLaw::share(2.) == 0. &&
             EdgeLaw::share(0.) == EdgeLaw::full_share() &&
             law.stiffness(0, 1.) == 0. && law.stiffness(0, -0.1) == 0.);
  }



  /// Forces inside are what the coefficients of the allowances make of forces,
  /// the other way round; and rows() has these coefficients.
  void
  check_transpose(const Grid &grid)
  {
    const EdgeLaw                          law = grid.law();
    const unsigned int                     n   = grid.nodes.size();
    std::mt19937                           random(2);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::vector<double>                    forces(n);
    for (double &force : forces)
      force = uniform(random);

    const std::vector<double> gaps     = grid.gaps(depth_of(grid));
    const auto                statuses = touching(law, gaps);
    const auto                place    = law.place(gaps, statuses);
    const auto                inside   = law.forces_inside(forces);
    double                    one = 0, other = 0;
    for (unsigned int k = 0; k < n; ++k)
      {
        one += forces[k] * place.allowances[k];
        other += inside[k] * law.rise(k) *
                 penetration(place.openings.local_element(k));
      }
    verify("  forces inside belong to what is allowed",
           std::abs(one - other),
           1e-14 * one);

    // (Unknowns that are none of the few are left alone.)
    SharedRows::Vector all(3 * n), expected(3 * n), found(3 * n);
    auto               active_forces = forces;
    for (unsigned int k = 0; k < n; ++k)
      {
        all(grid.nodes[k].entry) = forces[k];
        if (statuses[k] == ContactStatus::open)
          active_forces[k] = 0.;
      }
    const auto of_active  = law.forces_inside(active_forces);
    bool       some_enter = false;
    for (unsigned int k = 0; k < n; ++k)
      if (statuses[k] == ContactStatus::entering)
        {
          some_enter = true;
          expected(grid.nodes[k].entry) =
            EdgeLaw::share(place.openings.local_element(k)) * of_active[k];
        }
    law.rows(place, statuses)
      ->shares(all, [&](const unsigned int i, const double share) {
        found(i) = share;
      });
    found -= expected;
    verify("  rows have the shares of the entering nodes",
           some_enter && found.linfty_norm() < 1e-14);
  }



  /// With their largest openings, displacements in the set have others between
  /// them that are in the set.
  void
  check_convexity(const Grid &grid)
  {
    const EdgeLaw                          law = grid.law();
    const unsigned int                     n   = grid.nodes.size();
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> uniform(0., 1.);
    double                                 scale = 0;
    for (unsigned int k = 0; k < n; ++k)
      scale = std::max(scale, law.rise(k));

    // Lowers what penetrates, as ContactSet::project() does.
    const auto admissible = [&]() {
      std::vector<double> gaps(n);
      const double        spread = 1.5 * uniform(random);
      for (double &gap : gaps)
        gap = scale * spread * (uniform(random) - 0.5);
      const auto place = law.largest_openings(gaps);
      for (unsigned int k = 0; k < n; ++k)
        gaps[k] -= std::min(gaps[k] + place.allowances[k], 0.);
      return gaps;
    };
    const auto deepest = [&](const std::vector<double> &gaps) {
      const auto place  = law.largest_openings(gaps);
      double     result = 0;
      for (unsigned int k = 0; k < n; ++k)
        result = std::max(result, -gaps[k] - place.allowances[k]);
      return result / scale;
    };
    double       outside = 0, outside_between = 0, inside_nodes = 0;
    unsigned int n_partly_open = 0;
    for (unsigned int i = 0; i < 500; ++i)
      {
        const auto   one = admissible(), other = admissible();
        const double t       = (i % 2 == 0 ? 0.5 : uniform(random));
        auto         between = one;
        for (unsigned int k = 0; k < n; ++k)
          between[k] += t * (other[k] - one[k]);
        outside          = std::max({outside, deepest(one), deepest(other)});
        outside_between  = std::max(outside_between, deepest(between));
        const auto place = law.largest_openings(between);
        for (unsigned int k = 0; k < n; ++k)
          {
            const double y = place.openings.local_element(k);
            n_partly_open += (law.has_part(k) && y > 0. && y < 1.);
            inside_nodes = std::max(inside_nodes, -between[k] / scale);
          }
      }
    verify("  projected displacements are in the set", outside, 1e-13);
    verify("  so are those between them", outside_between, 1e-13);
    verify("  with nodes that penetrate, and some partly open",
           inside_nodes > 0.01 && n_partly_open > 500);
  }



  /// Changes of the gaps by the part 1e-9 change little, also where nodes are
  /// at the same height.
  void
  check_continuity()
  {
    output() << "Continuity" << std::endl;
    const std::vector<std::pair<std::string, Gap>> shapes = {
      {"paraboloid on a node", paraboloid(4., 5.)},
      {"paraboloid between two nodes", paraboloid(4.5, 5.)},
      {"paraboloid between four nodes", paraboloid(4.5, 5.5)},
      {"cone between four nodes", cone(4.5, 5.5)},
      {"pyramid on a node", pyramid(4., 5.)},
      {"pyramid between four nodes", pyramid(4.5, 5.5)},
      {"rough surface", rough},
      {"flat punch", [](const double, const double) {
         return 0.3;
       }}};
    for (const auto &[name, gap] : shapes)
      {
        const Grid   grid(12, 11, gap);
        const auto   n = static_cast<unsigned int>(grid.nodes.size());
        std::mt19937 random(4);
        std::uniform_real_distribution<double> uniform(-1., 1.);
        double                                 height = 0;
        for (const EdgeLaw::Node &node : grid.nodes)
          height = std::max(height, node.gap);
        const auto law      = grid.law();
        const auto here     = products_with_rises(grid);
        const auto gaps     = grid.gaps(depth_of(grid));
        const auto statuses = touching(law, gaps);
        const auto allowed  = law.place(gaps, statuses).allowances;
        double     of_rises = 0, of_products = 0, of_allowances = 0;
        for (unsigned int i = 0; i < 10; ++i)
          {
            Grid changed = grid;
            for (EdgeLaw::Node &node : changed.nodes)
              node.gap += 1e-9 * height * uniform(random);
            const auto changed_law = changed.law();
            of_rises               = std::max(of_rises,
                                largest_difference(rises(law, n),
                                                   rises(changed_law, n)));
            of_products =
              std::max(of_products,
                       largest_difference(here, products_with_rises(changed)));
            of_allowances = std::max(
              of_allowances,
              largest_difference(allowed,
                                 changed_law.place(gaps, statuses).allowances));
          }
        verify("  " + name + ", rises", of_rises, 1e-8 * height);
        verify("    their products with coefficients",
               of_products,
               1e-8 * height);
        verify("    what is allowed", of_allowances, 1e-8 * height);
      }
  }



  /// Another unit of length.
  void
  check_scale(const Grid &grid)
  {
    const unsigned int n     = grid.nodes.size();
    const EdgeLaw      law   = grid.law();
    double             error = 0, error_of_forces = 0;
    for (const double factor : {1e6, 1e-9})
      {
        Grid scaled = grid;
        for (EdgeLaw::Node &node : scaled.nodes)
          {
            node.gap *= factor;
            node.area *= factor * factor;
          }
        const EdgeLaw scaled_law = scaled.law();
        const auto    rises_here = rises(law, n);
        auto          others     = rises(scaled_law, n);
        for (double &rise : others)
          rise /= factor;
        error = std::max(error,
                         largest_difference(rises_here, others) /
                           largest(rises_here));
        for (unsigned int k = 0; k < n; ++k)
          error_of_forces =
            std::max(error_of_forces,
                     largest_difference(law.forces_inside(unit(n, k)),
                                        scaled_law.forces_inside(unit(n, k))));
      }
    verify("  rises have the unit of gaps", error, 1e-13);
    verify("  coefficients have none", error_of_forces, 1e-11);
  }



  /// The same on all ranks together as on each alone.
  void
  check_ranks(const Grid &grid)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const unsigned int n = grid.nodes.size();
    // (the first rank has few)
    const auto begin_of = [&](const unsigned int r) {
      return r == 0 ? 0 : r == n_ranks ? n : n * r * r / (n_ranks * n_ranks);
    };
    const unsigned int         begin = begin_of(rank), end = begin_of(rank + 1);
    std::vector<EdgeLaw::Node> nodes(grid.nodes.begin() + begin,
                                     grid.nodes.begin() + end);
    // two of three ranks know a pair
    std::vector<EdgeLaw::Pair> pairs;
    for (unsigned int k = 0; k < grid.pairs.size(); ++k)
      if (k % n_ranks == rank || (k + 1) % n_ranks == rank)
        pairs.push_back(grid.pairs[k]);
    EdgeLaw law;
    law.reinit(nodes, pairs, MPI_COMM_WORLD);

    const EdgeLaw             alone    = grid.law();
    const std::vector<double> gaps     = grid.gaps(depth_of(grid));
    const auto                statuses = touching(alone, gaps);
    std::vector<double>       forces(n);
    for (unsigned int k = 0; k < n; ++k)
      forces[k] = 1. + std::sin(k);
    const auto part = [&](const auto &of_all) {
      return typename std::decay<decltype(of_all)>::type(of_all.begin() + begin,
                                                         of_all.begin() + end);
    };
    bool same_parts = true;
    for (unsigned int k = begin; k < end; ++k)
      same_parts = same_parts && law.has_part(k - begin) == alone.has_part(k) &&
                   law.rise(k - begin) == alone.rise(k);
    verify("  the same nodes have part",
           !Utilities::MPI::logical_or(!same_parts, MPI_COMM_WORLD));
    const auto compare = [&](const EdgeLaw::Place &together,
                             const EdgeLaw::Place &expected) {
      double error =
        largest_difference(together.allowances, part(expected.allowances));
      for (unsigned int k = begin; k < end; ++k)
        error = std::max(error,
                         std::abs(together.openings.local_element(k - begin) -
                                  expected.openings.local_element(k)));
      return Utilities::MPI::max(error, MPI_COMM_WORLD);
    };
    verify("  place",
           compare(law.place(part(gaps), part(statuses)),
                   alone.place(gaps, statuses)),
           0.);
    verify("  largest openings",
           compare(law.largest_openings(part(gaps)),
                   alone.largest_openings(gaps)),
           0.);
    verify("  forces inside",
           largest_difference(law.forces_inside(part(forces)),
                              part(alone.forces_inside(forces))),
           1e-14);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_parts();
  for (const auto &[name, grid] : samples)
    {
      output() << static_cast<char>(std::toupper(name[0])) << name.substr(1)
               << std::endl;
      check_areas(grid);
      check_derivatives(grid);
      check_transpose(grid);
      check_convexity(grid);
      check_scale(grid);
      check_ranks(grid);
    }
  check_continuity();
}
