// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_quadratic_field_h
#define bounds_mechanism_quadratic_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <vector>

#include "bounds/mesh/split_mesh.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A displacement that is quadratic on each simplex of a SplitMesh and
  /// continuous: its strains are linear on each simplex.
  template <int dim>
  struct QuadraticField
  {
    std::vector<Tensor<1, dim>> at_vertices;
    std::vector<Tensor<1, dim>> at_edges; ///< in the middle
  };



  /// The gradients of the quadratic shape functions at a @p corner of a
  /// simplex: of those that belong to its corners, then of those that belong to
  /// the middles of its edges.
  template <int dim>
  std::array<Tensor<1, dim>, dim + 1 + edges_per_simplex<dim>>
  shape_gradients(const Corners<dim> &corners, const unsigned int corner);

  /// The strain of @p field at the corners of a @p simplex, between which it is
  /// linear.
  template <int dim>
  std::array<SymmetricTensor<2, dim>, dim + 1>
  strains(const SplitMesh<dim>      &mesh,
          const QuadraticField<dim> &field,
          const unsigned int         simplex);

  /// The value at a point of a simplex.
  template <int dim>
  Tensor<1, dim>
  value(const QuadraticField<dim>              &field,
        const typename SplitMesh<dim>::Simplex &simplex,
        const Barycentric<dim>                 &position);

  /// Its values at the corners and at the centre of gravity of a simplex.
  template <int dim>
  std::array<Tensor<1, dim>, dim + 2>
  values_at_vertices(const QuadraticField<dim>              &field,
                     const typename SplitMesh<dim>::Simplex &simplex);

  /// Its values on a face: at the corners, and in the middle of the edges, see
  /// ends_of_edge().
  template <int dim>
  struct FaceValues
  {
    std::array<unsigned int, edges_per_simplex<dim - 1>>   edges;
    std::array<Tensor<1, dim>, dim>                        at_corners;
    std::array<Tensor<1, dim>, edges_per_simplex<dim - 1>> at_edges;

    Tensor<1, dim>
    value(const Barycentric<dim - 1> &position) const;
  };

  template <int dim>
  FaceValues<dim>
  values_on_face(const SplitMesh<dim>      &mesh,
                 const QuadraticField<dim> &field,
                 const unsigned int         face);

  /// Interpolates a finite element solution on the cells of which @p mesh is
  /// made. Bilinear displacements of parallelograms are reproduced. The values
  /// are gathered on the first rank; the field of the others is empty, as their
  /// mesh is. Collective.
  template <int dim>
  QuadraticField<dim>
  interpolate_displacement(const SplitMesh<dim>  &mesh,
                           const DoFHandler<dim> &dof_handler,
                           const VectorType      &displacement);
} // namespace ElastoPlastic

#endif
