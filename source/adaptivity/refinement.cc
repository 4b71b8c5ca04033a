// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

#include "adaptivity/refinement.h"
#include "adaptivity/ties.h"
#include "base/compatibility.h"

namespace ElastoPlastic
{
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
                                          communicator_of(triangulation)));
    }



    /// The edge of a cube with the same diagonal.
    template <typename Cell>
    double
    size_of(const Cell &cell)
    {
      return cell->diameter() / std::sqrt(Cell::AccessorType::dimension);
    }



    template <int dim>
    double
    allowed_size(const CellSizes<dim>                                    &sizes,
                 const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      return sizes(cell->center(), 0.5 * cell->diameter());
    }



    /// The fraction of cells to refine. deal.II rounds their number down, but a
    /// mesh of few cells is to become finer, too.
    template <int dim>
    double
    refined_part(const RefinementParameters                      &parameters,
                 const parallel::distributed::Triangulation<dim> &triangulation)
    {
      const double one_cell =
        std::min(1.5 / triangulation.n_global_active_cells(), 1.);
      return parameters.refinement_fraction > 0. ?
               std::max(parameters.refinement_fraction, one_cell) :
               0.;
    }



    /// Earlier flags are forgotten: what is asked for does not depend on meshes
    /// that have been marked, but not made.
    template <int dim>
    void
    set_flags(const RefinementParameters                &parameters,
              const Vector<float>                       &error_indicators,
              const double                               accuracy,
              parallel::distributed::Triangulation<dim> &triangulation)
    {
      clear_flags(triangulation);
      if (parameters.strategy == RefinementStrategy::global)
        triangulation.set_all_refine_flags();
      else
        {
          const double refined = refined_part(parameters, triangulation);
          parallel::distributed::GridRefinement::
            refine_and_coarsen_fixed_number(
              triangulation,
              error_indicators,
              refined,
              refined > parameters.refinement_fraction ?
                std::min(parameters.coarsening_fraction, 1. - refined) :
                parameters.coarsening_fraction);
          flag_ties(static_cast<std::uint64_t>(
                      refined * triangulation.n_global_active_cells()),
                    error_indicators,
                    accuracy,
                    triangulation);
        }
    }
  } // namespace



  template <int dim>
  void
  clear_flags(Triangulation<dim> &triangulation)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
  }



  template <int dim>
  bool
  has_larger_cells(
    const CellSizes<dim>                            &sizes,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    bool found = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        found = found || size_of(cell) > allowed_size<dim>(sizes, cell);
    return Utilities::MPI::logical_or(found, communicator_of(triangulation));
  }



  // Cells are put together well before that is too much, or the next step would
  // divide them again.
  template <int dim>
  bool
  flag_larger_cells(const CellSizes<dim>                      &sizes,
                    const std::optional<int>                   coarsest_level,
                    parallel::distributed::Triangulation<dim> &triangulation)
  {
    bool any_refined = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const double allowed = allowed_size<dim>(sizes, cell);
          if (size_of(cell) > allowed)
            {
              cell->clear_coarsen_flag();
              cell->set_refine_flag();
            }
          else if (2. * size_of(cell) > 0.7 * allowed)
            cell->clear_coarsen_flag();
          else if (coarsest_level && cell->level() > *coarsest_level &&
                   !cell->refine_flag_set())
            cell->set_coarsen_flag();
          any_refined = any_refined || cell->refine_flag_set();
        }
    smooth_flags(triangulation);
    return Utilities::MPI::logical_or(any_refined,
                                      communicator_of(triangulation));
  }



  template <int dim>
  void
  flag_cells(const RefinementParameters                &parameters,
             const Vector<float>                       &error_indicators,
             const double                               accuracy,
             parallel::distributed::Triangulation<dim> &triangulation)
  {
    set_flags(parameters, error_indicators, accuracy, triangulation);
    triangulation.prepare_coarsening_and_refinement();
  }



  template <int dim>
  bool
  flag_cells_within(const double         unknowns_per_cell,
                    RefinementParameters parameters,
                    const Vector<float> &error_indicators,
                    const double         accuracy,
                    parallel::distributed::Triangulation<dim> &triangulation)
  {
    const double one_cell = 1. / triangulation.n_global_active_cells();
    for (; parameters.refinement_fraction >= one_cell;
         parameters.refinement_fraction *= 0.5)
      {
        set_flags(parameters, error_indicators, accuracy, triangulation);
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
    const MPI_Comm communicator = communicator_of(triangulation);
    return triangulation.n_global_active_cells() +
           (n_children - 1) * Utilities::MPI::sum(n_refined, communicator) -
           (n_children - 1) * Utilities::MPI::sum(n_coarsened, communicator) /
             n_children;
  }



  template void
  clear_flags(Triangulation<2> &);
  template bool
  has_larger_cells(const CellSizes<2> &,
                   const parallel::distributed::Triangulation<2> &);
  template bool
  flag_larger_cells(const CellSizes<2> &,
                    const std::optional<int>,
                    parallel::distributed::Triangulation<2> &);
  template void
  flag_cells(const RefinementParameters &,
             const Vector<float> &,
             const double,
             parallel::distributed::Triangulation<2> &);
  template bool
  flag_cells_within(const double,
                    RefinementParameters,
                    const Vector<float> &,
                    const double,
                    parallel::distributed::Triangulation<2> &);
  template std::uint64_t
  n_cells_after_refinement(const parallel::distributed::Triangulation<2> &);
  template double
  estimated_unknowns(const double, const FiniteElement<2> &);
  template void
  clear_flags(Triangulation<3> &);
  template bool
  has_larger_cells(const CellSizes<3> &,
                   const parallel::distributed::Triangulation<3> &);
  template bool
  flag_larger_cells(const CellSizes<3> &,
                    const std::optional<int>,
                    parallel::distributed::Triangulation<3> &);
  template void
  flag_cells(const RefinementParameters &,
             const Vector<float> &,
             const double,
             parallel::distributed::Triangulation<3> &);
  template bool
  flag_cells_within(const double,
                    RefinementParameters,
                    const Vector<float> &,
                    const double,
                    parallel::distributed::Triangulation<3> &);
  template std::uint64_t
  n_cells_after_refinement(const parallel::distributed::Triangulation<3> &);
  template double
  estimated_unknowns(const double, const FiniteElement<3> &);
} // namespace ElastoPlastic
