// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <utility>

#include "contact/contact_nodes.h"
#include "output/boundary_patches.h"

namespace ElastoPlastic
{
  template <int dim>
  Patches<dim - 1, dim>
  boundary_patches(const DoFHandler<dim>              &dof_handler,
                   const std::set<types::boundary_id> &boundaries,
                   const std::vector<NodalField>      &fields)
  {
    const FiniteElement<dim> &fe    = dof_handler.get_fe();
    const auto                nodes = lattice_of_face(fe);
    std::vector<typename Patches<dim - 1, dim>::Field> names;
    for (const NodalField &field : fields)
      names.push_back({field.name, field.n_components});

    Patches<dim - 1, dim>                result(names);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && boundaries.count(face->boundary_id()) > 0)
            {
              typename Patches<dim - 1, dim>::Patch patch;
              for (const unsigned int v : face->vertex_indices())
                patch.vertices[v] = face->vertex(v);
              patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
              patch.n_subdivisions = fe.degree;
              patch.data.reinit(result.n_components(), nodes.size());
              face->get_dof_indices(dofs);
              unsigned int row = 0;
              for (const auto &[name, n_components, values] : fields)
                for (unsigned int c = dim - n_components; c < dim; ++c, ++row)
                  for (unsigned int i = 0; i < nodes.size(); ++i)
                    patch.data(row, i) = values(dofs[nodes[i][c]]);
              result.add(std::move(patch));
            }
    return result;
  }



  template Patches<1, 2>
  boundary_patches(const DoFHandler<2> &,
                   const std::set<types::boundary_id> &,
                   const std::vector<NodalField> &);
  template Patches<2, 3>
  boundary_patches(const DoFHandler<3> &,
                   const std::set<types::boundary_id> &,
                   const std::vector<NodalField> &);
} // namespace ElastoPlastic
