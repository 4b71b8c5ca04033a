// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mesh/body_size.h"
#include "model/model.h"

namespace ElastoPlastic
{
  template <int dim>
  GapFunction<dim>
  make_mesh_and_place_indenter(
    const Model<dim>                          &model,
    parallel::distributed::Triangulation<dim> &triangulation)
  {
    model.geometry.make_mesh(triangulation);
    return GapFunction<dim>(model.indenter,
                            highest_point(triangulation,
                                          model.boundary_conditions.ids(
                                            BoundaryConditionType::contact)));
  }



  template GapFunction<2>
  make_mesh_and_place_indenter(const Model<2> &,
                               parallel::distributed::Triangulation<2> &);
  template GapFunction<3>
  make_mesh_and_place_indenter(const Model<3> &,
                               parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
