// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "base/text.h"
#include "bounds/body/loads.h"
#include "bounds/limit_load_analysis.h"
#include "mesh/curved_boundaries.h"

// Whether a body bears a load that is asked of it.

namespace ElastoPlastic
{
  namespace
  {
    /// With more, a force that is neither safe nor unsafe is too close to the
    /// limit load: the bounds are within 1 % then.
    constexpr types::global_cell_index max_cells_to_decide = 1000;
  } // namespace



  template <int dim>
  void
  LimitLoadAnalysis<dim>::let_grow(const LoadInQuestion &load)
  {
    if (has_curved_boundary(triangulation))
      throw ConvergenceError(
        "The body is curved: on a coarse mesh, it is "
        "another one.");
    if (load.times.empty())
      return;
    loads = [this, times = load.times](const auto &mesh) {
      return Loads<dim>(std::nullopt,
                        Loads<dim>::time_of_largest(mesh,
                                                    model.boundary_conditions,
                                                    model.body_force,
                                                    times),
                        model.body_force);
    };
  }



  template <int dim>
  void
  LimitLoadAnalysis<dim>::require_safe(const LoadInQuestion &load)
  {
    bool is_known = is_safe_at_first_sight(load);
    while (!is_known)
      {
        if (n_cells() > max_cells_to_decide)
          throw EquilibriumError("There may be no equilibrium under " +
                                 load.in_words() +
                                 ", which is too close to the limit load of "
                                 "the body to tell: that is " +
                                 bounds_in_words(load));
        refine_mesh();
        find_bounds();
        is_known = is_safe(load);
      }
  }



  template <int dim>
  bool
  LimitLoadAnalysis<dim>::is_safe_at_first_sight(const LoadInQuestion &load)
  {
    let_grow(load);
    setup_body();
    find_bounds();
    return is_safe(load);
  }



  template <int dim>
  bool
  LimitLoadAnalysis<dim>::is_safe(const LoadInQuestion &load) const
  {
    const double value = load.times.empty() ? load.force : 1.;
    if (value >= row.upper_bound)
      throw EquilibriumError(
        "There is no equilibrium under " + load.in_words() +
        ": the limit load of the body is " + bounds_in_words(load));
    return value < row.lower_bound;
  }



  template <int dim>
  std::string
  LimitLoadAnalysis<dim>::bounds_in_words(const LoadInQuestion &load) const
  {
    return "between " + to_text(row.lower_bound) + " and " +
           to_text(row.upper_bound) +
           (load.times.empty() ?
              ". Prescribe a force below the first of these bounds, or the "
              "depth." :
              " times that. Prescribe smaller loads ('Boundary "
              "conditions/Traction', 'Body force').");
  }
} // namespace ElastoPlastic
