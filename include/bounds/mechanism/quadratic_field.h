// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_quadratic_field_h
#define bounds_mechanism_quadratic_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <vector>

#include "bounds/mesh/split_mesh.h"
#include "bounds/stress/bernstein.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The values of a QuadraticField on a face: at the corners, and in the
  /// middle of the edges, see ends_of_edge().
  template <int dim>
  struct FaceValues
  {
    std::array<unsigned int, edges_per_simplex<dim - 1>>   edges;
    std::array<Tensor<1, dim>, dim>                        at_corners;
    std::array<Tensor<1, dim>, edges_per_simplex<dim - 1>> at_edges;

    Tensor<1, dim>
    value(const Barycentric<dim - 1> &position) const;
  };



  /// A displacement that is quadratic on each simplex of a SplitMesh and
  /// continuous: its strains are linear on each simplex.
  template <int dim>
  struct QuadraticField
  {
    using Simplex = typename SplitMesh<dim>::Simplex;

    /// Interpolates a finite element solution on the cells of which @p mesh is
    /// made. Bilinear displacements of parallelograms are reproduced. The
    /// values are gathered on the first rank; the field of the others is empty,
    /// as their mesh is. Collective.
    static QuadraticField
    interpolate_displacement(const SplitMesh<dim>  &mesh,
                             const DoFHandler<dim> &dof_handler,
                             const VectorType      &displacement);

    /// The strain at the corners of a @p simplex, between which it is linear.
    std::array<SymmetricTensor<2, dim>, dim + 1>
    strains(const SplitMesh<dim> &mesh, const unsigned int simplex) const;

    /// The value at a point of a simplex.
    Tensor<1, dim>
    value(const Simplex &simplex, const Barycentric<dim> &position) const
    {
      return Bernstein<dim>::value(2,
                                   coefficients_on(simplex).begin(),
                                   position);
    }

    FaceValues<dim>
    values_on_face(const SplitMesh<dim> &mesh, const unsigned int face) const;

    std::vector<Tensor<1, dim>> at_vertices;
    std::vector<Tensor<1, dim>> at_edges; ///< in the middle

  private:
    /// In Bernstein's basis.
    std::vector<Tensor<1, dim>>
    coefficients_on(const Simplex &simplex) const;
  };
} // namespace ElastoPlastic

#endif
