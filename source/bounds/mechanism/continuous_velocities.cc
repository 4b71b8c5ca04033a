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



    /// The components of the velocity at a node, in two directions at right
    /// angles: the numbers of their functions, if they are not zero.
    struct Node
    {
      std::array<Tensor<1, 2>, 2> directions = {
        {Tensor<1, 2>({1., 0.}), Tensor<1, 2>({0., 1.})}};
      std::array<bool, 2>         fixed   = {};
      std::array<unsigned int, 2> numbers = {{invalid, invalid}};

      /// No velocity in this direction.
      void
      fix(const Tensor<1, 2> &direction)
      {
        for (unsigned int c = 0; c < 2; ++c)
          if (std::abs(std::abs(directions[c] * direction) - 1.) <
              Tolerance::small_angle)
            {
              fixed[c] = true;
              return;
            }
        if (fixed[0] || fixed[1])
          fixed = {{true, true}};
        else
          {
            directions = {{direction, cross_product_2d(direction)}};
            fixed      = {{true, false}};
          }
      }
    };



    /// Runs @p action(side, direction) where the velocities of a side are zero
    /// in a direction.
    template <typename Action>
    void
    for_each_support(const SplitBody<2> &body, const Action &action)
    {
      for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
        {
          for (const auto &component : body.conditions[s].components)
            if (component.type == ConditionType::displacement)
              action(s, component.direction);
          if (body.conditions[s].is_reached &&
              body.indenter_surface == SurfaceFinish::rough)
            action(s, Point<2>::unit_vector(0));
        }
    }



    /// Their nodes are the vertices and the middles of the sides.
    class PlaneVelocities : public ContinuousVelocities
    {
    public:
      explicit PlaneVelocities(const SplitBody<2> &body);

      unsigned int
      n_functions() const override
      {
        return n;
      }

      std::vector<VelocityFunction>
      functions_of(const unsigned int triangle) const override;

    private:
      const SplitMesh<2> &mesh;
      std::vector<Node>   nodes;
      unsigned int        n = 0;
    };



    PlaneVelocities::PlaneVelocities(const SplitBody<2> &body)
      : ContinuousVelocities(/* rate_degree = */ 1, /* trace_degree = */ 2)
      , mesh(body.mesh)
      , nodes(mesh.vertices.size() + mesh.faces.size())
    {
      for_each_support(body,
                       [this](const unsigned int  s,
                              const Tensor<1, 2> &direction) {
                         for (const unsigned int v : mesh.faces[s].vertices)
                           nodes[v].fix(direction);
                         nodes[mesh.vertices.size() + s].fix(direction);
                       });
      for (Node &node : nodes)
        for (unsigned int c = 0; c < 2; ++c)
          if (!node.fixed[c])
            node.numbers[c] = n++;
    }



    std::vector<VelocityFunction>
    PlaneVelocities::functions_of(const unsigned int t) const
    {
      std::vector<VelocityFunction> result;
      const auto add = [&](const Node &node, const auto &shape) {
        for (unsigned int c = 0; c < 2; ++c)
          if (!node.fixed[c])
            result.push_back(
              {node.numbers[c],
               interpolate_cubic([&](const Barycentric<2> &point) {
                 return shape(point) * node.directions[c];
               })});
      };
      const auto &triangle = mesh.simplices[t];
      for (unsigned int i = 0; i < 3; ++i)
        add(nodes[triangle.vertices[i]], [i](const Barycentric<2> &point) {
          return point[i] * (2. * point[i] - 1.);
        });
      for (unsigned int i = 0; i < 3; ++i)
        add(nodes[mesh.vertices.size() + triangle.faces[i]],
            [i](const Barycentric<2> &point) {
              return 4. * point[i] * point[(i + 1) % 3];
            });
      return result;
    }



    /// By the coefficients of w and of v_z in Bernstein's basis, which are
    /// continuous if neighbours have those of their side in common. What is
    /// held in an oblique direction is held in both.
    class RevolutionVelocities : public ContinuousVelocities
    {
    public:
      explicit RevolutionVelocities(const SplitBody<2> &body);

      unsigned int
      n_functions() const override
      {
        return n;
      }

      std::vector<VelocityFunction>
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
      : ContinuousVelocities(/* rate_degree = */ 2, /* trace_degree = */ 3)
      , body(body)
      , mesh(body.mesh)
    {
      std::array<std::vector<bool>, 2> held;
      held.fill(std::vector<bool>(mesh.faces.size(), false));
      for_each_support(
        body, [&](const unsigned int s, const Tensor<1, 2> &direction) {
          const auto corners = body.corners_of_face(s);
          if (body.is_on_axis(corners[0]) && body.is_on_axis(corners[1]))
            return;
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



    std::vector<VelocityFunction>
    RevolutionVelocities::functions_of(const unsigned int t) const
    {
      std::vector<VelocityFunction> result;
      const auto                    corners = body.corners_of(t);
      for (unsigned int i = 0; i < n_quadratics; ++i)
        if (const unsigned int number =
              radial[place(t, Bernstein<2>::exponents(2)[i])];
            number != invalid)
          result.push_back(
            {number, interpolate_cubic([&](const Barycentric<2> &point) {
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



  std::unique_ptr<ContinuousVelocities>
  make_continuous_velocities(const SplitBody<2> &body)
  {
    if (body.is_axisymmetric())
      return std::make_unique<RevolutionVelocities>(body);
    return std::make_unique<PlaneVelocities>(body);
  }
} // namespace ElastoPlastic
