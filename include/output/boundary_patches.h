// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_boundary_patches_h
#define output_boundary_patches_h

#include <deal.II/dofs/dof_handler.h>

#include <set>
#include <string>
#include <vector>

#include "output/patches.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// A field in the layout of displacements, with ghost values: all of its
  /// components, or only the vertical one, the last.
  struct NodalField
  {
    std::string       name;
    unsigned int      n_components; ///< dim or 1
    const VectorType &values;
  };



  /// The faces of @p boundaries at cells of this rank, with the values that
  /// @p fields have at their nodes.
  template <int dim>
  Patches<dim - 1, dim>
  boundary_patches(const DoFHandler<dim>              &dof_handler,
                   const std::set<types::boundary_id> &boundaries,
                   const std::vector<NodalField>      &fields);
} // namespace ElastoPlastic

#endif
