// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/cell_id.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/vector.hpp>

#include <map>
#include <vector>

#include "base/compatibility.h"
#include "base/ghost_values.h"
#include "bounds/mechanism/quadratic_field.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Bernstein's coefficients of the quadratic function with these values at
    /// the corners of a simplex and in the middle of its edges.
    template <int dim, typename Value>
    std::vector<Value>
    coefficients(const std::array<Value, dim + 1>                &at_corners,
                 const std::array<Value, edges_per_simplex<dim>> &at_edges)
    {
      std::vector<Value> result(Bernstein<dim>::n_functions(2));
      const auto         of_product = [&](const unsigned int i,
                                  const unsigned int j) -> Value         &{
        typename Bernstein<dim>::Exponents exponents = {};
        ++exponents[i];
        ++exponents[j];
        return result[Bernstein<dim>::number_of(exponents)];
      };
      for (unsigned int i = 0; i <= dim; ++i)
        of_product(i, i) = at_corners[i];
      for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
        {
          const auto [a, b] = ends_of_edge<dim>(e);
          of_product(a, b) =
            2. * at_edges[e] - 0.5 * (at_corners[a] + at_corners[b]);
        }
      return result;
    }



    /// A finite element solution of all ranks, on the first of them, which can
    /// evaluate it anywhere. The others have nothing.
    template <int dim>
    class GatheredSolution
    {
    public:
      /// Collective. @p dof_handler must live as long as this object.
      GatheredSolution(const DoFHandler<dim> &dof_handler,
                       const VectorType      &displacement)
        : fe(dof_handler.get_fe())
      {
        const VectorType values = ghosted_copy(displacement, dof_handler);
        std::map<CellId, std::vector<double>> own;
        Vector<double>                        of_cell(fe.n_dofs_per_cell());
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              cell->get_dof_values(values, of_cell);
              own[cell->id()].assign(of_cell.begin(), of_cell.end());
            }
        for (const auto &of_rank :
             Utilities::MPI::gather(communicator_of(dof_handler), own))
          of_cells.insert(of_rank.begin(), of_rank.end());
      }

      /// At a point of the unit cell of a cell.
      // The components have the same shape functions.
      Tensor<1, dim>
      value(const CellId &cell, const Point<dim> &unit_point) const
      {
        const std::vector<double> &values = of_cells.at(cell);
        const FiniteElement<dim>  &scalar = fe.base_element(0);
        std::vector<double>        shapes(scalar.n_dofs_per_cell());
        for (unsigned int i = 0; i < shapes.size(); ++i)
          shapes[i] = scalar.shape_value(i, unit_point);

        Tensor<1, dim> result;
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            const auto [component, index] = fe.system_to_component_index(i);
            result[component] += values[i] * shapes[index];
          }
        return result;
      }

    private:
      const FiniteElement<dim>             &fe;
      std::map<CellId, std::vector<double>> of_cells; ///< by local unknowns
    };

  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>>
  QuadraticField<dim>::coefficients_on(const Simplex &simplex) const
  {
    std::array<Tensor<1, dim>, dim + 1>                of_corners;
    std::array<Tensor<1, dim>, edges_per_simplex<dim>> of_edges;
    for (unsigned int i = 0; i <= dim; ++i)
      of_corners[i] = at_vertices[simplex.vertices[i]];
    for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
      of_edges[e] = at_edges[simplex.edges[e]];
    return coefficients<dim>(of_corners, of_edges);
  }



  template <int dim>
  std::array<SymmetricTensor<2, dim>, dim + 1>
  QuadraticField<dim>::strains(const SplitMesh<dim> &mesh,
                               const unsigned int    t) const
  {
    const auto polynomial = coefficients_on(mesh.simplices[t]);
    std::array<SymmetricTensor<2, dim>, dim + 1> result;
    for (unsigned int i = 0; i <= dim; ++i)
      result[i] =
        Bernstein<dim>::symmetric_gradient(mesh.corners(mesh.simplices[t]),
                                           2,
                                           polynomial.begin(),
                                           corner_position<dim>(i));
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  FaceValues<dim>::value(const Barycentric<dim - 1> &position) const
  {
    return Bernstein<dim - 1>::value(
      2, coefficients<dim - 1>(at_corners, at_edges).begin(), position);
  }



  template <int dim>
  FaceValues<dim>
  QuadraticField<dim>::values_on_face(const SplitMesh<dim> &mesh,
                                      const unsigned int    face) const
  {
    const auto     &vertices = mesh.faces[face].vertices;
    const auto     &simplex  = mesh.simplices[mesh.faces[face].neighbors[0]];
    FaceValues<dim> values;
    for (unsigned int i = 0; i < dim; ++i)
      values.at_corners[i] = at_vertices[vertices[i]];
    for (unsigned int e = 0; e < edges_per_simplex<dim - 1>; ++e)
      {
        const auto [a, b] = ends_of_edge<dim - 1>(e);
        values.edges[e] =
          simplex
            .edges[edge_between<dim>(simplex.place_of_vertex(vertices[a]),
                                     simplex.place_of_vertex(vertices[b]))];
        values.at_edges[e] = at_edges[values.edges[e]];
      }
    return values;
  }



  template <int dim>
  QuadraticField<dim>
  QuadraticField<dim>::interpolate_displacement(
    const SplitMesh<dim>  &mesh,
    const DoFHandler<dim> &dof_handler,
    const VectorType      &displacement)
  {
    const GatheredSolution<dim> solution(dof_handler, displacement);
    QuadraticField<dim>         field;
    field.at_vertices.resize(mesh.vertices.size());
    field.at_edges.resize(mesh.n_edges);
    for (const auto &simplex : mesh.simplices)
      {
        const CellId &cell = mesh.cells[simplex.cell].id;
        const auto   &unit = simplex.unit_corners;
        for (unsigned int i = 0; i <= dim; ++i)
          field.at_vertices[simplex.vertices[i]] =
            solution.value(cell, unit[i]);
        for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
          {
            const auto [a, b] = ends_of_edge<dim>(e);
            field.at_edges[simplex.edges[e]] =
              solution.value(cell, unit[a] + 0.5 * (unit[b] - unit[a]));
          }
      }
    return field;
  }



  template struct FaceValues<2>;
  template struct FaceValues<3>;
  template struct QuadraticField<2>;
  template struct QuadraticField<3>;
} // namespace ElastoPlastic
