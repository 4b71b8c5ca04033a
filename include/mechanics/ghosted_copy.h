// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_ghosted_copy_h
#define mechanics_ghosted_copy_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include "base/compatibility.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A copy of @p vector that can be read on ghost cells too: it knows all
  /// locally relevant unknowns, while the vectors of a MatrixFree know only
  /// those of its own cells.
  template <int dim>
  VectorType
  ghosted_copy(const VectorType &vector, const DoFHandler<dim> &dof_handler)
  {
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    VectorType copy(dof_handler.locally_owned_dofs(),
                    relevant,
                    communicator_of(dof_handler));
    copy.copy_locally_owned_data_from(vector);
    copy.update_ghost_values();
    return copy;
  }



  /// (An assignment would keep the ghosts that @p vector has.)
  template <int dim>
  void
  replace_by_ghosted_copy(VectorType            &vector,
                          const DoFHandler<dim> &dof_handler)
  {
    VectorType copy = ghosted_copy(vector, dof_handler);
    vector.swap(copy);
  }



  /// Such copies of several vectors, as deal.II's SolutionTransfer wants them.
  template <int dim>
  class GhostedCopies
  {
  public:
    GhostedCopies(const std::vector<VectorType *> &vectors,
                  const DoFHandler<dim>           &dof_handler)
    {
      // (a copy of a copy does not know the values of other ranks)
      copies.reserve(vectors.size());
      for (const VectorType *vector : vectors)
        copies.push_back(ghosted_copy(*vector, dof_handler));
    }

    /// Valid as long as this object.
    std::vector<const VectorType *>
    pointers() const
    {
      std::vector<const VectorType *> result;
      for (const VectorType &copy : copies)
        result.push_back(&copy);
      return result;
    }

  private:
    std::vector<VectorType> copies;
  };
} // namespace ElastoPlastic

#endif
