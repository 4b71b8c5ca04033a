// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef adaptivity_refinement_h
#define adaptivity_refinement_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/vector.h>

#include <cstdint>
#include <functional>
#include <optional>

#include "base/enum_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Which cells are refined from one mesh to the next; see the entry
  /// "Strategy".
  enum class RefinementStrategy
  {
    none,
    global,
    adaptive,
    kelly
  };

  template <>
  inline const EnumNames<RefinementStrategy> enum_names<RefinementStrategy> = {
    {"none", RefinementStrategy::none},
    {"global", RefinementStrategy::global},
    {"adaptive", RefinementStrategy::adaptive},
    {"Kelly", RefinementStrategy::kelly}};



  /// The bound that refinement shall make small, if there is one; see the entry
  /// "Goal".
  enum class RefinementGoal
  {
    energy,
    force
  };

  template <>
  inline const EnumNames<RefinementGoal> enum_names<RefinementGoal> = {
    {"energy", RefinementGoal::energy}, {"force", RefinementGoal::force}};



  /// The entries of the section "Refinement".
  struct RefinementParameters
  {
    RefinementStrategy strategy            = RefinementStrategy::adaptive;
    RefinementGoal     goal                = RefinementGoal::energy;
    unsigned int       n_cycles            = 1;
    unsigned int       max_unknowns        = 0;
    double             refinement_fraction = 0.3;
    double             coarsening_fraction = 0.03;
    /// Of a limit load: in how many passes cells are refined before the next
    /// bounds.
    unsigned int n_passes = 1;
    /// In a history: load steps from one mesh to the next; 0: one mesh.
    unsigned int adaptation_interval = 0;
    /// Elements over the radius of a contact spot; 0: as many as there are.
    unsigned int n_over_contact_radius = 0;

    /// Whether a mesh depends on the errors of the one before.
    bool
    is_adaptive() const
    {
      return strategy == RefinementStrategy::adaptive ||
             strategy == RefinementStrategy::kelly;
    }

    /// Whether a mesh may have so many unknowns: as far as the user allows, and
    /// as the indices of deal.II and Trilinos reach, which have 32 bits.
    bool
    allows(const double n_unknowns) const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError
    void
    check() const;

    /// @throws InputError if @p n_unknowns are too many for the first mesh.
    void
    check_first_mesh(const double n_unknowns) const;
  };



  /// Flags the cells for the next mesh. @p error_indicators holds one value per
  /// active cell of this rank, with this relative @p accuracy: cells that they
  /// do not tell apart are refined together, see flag_ties(). Collective.
  template <int dim>
  void
  flag_cells(const RefinementParameters                &parameters,
             const Vector<float>                       &error_indicators,
             const double                               accuracy,
             parallel::distributed::Triangulation<dim> &triangulation);



  /// The same for a mesh that is to follow its load over many steps: halves the
  /// refinement fraction until the next mesh, with @p unknowns_per_cell, has as
  /// many unknowns as are allowed, all ranks together. @return whether any cell
  /// is to be refined.
  template <int dim>
  bool
  flag_cells_within(const double         unknowns_per_cell,
                    RefinementParameters parameters,
                    const Vector<float> &error_indicators,
                    const double         accuracy,
                    parallel::distributed::Triangulation<dim> &triangulation);



  /// How large the cells may be within some reach of a point.
  template <int dim>
  using CellSizes =
    std::function<double(const Point<dim> &x, const double reach)>;



  /// @return whether a cell on any rank is larger than @p sizes allow.
  template <int dim>
  bool
  has_larger_cells(
    const CellSizes<dim>                            &sizes,
    const parallel::distributed::Triangulation<dim> &triangulation);



  /// Adds flags for refinement to cells that are larger than @p sizes allow,
  /// and takes away those for coarsening from cells that would become too
  /// large; if @p coarsest_level is given, flags cells above that level for
  /// coarsening that are much smaller. Collective. @return whether any cell is
  /// to be refined.
  template <int dim>
  bool
  flag_larger_cells(const CellSizes<dim>                      &sizes,
                    const std::optional<int>                   coarsest_level,
                    parallel::distributed::Triangulation<dim> &triangulation);



  /// Forgets all flags.
  template <int dim>
  void
  clear_flags(Triangulation<dim> &triangulation);



  /// How many unknowns @p n_cells have in the interior of a mesh of elements
  /// @p fe.
  template <int dim>
  double
  estimated_unknowns(const double n_cells, const FiniteElement<dim> &fe);



  /// The number of cells that the mesh will have, all ranks together, when the
  /// flags have been obeyed.
  template <int dim>
  std::uint64_t
  n_cells_after_refinement(
    const parallel::distributed::Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
