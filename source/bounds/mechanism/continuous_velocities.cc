// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/velocity_basis.h"

namespace ElastoPlastic
{
  namespace
  {
    /// In which the velocities of a face are zero.
    template <int dim>
    std::vector<Tensor<1, dim>>
    fixed_directions(const SplitBody<dim> &body, const unsigned int face)
    {
      const FaceSupport<dim>      support = body.support_of(face);
      const auto                  corners = body.corners_of_face(face);
      std::vector<Tensor<1, dim>> result;
      if (support.is_closed)
        result.push_back(normal(corners));
      if (support.resists_slip)
        for (const auto &tangent : tangents(corners))
          result.push_back(tangent);
      return result;
    }



    /// A node at which the velocity may be zero in some directions.
    template <int dim>
    class Node
    {
    public:
      /// No velocity in this direction.
      void
      fix(const Tensor<1, dim> &direction)
      {
        if (fixed.size() < dim)
          if (const auto rest = part_across(fixed, direction);
              rest.norm() > Tolerance::small_angle)
            fixed.push_back(rest / rest.norm());
      }

      /// Those at right angles to the directions of fix(), and to each other:
      /// of the axes, what has most that is new, one after the other.
      std::vector<Tensor<1, dim>>
      free_directions() const
      {
        std::vector<Tensor<1, dim>> all = fixed;
        while (all.size() < dim)
          {
            Tensor<1, dim> most;
            for (unsigned int c = 0; c < dim; ++c)
              if (const auto rest =
                    part_across(all, Point<dim>::unit_vector(c));
                  rest.norm() > most.norm())
                most = rest;
            all.push_back(most / most.norm());
          }
        return {all.begin() + fixed.size(), all.end()};
      }

    private:
      static Tensor<1, dim>
      part_across(const std::vector<Tensor<1, dim>> &directions,
                  Tensor<1, dim>                     vector)
      {
        for (const auto &direction : directions)
          vector -= (vector * direction) * direction;
        return vector;
      }

      std::vector<Tensor<1, dim>> fixed; ///< at right angles to each other
    };



    /// The edges of a face at the boundary.
    template <int dim>
    std::vector<unsigned int>
    edges_of_face(const SplitMesh<dim> &mesh, const unsigned int f)
    {
      const auto        &simplex = mesh.simplices[mesh.faces[f].neighbors[0]];
      const unsigned int k       = simplex.place_of_face(f);
      std::vector<unsigned int> edges;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i + 1; j < dim; ++j)
          edges.push_back(
            simplex.edges[edge_between<dim>(corner_of_face<dim>(k, i),
                                            corner_of_face<dim>(k, j))]);
      return edges;
    }



    /// Their nodes are the vertices and the middles of the edges.
    template <int dim>
    VelocityBasis<dim>
    quadratic_velocities(const SplitBody<dim> &body)
    {
      const auto               &mesh       = body.mesh;
      const auto                directions = free_directions_of_nodes(body);
      VelocityBasis<dim>        basis;
      std::vector<unsigned int> first_numbers;
      for (const auto &of_node : directions)
        {
          first_numbers.push_back(basis.size);
          basis.size += of_node.size();
        }
      for (const auto &simplex : mesh.simplices)
        {
          auto      &functions = basis.on_simplices.emplace_back();
          const auto add = [&](const unsigned int node, const auto &shape) {
            for (unsigned int c = 0; c < directions[node].size(); ++c)
              functions.push_back(
                {first_numbers[node] + c,
                 interpolate_velocity<dim>([&](const Barycentric<dim> &point) {
                   return shape(point) * directions[node][c];
                 })});
          };
          for (unsigned int i = 0; i <= dim; ++i)
            add(simplex.vertices[i], [i](const Barycentric<dim> &point) {
              return point[i] * (2. * point[i] - 1.);
            });
          for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
            add(mesh.vertices.size() + simplex.edges[e],
                [ends = ends_of_edge<dim>(e)](const Barycentric<dim> &point) {
                  return 4. * point[ends[0]] * point[ends[1]];
                });
        }
      return basis;
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<Tensor<1, dim>>>
  free_directions_of_nodes(const SplitBody<dim> &body)
  {
    const auto            &mesh = body.mesh;
    std::vector<Node<dim>> nodes(mesh.vertices.size() + mesh.n_edges);
    for (unsigned int f = 0; f < mesh.faces.size(); ++f)
      for (const auto &direction : fixed_directions(body, f))
        {
          for (const unsigned int v : mesh.faces[f].vertices)
            nodes[v].fix(direction);
          for (const unsigned int e : edges_of_face(mesh, f))
            nodes[mesh.vertices.size() + e].fix(direction);
        }
    std::vector<std::vector<Tensor<1, dim>>> result;
    for (const Node<dim> &node : nodes)
      result.push_back(node.free_directions());
    return result;
  }



  template <int dim>
  VelocityBasis<dim>
  continuous_velocities(const SplitBody<dim> &body)
  {
    if constexpr (dim == 2)
      if (body.is_axisymmetric())
        return revolution_velocities(body);
    return quadratic_velocities(body);
  }



  template std::vector<std::vector<Tensor<1, 2>>>
  free_directions_of_nodes(const SplitBody<2> &);
  template std::vector<std::vector<Tensor<1, 3>>>
  free_directions_of_nodes(const SplitBody<3> &);
  template VelocityBasis<2>
  continuous_velocities(const SplitBody<2> &);
  template VelocityBasis<3>
  continuous_velocities(const SplitBody<3> &);
} // namespace ElastoPlastic
