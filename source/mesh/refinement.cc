// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/grid/grid_tools.h>

#include <iomanip>
#include <sstream>

#include "base/exceptions.h"
#include "mesh/refinement.h"

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
      "0 and 1.",
      Patterns::Double(0, 1));
    prm.add_parameter(
      "Coarsening fraction",
      coarsening_fraction,
      "adaptive, Kelly: the fraction of cells that are coarsened; "
      "together with the refinement fraction at most 1.",
      Patterns::Double(0, 1));
    prm.add_parameter(
      "Steps between adaptations",
      adaptation_interval,
      "In a load history: after how many steps the mesh is adapted to the "
      "solution, with the fractions above; as many cells are refined as "
      "'Maximum number of unknowns' allows. Not for the strategies none and global. 0: "
      "the mesh of the first step stays.",
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
    if (!is_adaptive() && adaptation_interval > 0)
      throw InputError(
        "Refinement/Steps between adaptations",
        std::to_string(adaptation_interval),
        "only 'Refinement/Strategy = adaptive' can adapt the mesh "
        "during a history. Choose it, or 0.");
    if (refinement_fraction + coarsening_fraction > 1)
      throw InputError("Refinement/Coarsening fraction",
                       Patterns::Tools::to_string(coarsening_fraction),
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



  namespace
  {
    /// What is to happen to a cell.
    template <typename Cell>
    int
    flag_of(const Cell &cell)
    {
      return cell->refine_flag_set() ? 1 : cell->coarsen_flag_set() ? -1 : 0;
    }



    /// Tells the neighbouring ranks about the flags.
    template <int dim>
    void
    share_flags(parallel::distributed::Triangulation<dim> &triangulation)
    {
      using Cell = typename Triangulation<dim>::active_cell_iterator;
      GridTools::exchange_cell_data_to_ghosts<int>(
        triangulation,
        [](const Cell &cell) { return flag_of(cell); },
        [](const Cell &cell, const int flag) {
          cell->clear_refine_flag();
          cell->clear_coarsen_flag();
          if (flag == 1)
            cell->set_refine_flag();
          if (flag == -1)
            cell->set_coarsen_flag();
        });
    }



    /// Keeps cells from being put together where a finer one touches them, even
    /// if that is to go, too: what the others want is known for the nearest
    /// cells of other ranks only.
    template <int dim>
    void
    keep_beside_finer_cells(Triangulation<dim> &triangulation)
    {
      std::vector<int> finest_level(triangulation.n_vertices(), 0);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            {
              int &level = finest_level[cell->vertex_index(v)];
              level =
                std::max(level, cell->level() + (flag_of(cell) == 1 ? 1 : 0));
            }
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            if (finest_level[cell->vertex_index(v)] > cell->level())
              cell->clear_coarsen_flag();
    }



    /// Adds and removes flags so that neighbours differ by one level at most,
    /// in the same way on any number of ranks. (Flags for refinement are only
    /// added and those for coarsening only removed, so this ends.)
    template <int dim>
    void
    smooth_flags(parallel::distributed::Triangulation<dim> &triangulation)
    {
      const auto own_flags = [&triangulation]() {
        std::vector<int> flags;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            flags.push_back(flag_of(cell));
        return flags;
      };
      std::vector<int> flags, next_flags = own_flags();
      do
        {
          flags.swap(next_flags);
          share_flags(triangulation);
          keep_beside_finer_cells(triangulation);
          triangulation.prepare_coarsening_and_refinement();
          next_flags = own_flags();
      } while (Utilities::MPI::logical_or(next_flags != flags,
                                          triangulation.get_communicator()));
    }



    template <int dim>
    void
    clear_flags(parallel::distributed::Triangulation<dim> &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          cell->clear_refine_flag();
          cell->clear_coarsen_flag();
        }
    }



    /// Earlier flags are forgotten: what is asked for does not depend on meshes
    /// that have been marked, but not made.
    template <int dim>
    void
    set_flags(const RefinementParameters                &parameters,
              const Vector<float>                       &error_indicators,
              parallel::distributed::Triangulation<dim> &triangulation)
    {
      clear_flags(triangulation);
      if (parameters.strategy == RefinementStrategy::global)
        triangulation.set_all_refine_flags();
      else
        parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
          triangulation,
          error_indicators,
          parameters.refinement_fraction,
          parameters.coarsening_fraction);
    }
  } // namespace



  template <int dim>
  void
  flag_cells(const RefinementParameters                &parameters,
             const Vector<float>                       &error_indicators,
             parallel::distributed::Triangulation<dim> &triangulation)
  {
    set_flags(parameters, error_indicators, triangulation);
    triangulation.prepare_coarsening_and_refinement();
  }



  template <int dim>
  bool
  flag_cells_within(const double         unknowns_per_cell,
                    RefinementParameters parameters,
                    const Vector<float> &error_indicators,
                    parallel::distributed::Triangulation<dim> &triangulation)
  {
    const double one_cell = 1. / triangulation.n_global_active_cells();
    for (; parameters.refinement_fraction >= one_cell;
         parameters.refinement_fraction *= 0.5)
      {
        set_flags(parameters, error_indicators, triangulation);
        smooth_flags(triangulation);
        if (parameters.allows(unknowns_per_cell *
                              n_cells_after_refinement(triangulation)))
          return true;
      }
    return false;
  }



  template <int dim>
  double
  estimated_unknowns(const double n_cells, const FiniteElement<dim> &fe)
  {
    return fe.n_components() * std::pow(fe.degree, dim) * n_cells;
  }



  template <int dim>
  std::uint64_t
  n_cells_after_refinement(
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    constexpr std::uint64_t n_children =
      GeometryInfo<dim>::max_children_per_cell;
    std::uint64_t n_refined = 0, n_coarsened = 0;
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
  template bool
  flag_cells_within(const double,
                    RefinementParameters,
                    const Vector<float> &,
                    parallel::distributed::Triangulation<2> &);
  template std::uint64_t
  n_cells_after_refinement(const parallel::distributed::Triangulation<2> &);
  template double
  estimated_unknowns(const double, const FiniteElement<2> &);
  template void
  flag_cells(const RefinementParameters &,
             const Vector<float> &,
             parallel::distributed::Triangulation<3> &);
  template bool
  flag_cells_within(const double,
                    RefinementParameters,
                    const Vector<float> &,
                    parallel::distributed::Triangulation<3> &);
  template std::uint64_t
  n_cells_after_refinement(const parallel::distributed::Triangulation<3> &);
  template double
  estimated_unknowns(const double, const FiniteElement<3> &);
} // namespace ElastoPlastic
