// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/grid_refinement.h>

#include "base/exceptions.h"
#include "mesh/refinement.h"

namespace ElastoPlastic
{
  void
  RefinementParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Refinement");
    prm.add_parameter("Strategy",
                      strategy,
                      "none: one mesh. global: every cell is refined from one "
                      "cycle to the next. Kelly: the cells with the largest "
                      "jumps of the strain are refined, those with the "
                      "smallest coarsened.",
                      Patterns::Selection("none|global|Kelly"));
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
                      "in advance (within some per cent). 0: no limit.",
                      Patterns::Integer(0));
    prm.add_parameter("Refinement fraction",
                      refinement_fraction,
                      "Kelly: the fraction of cells that are refined, between "
                      "0 and 1.",
                      Patterns::Double(0, 1));
    prm.add_parameter("Coarsening fraction",
                      coarsening_fraction,
                      "Kelly: the fraction of cells that are coarsened; "
                      "together with the refinement fraction at most 1.",
                      Patterns::Double(0, 1));
    prm.leave_subsection();
  }



  void
  RefinementParameters::check() const
  {
    if (strategy == "none" && n_cycles > 1)
      throw InputError("Refinement/Number of cycles",
                       std::to_string(n_cycles),
                       "'Refinement/Strategy = none' allows one cycle only. "
                       "Choose the strategy global or Kelly.");
    if (refinement_fraction + coarsening_fraction > 1)
      throw InputError("Refinement/Coarsening fraction",
                       Patterns::Tools::to_string(coarsening_fraction),
                       "together with 'Refinement/Refinement fraction' it must "
                       "not exceed 1.");
  }



  template <int dim>
  void
  flag_cells(const RefinementParameters                &parameters,
             const Vector<float>                       &error_indicators,
             parallel::distributed::Triangulation<dim> &triangulation)
  {
    if (parameters.strategy == "global")
      triangulation.set_all_refine_flags();
    else
      parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        triangulation,
        error_indicators,
        parameters.refinement_fraction,
        parameters.coarsening_fraction);
    triangulation.prepare_coarsening_and_refinement();
  }



  template <int dim>
  types::global_cell_index
  n_cells_after_refinement(
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    constexpr unsigned int n_children =
      GeometryInfo<dim>::max_children_per_cell;
    types::global_cell_index n_refined = 0, n_coarsened = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          n_refined += cell->refine_flag_set() ? 1 : 0;
          n_coarsened += cell->coarsen_flag_set() ? 1 : 0;
        }
    const MPI_Comm communicator = triangulation.get_communicator();
    return triangulation.n_global_active_cells() +
           (n_children - 1) * Utilities::MPI::sum(n_refined, communicator) -
           (n_children - 1) * Utilities::MPI::sum(n_coarsened, communicator) /
             n_children;
  }



  template void
  flag_cells(const RefinementParameters &,
             const Vector<float> &,
             parallel::distributed::Triangulation<2> &);
  template types::global_cell_index
  n_cells_after_refinement(const parallel::distributed::Triangulation<2> &);
  template void
  flag_cells(const RefinementParameters &,
             const Vector<float> &,
             parallel::distributed::Triangulation<3> &);
  template types::global_cell_index
  n_cells_after_refinement(const parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
