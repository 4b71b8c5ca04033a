// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The law of the edge of a contact that ends within faces, on nodes of a line
// and of a square without any body: its coefficients and what they do not
// depend on.

#include <cmath>
#include <random>

#include "contact/edge_law.h"
#include "edge_law_samples.h"
#include "verdict.h"

using namespace EdgeLawSamples;

namespace
{
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
    verify("  rises are those of the gap, and less within six of them",
           std::max({std::abs(law.rise(4) - 0.1 / 36.),
                     std::abs(law.rise(5) - 0.1 / 9.),
                     std::abs(law.rise(7) - 0.1 * 4. / 9.),
                     std::abs(Grid(10, 1, cone(3., 0.)).law().rise(9) - 0.1),
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



  /// A plane of symmetry through nodes, on which they have half of their area:
  /// the part on one side of it has the same law.
  void
  check_symmetry()
  {
    output() << "Half of a square" << std::endl;
    const unsigned int          n_x = 12, n_y = 21;
    const std::pair<Grid, Grid> paraboloids = {{2 * n_x - 1,
                                                n_y,
                                                paraboloid(n_x - 1., 9.3)},
                                               {n_x, n_y, paraboloid(0., 9.3)}};
    const std::pair<Grid, Grid> pyramids    = {
         {2 * n_x - 1, n_y, pyramid(n_x - 1., 9.)}, {n_x, n_y, pyramid(0., 9.)}};
    for (const auto &[whole, half] : {paraboloids, pyramids})
      {
        const EdgeLaw law = whole.law(), law_of_half = half.law();
        const double  depth = depth_of(half);
        const auto    place = law.largest_openings(whole.gaps(depth));
        const auto    place_of_half =
          law_of_half.largest_openings(half.gaps(depth));
        double       error      = 0;
        unsigned int n_entering = 0;
        for (unsigned int x = 0; x < n_x; ++x)
          for (unsigned int y = 0; y < n_y; ++y)
            {
              const unsigned int k = whole.at(n_x - 1 + x, y),
                                 h = half.at(x, y);
              const double opening = place_of_half.openings(h);
              n_entering += (opening > 0. && opening < 1.);
              error = std::max(
                {error,
                 std::abs(law.rise(k) - law_of_half.rise(h)),
                 std::abs(place.openings(k) - opening),
                 std::abs(place.allowances[k] - place_of_half.allowances[h])});
            }
        verify("  some nodes are entering", n_entering > 0);
        verify("  rises, openings and allowances of the whole", error, 1e-14);
      }
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
    // each pair is one of a face of some rank
    std::vector<EdgeLaw::Pair> pairs;
    for (unsigned int k = 0; k < grid.pairs.size(); ++k)
      if (k % n_ranks == rank)
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
      check_scale(grid);
      check_ranks(grid);
    }
  check_symmetry();
  check_continuity();
}
