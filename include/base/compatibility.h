// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_compatibility_h
#define base_compatibility_h

#include <deal.II/base/config.h>
#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <type_traits>
#include <utility>

#if __has_include(<deal.II/base/enable_observer_pointer.h>)
#  include <deal.II/base/enable_observer_pointer.h>
#else
#  include <deal.II/base/subscriptor.h>
#endif

#if DEAL_II_VERSION_GTE(9, 7, 0)
#  include <deal.II/numerics/solution_transfer.h>
#else
#  include <deal.II/distributed/solution_transfer.h>
#endif

/// What is called differently in the versions of deal.II that the program is
/// compiled with, from 9.4 on: here only, by its name in this program.
namespace ElastoPlastic
{
  /// What deal.II's pointers may observe.
#if __has_include(<deal.II/base/enable_observer_pointer.h>)
  using Observable = dealii::EnableObserverPointer;
#else
  using Observable = dealii::Subscriptor;
#endif

  /// Takes vectors of all processes over to an adapted mesh.
#if DEAL_II_VERSION_GTE(9, 7, 0)
  template <int dim, typename VectorType>
  using DistributedSolutionTransfer = dealii::SolutionTransfer<dim, VectorType>;
#else
  template <int dim, typename VectorType>
  using DistributedSolutionTransfer =
    dealii::parallel::distributed::SolutionTransfer<dim, VectorType>;
#endif



  template <typename Object, typename = void>
  constexpr bool names_mpi_communicator = false;

  template <typename Object>
  constexpr bool
    names_mpi_communicator<Object,
                           std::void_t<decltype(std::declval<const Object &>()
                                                  .get_mpi_communicator())>> =
      true;

  /// The communicator of a Triangulation or a DoFHandler.
  template <typename Object>
  MPI_Comm
  communicator_of(const Object &object)
  {
    if constexpr (names_mpi_communicator<Object>)
      return object.get_mpi_communicator();
    else
      return object.get_communicator();
  }



  /// Still without any: constraints on the unknowns that this process knows.
  /// (In a Debug build, deal.II refuses to exchange constraints with a process
  /// that knows none: one without cells has the first unknown.)
  template <int dim, typename Constraints = dealii::AffineConstraints<double>>
  Constraints
  empty_constraints(const dealii::DoFHandler<dim> &dof_handler)
  {
    using dealii::IndexSet;
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    IndexSet        relevant =
      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
    if (relevant.is_empty() && dof_handler.n_dofs() > 0)
      relevant.add_index(0);
    if constexpr (std::is_constructible_v<Constraints, IndexSet, IndexSet>)
      return Constraints(owned, relevant);
    else
      return Constraints(relevant);
  }



  /// Calls @p use with what QProjector takes for the orientation of a face: one
  /// number, or three.
  template <typename Cell, typename Use>
  auto
  with_face_orientation(const Cell        &cell,
                        const unsigned int face,
                        const Use         &use)
  {
#if DEAL_II_VERSION_GTE(9, 7, 0)
    return use(cell->combined_face_orientation(face));
#else
    return use(cell->face_orientation(face),
               cell->face_flip(face),
               cell->face_rotation(face));
#endif
  }
} // namespace ElastoPlastic

#endif
