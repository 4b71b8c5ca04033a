// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria_base.h>

#include <cmath>
#include <memory>
#include <sstream>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/expression.h"
#include "mesh/material_ids.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    types::material_id
    material_id(const std::string     &path,
                const std::string     &text,
                const Expression<dim> &expression,
                const Point<dim>      &centre)
    {
      const double rounded = std::round(expression.value(centre));
      if (rounded < 0 || rounded >= numbers::invalid_material_id)
        {
          std::ostringstream remedy;
          remedy << "at the centre (" << centre << ") of a cell its value "
                 << rounded << " is no number of a material. It must be "
                 << "0 for the first material, 1 for the second, and so on.";
          throw InputError(path, text, remedy.str());
        }
      return static_cast<types::material_id>(rounded);
    }
  } // namespace



  // A distributed mesh reaches its next state in steps, not as many on each
  // rank, and tells when it is there.
  template <int dim>
  void
  set_material_ids(const std::string  &path,
                   const std::string  &text,
                   Triangulation<dim> &triangulation)
  {
    const auto expression =
      std::make_shared<Expression<dim>>(path,
                                        text,
                                        ExpressionVariables::position);
    const auto update = [path, text, expression, &triangulation]() {
      rethrow_collectively(communicator_of(triangulation), [&]() {
        for (const auto &cell : triangulation.cell_iterators())
          cell->set_material_id(
            material_id(path, text, *expression, cell->center()));
      });
    };
    update();

    auto &signals = triangulation.signals;
    if (dynamic_cast<parallel::DistributedTriangulationBase<dim> *>(
          &triangulation) == nullptr)
      signals.post_refinement.connect(update);
    else
      for (auto *const signal : {&signals.post_distributed_refinement,
                                 &signals.post_distributed_repartition,
                                 &signals.post_distributed_load})
        signal->connect(update);
  }



  template <int dim>
  std::string
  warning_of_unused_materials(const Triangulation<dim> &triangulation,
                              const unsigned int        n_materials)
  {
    if (n_materials == 1)
      return "";
    std::vector<unsigned int> n_cells(n_materials, 0);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() < n_materials)
        ++n_cells[cell->material_id()];
    Utilities::MPI::sum(n_cells, communicator_of(triangulation), n_cells);

    std::string unused;
    for (unsigned int id = 0; id < n_materials; ++id)
      if (n_cells[id] == 0)
        unused += (unused.empty() ? "" : ", ") + std::to_string(id);
    return unused.empty() ?
             "" :
             "No cell of the mesh consists of the material " + unused +
               ", though the entries of 'Material' describe " +
               std::to_string(n_materials) + " materials: 0 to " +
               std::to_string(n_materials - 1) +
               ". A cell is of the material that 'Geometry/Material id' gives "
               "at its centre: is the mesh too coarse for a thin layer?";
  }



  template <int dim>
  void
  check_material_ids(const Triangulation<dim> &triangulation,
                     const unsigned int        n_materials)
  {
    if (n_materials == 1)
      return;
    rethrow_collectively(communicator_of(triangulation), [&]() {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          check_material_id(*cell, n_materials);
    });
  }



  template void
  set_material_ids(const std::string &,
                   const std::string &,
                   Triangulation<2> &);
  template void
  set_material_ids(const std::string &,
                   const std::string &,
                   Triangulation<3> &);
  template std::string
  warning_of_unused_materials(const Triangulation<2> &, const unsigned int);
  template std::string
  warning_of_unused_materials(const Triangulation<3> &, const unsigned int);
  template void
  check_material_ids(const Triangulation<2> &, const unsigned int);
  template void
  check_material_ids(const Triangulation<3> &, const unsigned int);
} // namespace ElastoPlastic
