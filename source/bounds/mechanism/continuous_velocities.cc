// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/continuous_velocities.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int invalid = numbers::invalid_unsigned_int;



    /// Runs @p action(face, direction) where the velocities of a face are zero
    /// in a direction.
    template <int dim, typename Action>
    void
    for_each_support(const SplitBody<dim> &body, const Action &action)
    {
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        {
          const FaceSupport<dim> support = body.support_of(f);
          const auto             corners = body.corners_of_face(f);
          if (support.is_closed)
            action(f, normal(corners));
          if (support.resists_slip)
            for (const auto &tangent : tangents(corners))
              action(f, tangent);
        }
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



    /// Their nodes are the vertices and the middles of the edges.
    template <int dim>
    class QuadraticVelocities : public ContinuousVelocities<dim>
    {
    public:
      explicit QuadraticVelocities(const SplitBody<dim> &body);

      unsigned int
      n_functions() const override
      {
        return n;
      }

      std::vector<VelocityFunction<dim>>
      functions_of(const unsigned int simplex) const override;

    private:
      /// The velocities at a node, whose numbers follow one another.
      struct FreeNode
      {
        std::vector<Tensor<1, dim>> directions;
        unsigned int                first_number;
      };

      const SplitMesh<dim> &mesh;
      std::vector<FreeNode> nodes;
      unsigned int          n = 0;
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



    template <int dim>
    QuadraticVelocities<dim>::QuadraticVelocities(const SplitBody<dim> &body)
      : ContinuousVelocities<dim>(/* rate_degree = */ 1, /* trace_degree = */ 2)
      , mesh(body.mesh)
    {
      std::vector<Node<dim>> all(mesh.vertices.size() + mesh.n_edges);
      for_each_support(body,
                       [&](const unsigned int    f,
                           const Tensor<1, dim> &direction) {
                         for (const unsigned int v : mesh.faces[f].vertices)
                           all[v].fix(direction);
                         for (const unsigned int e : edges_of_face(mesh, f))
                           all[mesh.vertices.size() + e].fix(direction);
                       });
      for (const Node<dim> &node : all)
        {
          nodes.push_back({node.free_directions(), n});
          n += nodes.back().directions.size();
        }
    }



    template <int dim>
    std::vector<VelocityFunction<dim>>
    QuadraticVelocities<dim>::functions_of(const unsigned int t) const
    {
      std::vector<VelocityFunction<dim>> result;
      const auto add = [&](const FreeNode &node, const auto &shape) {
        for (unsigned int c = 0; c < node.directions.size(); ++c)
          result.push_back(
            {node.first_number + c,
             interpolate_velocity<dim>([&](const Barycentric<dim> &point) {
               return shape(point) * node.directions[c];
             })});
      };
      const auto &simplex = mesh.simplices[t];
      for (unsigned int i = 0; i <= dim; ++i)
        add(nodes[simplex.vertices[i]], [i](const Barycentric<dim> &point) {
          return point[i] * (2. * point[i] - 1.);
        });
      for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
        add(nodes[mesh.vertices.size() + simplex.edges[e]],
            [ends = ends_of_edge<dim>(e)](const Barycentric<dim> &point) {
              return 4. * point[ends[0]] * point[ends[1]];
            });
      return result;
    }



    /// By the coefficients of w and of v_z in Bernstein's basis, which are
    /// continuous if neighbours have those of their side in common. What is
    /// held in an oblique direction is held in both.
    class RevolutionVelocities : public ContinuousVelocities<2>
    {
    public:
      explicit RevolutionVelocities(const SplitBody<2> &body);

      unsigned int
      n_functions() const override
      {
        return n;
      }

      std::vector<VelocityFunction<2>>
      functions_of(const unsigned int triangle) const override;

    private:
      /// Numbers all coefficients but those of a side that @p is_held.
      std::vector<unsigned int>
      number(const unsigned int degree, const std::vector<bool> &is_held);
      /// The place of a coefficient: first those of vertices, then those of
      /// sides, those of triangles last.
      unsigned int
      place(const unsigned int             triangle,
            const Bernstein<2>::Exponents &exponents) const;

      const SplitBody<2>       &body;
      const SplitMesh<2>       &mesh;
      unsigned int              n = 0;
      std::vector<unsigned int> radial, axial;
    };



    // No velocity crosses the axis, whatever w is.
    RevolutionVelocities::RevolutionVelocities(const SplitBody<2> &body)
      : ContinuousVelocities<2>(/* rate_degree = */ 2, /* trace_degree = */ 3)
      , body(body)
      , mesh(body.mesh)
    {
      std::array<std::vector<bool>, 2> held;
      held.fill(std::vector<bool>(mesh.faces.size(), false));
      for_each_support(body,
                       [&](const unsigned int  s,
                           const Tensor<1, 2> &direction) {
                         for (unsigned int c = 0; c < 2; ++c)
                           if (std::abs(direction[c]) > Tolerance::small_angle)
                             held[c][s] = true;
                       });
      radial = number(/* degree = */ 2, held[0]);
      axial  = number(/* degree = */ 3, held[1]);
    }



    std::vector<unsigned int>
    RevolutionVelocities::number(const unsigned int       degree,
                                 const std::vector<bool> &is_held)
    {
      const unsigned int n_vertices = mesh.vertices.size(),
                         n_sides = mesh.faces.size(), per_side = degree - 1;
      std::vector<unsigned int> numbers(n_vertices + per_side * n_sides +
                                          (degree == 3 ? mesh.simplices.size() :
                                                         0),
                                        0);
      for (unsigned int s = 0; s < n_sides; ++s)
        if (is_held[s])
          {
            for (const unsigned int vertex : mesh.faces[s].vertices)
              numbers[vertex] = invalid;
            std::fill_n(numbers.begin() + n_vertices + per_side * s,
                        per_side,
                        invalid);
          }
      for (unsigned int &number : numbers)
        if (number != invalid)
          number = n++;
      return numbers;
    }



    // A side has one coefficient of degree 2; of degree 3 that beside its first
    // vertex, and the other.
    unsigned int
    RevolutionVelocities::place(const unsigned int             t,
                                const Bernstein<2>::Exponents &exponents) const
    {
      const auto        &triangle   = mesh.simplices[t];
      const unsigned int n_vertices = mesh.vertices.size();
      const int          degree = exponents[0] + exponents[1] + exponents[2];
      const unsigned int nearest =
        std::max_element(exponents.begin(), exponents.end()) -
        exponents.begin();
      if (exponents[nearest] == degree)
        return triangle.vertices[nearest];
      const unsigned int opposite =
        std::find(exponents.begin(), exponents.end(), 0) - exponents.begin();
      if (opposite == exponents.size())
        return n_vertices + (degree - 1) * mesh.faces.size() + t;
      const unsigned int side  = triangle.faces[(opposite + 1) % 3];
      const bool         first = degree == 2 || mesh.faces[side].vertices[0] ==
                                          triangle.vertices[nearest];
      return n_vertices + (degree - 1) * side + (first ? 0 : 1);
    }



    std::vector<VelocityFunction<2>>
    RevolutionVelocities::functions_of(const unsigned int t) const
    {
      std::vector<VelocityFunction<2>> result;
      const auto                       corners = body.corners_of(t);
      for (unsigned int i = 0; i < n_quadratics; ++i)
        if (const unsigned int number =
              radial[place(t, Bernstein<2>::exponents(2)[i])];
            number != invalid)
          result.push_back(
            {number, interpolate_velocity<2>([&](const Barycentric<2> &point) {
               return Tensor<1, 2>(
                 {interpolate(point, corners)[0] / body.length_unit *
                    Bernstein<2>::functions(2, point)[i],
                  0.});
             })});
      for (unsigned int i = 0; i < n_cubics; ++i)
        if (const unsigned int number =
              axial[place(t, Bernstein<2>::exponents(3)[i])];
            number != invalid)
          {
            result.push_back({number, {}});
            result.back().velocity.coefficients[i][1] = 1.;
          }
      return result;
    }
  } // namespace



  template <int dim>
  std::unique_ptr<ContinuousVelocities<dim>>
  make_continuous_velocities(const SplitBody<dim> &body)
  {
    if constexpr (dim == 2)
      if (body.is_axisymmetric())
        return std::make_unique<RevolutionVelocities>(body);
    return std::make_unique<QuadraticVelocities<dim>>(body);
  }



  template std::unique_ptr<ContinuousVelocities<2>>
  make_continuous_velocities(const SplitBody<2> &);
  template std::unique_ptr<ContinuousVelocities<3>>
  make_continuous_velocities(const SplitBody<3> &);
} // namespace ElastoPlastic
