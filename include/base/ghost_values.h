// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_ghost_values_h
#define base_ghost_values_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/la_parallel_vector.h>

#include "base/compatibility.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// Lets a vector know the values of its ghost entries, as long as this object
  /// lives. It must have none before, and has none afterwards. Collective.
  template <typename Number>
  class GhostValues
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    explicit GhostValues(const Vector &vector)
      : vector(vector)
    {
      Assert(!vector.has_ghost_elements(), ExcInternalError());
      vector.update_ghost_values();
    }

    ~GhostValues()
    {
      vector.zero_out_ghost_values();
    }

    GhostValues(const GhostValues &) = delete;
    GhostValues &
    operator=(const GhostValues &) = delete;

  private:
    const Vector &vector;
  };



  /// A copy of @p vector that can be read on ghost cells too: it knows all
  /// locally relevant unknowns, while the vectors of a MatrixFree know only
  /// those of its own cells.
  template <int dim, typename Vector>
  Vector
  ghosted_copy(const Vector &vector, const DoFHandler<dim> &dof_handler)
  {
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    Vector copy(dof_handler.locally_owned_dofs(),
                relevant,
                communicator_of(dof_handler));
    copy.copy_locally_owned_data_from(vector);
    copy.update_ghost_values();
    return copy;
  }



  /// (An assignment would keep the ghosts that @p vector has.)
  template <int dim, typename Vector>
  void
  replace_by_ghosted_copy(Vector &vector, const DoFHandler<dim> &dof_handler)
  {
    Vector copy = ghosted_copy(vector, dof_handler);
    vector.swap(copy);
  }



  /// Such copies of several vectors, as deal.II's SolutionTransfer wants them.
  template <int dim>
  class GhostedCopies
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    GhostedCopies(const std::vector<Vector *> &vectors,
                  const DoFHandler<dim>       &dof_handler)
    {
      // (a copy of a copy does not know the values of other ranks)
      copies.reserve(vectors.size());
      for (const Vector *vector : vectors)
        copies.push_back(ghosted_copy(*vector, dof_handler));
    }

    /// Valid as long as this object.
    std::vector<const Vector *>
    pointers() const
    {
      std::vector<const Vector *> result;
      for (const Vector &copy : copies)
        result.push_back(&copy);
      return result;
    }

  private:
    std::vector<Vector> copies;
  };
} // namespace ElastoPlastic

#endif
