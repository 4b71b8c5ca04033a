// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_mesh_h
#define tests_sample_mesh_h

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

#include "refine_where.h"

// Meshes to test with, and fields on them.

/// Divides the cells in the corner with the greatest coordinates once more:
/// hanging nodes.
template <int dim>
void
refine_corner(dealii::parallel::distributed::Triangulation<dim> &mesh)
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        bool in_corner = true;
        for (unsigned int d = 0; d < dim; ++d)
          in_corner = in_corner && cell->center()[d] > 0.5;
        if (in_corner)
          cell->set_refine_flag();
      }
  mesh.execute_coarsening_and_refinement();
}



/// The unit square or cube in cells as high as itself: a mesh that is fine
/// along the surface only.
template <int dim>
void
make_columns(dealii::parallel::distributed::Triangulation<dim> &mesh,
             const unsigned int                                 n_per_side)
{
  dealii::Point<dim>        upper;
  std::vector<unsigned int> n_cells(dim, n_per_side);
  n_cells[dim - 1] = 1;
  for (unsigned int d = 0; d < dim; ++d)
    upper[d] = 1.;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    mesh, n_cells, dealii::Point<dim>(), upper, /* colorize = */ true);
}



/// A square below y = 0, divided once more where an indenter on its left end
/// would touch it.
inline void
make_half_space_mesh(dealii::parallel::distributed::Triangulation<2> &mesh)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh,
                                                    {4, 4},
                                                    dealii::Point<2>(0, -1),
                                                    dealii::Point<2>(1, 0),
                                                    /* colorize = */ true);
  refine_where(mesh, [&](const auto &cell) {
    return cell->center()[0] < 0.5 && cell->center()[1] > -0.25;
  });
}



/// The unit square or cube of 2^dim cells, of which none is a parallelogram
/// and one has been divided; material 1 on the right.
template <int dim>
void
make_distorted_mesh(dealii::parallel::distributed::Triangulation<dim> &mesh)
{
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] > 0.5 ? 1 : 0);
  dealii::GridTools::transform(
    [](dealii::Point<dim> point) {
      for (unsigned int d = 0; d < dim; ++d)
        point[d] += 0.06 * std::sin(2. + 5. * point[(d + 1) % dim] + d);
      return point;
    },
    mesh);
  refine_corner(mesh);
}



/// A smooth vector field with components up to @p size, another one for each
/// @p number.
template <int dim>
class SampleField : public dealii::Function<dim>
{
public:
  SampleField(const unsigned int number, const double size)
    : dealii::Function<dim>(dim)
    , number(number)
    , size(size)
  {}

  double
  value(const dealii::Point<dim> &point,
        const unsigned int        component) const override
  {
    double argument = 1. + 2.3 * number + 1.7 * component;
    for (unsigned int d = 0; d < dim; ++d)
      argument += (1. + ((number + component + d) % 3)) * point[d];
    return size * std::sin(argument);
  }

private:
  const unsigned int number;
  const double       size;
};

#endif
