// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The law of the edge of a contact that ends within faces, on nodes of a line
// and of a square without any body: its derivatives, and that the set of
// displacements is convex.

#include <cmath>
#include <random>

#include "edge_law_samples.h"
#include "verdict.h"

using namespace EdgeLawSamples;

namespace
{
  /// P(y), without its continuation: what EdgeLaw::share() is the derivative
  /// of.
  double
  penetration(const double opening)
  {
    return (1. - std::pow(1. - opening, 3)) / 6.;
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
    const unsigned int last = n - 1;
    verify("  one that is about to leave has the stiffness of its bound",
           law.has_part(last) &&
             law.stiffness(last, -1e-12) > 0.999 * law.stiffness(last, 1e-6));
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
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &[name, grid] : samples)
    {
      output() << static_cast<char>(std::toupper(name[0])) << name.substr(1)
               << std::endl;
      check_derivatives(grid);
      check_transpose(grid);
      check_convexity(grid);
    }
}
