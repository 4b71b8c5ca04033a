// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/ghost_values.h"
#include "contact/contact_edge.h"

namespace ElastoPlastic
{
  // The level of a touching node is as far below zero as the mean of the open
  // ones is below one: on a face of two nodes, the part 1 - level is touched.
  template <int dim>
  typename ContactEdge<dim>::TouchedPart
  ContactEdge<dim>::touched_part(const Vector &kinds,
                                 const Vector &levels) const
  {
    const GhostValues ghosts_of_kinds(kinds), ghosts_of_levels(levels);
    TouchedPart       result;
    Vector           &missing = result.missing;
    missing.reinit(vector_layout);
    std::vector<SharedRows::Weights::Entry> entries;
    for (const Face &face : faces)
      {
        unsigned int n_open = 0, n_touching = 0;
        double       sum = 0;
        for (const auto dof : face.dofs)
          {
            n_open += (kinds(dof) == open);
            n_touching += (kinds(dof) == touching);
            sum += (kinds(dof) == open ? levels(dof) : 0.);
          }
        if (n_open == 0 || n_touching == 0 || n_open + n_touching < n_nodes)
          continue;

        std::array<double, n_nodes> level;
        for (unsigned int n = 0; n < n_nodes; ++n)
          level[n] = kinds(face.dofs[n]) == open ? levels(face.dofs[n]) :
                                                   sum / n_open - 1.;
        const auto touched = integrate(face, level);
        double     own     = 0;
        for (unsigned int n = 0; n < n_nodes; ++n)
          if (kinds(face.dofs[n]) == touching)
            {
              missing(face.dofs[n]) += face.areas[n] - touched[n];
              own += touched[n];
            }
        if (own > 0.)
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int m = 0; m < n_nodes; ++m)
              if (kinds(face.dofs[n]) == touching &&
                  kinds(face.dofs[m]) == open)
                entries.push_back(
                  {face.dofs[n], face.dofs[m], touched[m] * touched[n] / own});
      }
    missing.compress(VectorOperation::add);
    result.taken_over =
      std::make_shared<SharedRows::Weights>(entries, vector_layout);
    return result;
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::neighbors(const Vector &kinds) const
  {
    const GhostValues ghosts_of_kinds(kinds);
    Vector            marks(vector_layout);
    for (const Face &face : faces)
      if (std::any_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kinds(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          if (kinds(dof) == open)
            marks(dof) = 1.;
    marks.compress(VectorOperation::max);
    return marks;
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::inside(const Vector &kinds) const
  {
    const GhostValues ghosts_of_kinds(kinds);
    Vector            marks(vector_layout);
    for (const Face &face : faces)
      if (std::all_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kinds(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          marks(dof) = 1.;
    marks.compress(VectorOperation::max);
    return marks;
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::growth_beyond(const Vector &kinds,
                                  const Vector &neighbors,
                                  const Vector &values) const
  {
    const GhostValues ghosts_of_kinds(kinds), ghosts_of_neighbors(neighbors),
      ghosts_of_values(values);
    Vector growth(vector_layout);
    for (const Face &face : faces)
      for (const auto near : face.dofs)
        if (neighbors(near) == 1.)
          for (const auto far : face.dofs)
            if (kinds(far) == open && neighbors(far) == 0.)
              for (const auto dof : {near, far})
                growth(dof) =
                  std::max<double>(growth(dof), values(far) - values(near));
    growth.compress(VectorOperation::max);
    return growth;
  }



  template class ContactEdge<2>;
  template class ContactEdge<3>;
} // namespace ElastoPlastic
