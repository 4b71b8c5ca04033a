// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <iomanip>
#include <sstream>

#include "adaptivity/refinement.h"
#include "base/exceptions.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Trilinos numbers with 31 bits; the rest is for what an estimate misses.
    constexpr double n_indices = 2e9;
  } // namespace



  bool
  RefinementParameters::allows(const double n_unknowns) const
  {
    return n_unknowns <= n_indices &&
           (max_unknowns == 0 || n_unknowns <= max_unknowns);
  }



  void
  RefinementParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Refinement");
    prm.add_parameter("Strategy",
                      strategy,
                      "none: one mesh. global: every cell is refined from one "
                      "cycle to the next. adaptive: the cells with the largest "
                      "errors are refined, those with the smallest coarsened; "
                      "the errors are those that the analysis bounds, and for "
                      "'Analysis = contact', as for Kelly, estimated by the "
                      "jumps of the strain.");
    prm.add_parameter("Goal",
                      goal,
                      "For 'Analysis = contact with error bound' with the "
                      "strategy adaptive: whether cells are refined where they "
                      "add most to the bound of the error (energy), or to the "
                      "distance between the bounds of the force, if a depth is "
                      "given, or of the depth (force).");
    prm.add_parameter("Number of cycles",
                      n_cycles,
                      "The number of meshes on which the problem is solved, "
                      "one after the other; each solution is the starting "
                      "guess on the next. In a load history, the first step "
                      "is solved on all of them, the others on the last.",
                      Patterns::Integer(1));
    prm.add_parameter("Maximum number of unknowns",
                      max_unknowns,
                      "No further mesh is begun that would have more "
                      "displacement unknowns than this, as far as can be told "
                      "in advance (within some per cent). 0: no limit below "
                      "2000000000, which indices of 32 bits reach.",
                      Patterns::Integer(0));
    prm.add_parameter(
      "Refinement fraction",
      refinement_fraction,
      "adaptive, Kelly: the fraction of cells that are refined, between "
      "0 and 1; with them, those whose error is the same but for rounding, "
      "such as mirror images.",
      Patterns::Double(0, 1));
    prm.add_parameter(
      "Coarsening fraction",
      coarsening_fraction,
      "adaptive, Kelly: the fraction of cells that are coarsened; "
      "together with the refinement fraction at most 1.",
      Patterns::Double(0, 1));
    prm.add_parameter(
      "Passes",
      n_passes,
      "For 'Analysis = limit load' with the strategies adaptive and Kelly: in "
      "how many passes the cells are refined from one mesh to the next, in "
      "each of them an equal number, those that add most to the distance of "
      "the bounds. What a refined cell adds is predicted, so that it may be "
      "refined again. Three passes and a refinement fraction of 0.4 (in space "
      "0.2) take a half to two thirds of the time to the same bounds, with "
      "half as many cycles. From 1 to 10.",
      Patterns::Integer(1, 10));
    prm.add_parameter(
      "Steps between adaptations",
      adaptation_interval,
      "In a load history: after how many steps the mesh is adapted to the "
      "solution, with the fractions above; as many cells are refined as "
      "'Maximum number of unknowns' allows. Not for the strategies none and global. 0: "
      "the mesh of the first step stays.",
      Patterns::Integer(0));
    prm.add_parameter(
      "Elements over contact radius",
      n_over_contact_radius,
      "Cells are refined around what the indenter touches until so many "
      "elements fit into its radius (in the plane: half its width), and four "
      "times as many per length at its edge (in space twice); in a load "
      "history, the mesh follows the edge of the contact as it grows (with "
      "'Strain = logarithmic' from the end of the first step on, one level "
      "after each). Cells that this has made are put together "
      "again when the contact has grown so much that they are not needed, "
      "if the strategy is none. 0: the mesh does not depend on the "
      "contact. 10 to 40 are usual.",
      Patterns::Integer(0));
    prm.leave_subsection();
  }



  void
  RefinementParameters::check() const
  {
    if (strategy == RefinementStrategy::none && n_cycles > 1)
      throw InputError("Refinement/Number of cycles",
                       std::to_string(n_cycles),
                       "'Refinement/Strategy = none' allows one cycle only. "
                       "Choose the strategy global or adaptive.");
    if (goal == RefinementGoal::force &&
        strategy != RefinementStrategy::adaptive)
      throw InputError("Refinement/Goal",
                       goal,
                       "only 'Refinement/Strategy = adaptive' has a goal.");
    if (!is_adaptive() && adaptation_interval > 0)
      throw InputError(
        "Refinement/Steps between adaptations",
        std::to_string(adaptation_interval),
        "only 'Refinement/Strategy = adaptive' can adapt the mesh "
        "during a history. Choose it, or 0.");
    if (refinement_fraction + coarsening_fraction > 1)
      throw InputError("Refinement/Coarsening fraction",
                       coarsening_fraction,
                       "together with 'Refinement/Refinement fraction' it must "
                       "not exceed 1.");
  }



  void
  RefinementParameters::check_first_mesh(const double n_unknowns) const
  {
    if (allows(n_unknowns))
      return;
    std::ostringstream number;
    number << std::fixed << std::setprecision(0) << n_unknowns;
    if (n_unknowns > n_indices)
      throw InputError("The first mesh has " + number.str() +
                       " unknowns or more, but indices of 32 bits reach to "
                       "2000000000 only. Start with a coarser mesh: reduce "
                       "'Geometry/Initial refinements'.");
    throw InputError("Refinement/Maximum number of unknowns",
                     std::to_string(max_unknowns),
                     "the first mesh has " + number.str() +
                       " unknowns or more already. Allow more, or start with a "
                       "coarser mesh.");
  }
} // namespace ElastoPlastic
