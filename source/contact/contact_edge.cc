// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "contact/contact_edge.h"

namespace ElastoPlastic
{
  namespace
  {
    /// For each node, with the @p owned partition, the largest of the @p values
    /// that its owner and other ranks have set, not negative.
    template <typename Vector, typename Partitioner>
    Vector
    largest_of_all_ranks(Vector &values, const Partitioner &owned)
    {
      values.compress(VectorOperation::max);
      Vector result(owned);
      result.copy_locally_owned_data_from(values);
      return result;
    }
  } // namespace



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::ghosted(const Vector &vector) const
  {
    Vector copy(ghosted_vectors);
    copy.copy_locally_owned_data_from(vector);
    copy.update_ghost_values();
    return copy;
  }



  // The level of a touching node is as far below zero as the mean of the open
  // ones is below one: on a face of two nodes, the part 1 - level is touched.
  template <int dim>
  typename ContactEdge<dim>::TouchedPart
  ContactEdge<dim>::touched_part(const Vector &kinds,
                                 const Vector &levels) const
  {
    const Vector kind_of = ghosted(kinds), level_of = ghosted(levels);
    Vector       missing(ghosted_vectors);
    std::array<double, n_nodes> below;
    below.fill(-1.);
    std::vector<SharedRows::Weights::Entry> entries;
    for (const Face &face : faces)
      {
        unsigned int n_open = 0, n_touching = 0;
        double       sum = 0;
        for (const auto dof : face.dofs)
          {
            n_open += (kind_of(dof) == open);
            n_touching += (kind_of(dof) == touching);
            sum += (kind_of(dof) == open ? level_of(dof) : 0.);
          }
        if (n_open == 0 || n_touching == 0 || n_open + n_touching < n_nodes)
          continue;

        std::array<double, n_nodes> level;
        for (unsigned int n = 0; n < n_nodes; ++n)
          level[n] = kind_of(face.dofs[n]) == open ? level_of(face.dofs[n]) :
                                                     sum / n_open - 1.;
        const auto touched = integrate(face, level);
        const auto whole   = integrate(face, below);
        double     own     = 0;
        for (unsigned int n = 0; n < n_nodes; ++n)
          if (kind_of(face.dofs[n]) == touching)
            {
              missing(face.dofs[n]) += whole[n] - touched[n];
              own += touched[n];
            }
        if (own > 0.)
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int m = 0; m < n_nodes; ++m)
              if (kind_of(face.dofs[n]) == touching &&
                  kind_of(face.dofs[m]) == open)
                entries.push_back(
                  {face.dofs[n], face.dofs[m], touched[m] * touched[n] / own});
      }
    missing.compress(VectorOperation::add);

    TouchedPart result;
    result.missing.reinit(vectors);
    result.missing.copy_locally_owned_data_from(missing);
    result.taken_over =
      std::make_shared<SharedRows::Weights>(entries, ghosted_vectors);
    return result;
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::neighbors(const Vector &kinds) const
  {
    const Vector kind_of = ghosted(kinds);
    Vector       marks(ghosted_vectors);
    for (const Face &face : faces)
      if (std::any_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kind_of(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          if (kind_of(dof) == open)
            marks(dof) = 1.;
    return largest_of_all_ranks(marks, vectors);
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::inside(const Vector &kinds) const
  {
    const Vector kind_of = ghosted(kinds);
    Vector       marks(ghosted_vectors);
    for (const Face &face : faces)
      if (std::all_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kind_of(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          marks(dof) = 1.;
    return largest_of_all_ranks(marks, vectors);
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::growth_beyond(const Vector &kinds,
                                  const Vector &neighbors,
                                  const Vector &values) const
  {
    const Vector kind_of = ghosted(kinds), value_of = ghosted(values);
    const Vector is_neighbor = ghosted(neighbors);
    Vector       growth(ghosted_vectors);
    for (const Face &face : faces)
      for (const auto near : face.dofs)
        if (is_neighbor(near) == 1.)
          for (const auto far : face.dofs)
            if (kind_of(far) == open && is_neighbor(far) == 0.)
              for (const auto dof : {near, far})
                growth(dof) =
                  std::max<double>(growth(dof), value_of(far) - value_of(near));
    return largest_of_all_ranks(growth, vectors);
  }



  template class ContactEdge<2>;
  template class ContactEdge<3>;
} // namespace ElastoPlastic
