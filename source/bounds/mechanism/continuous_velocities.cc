// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/mechanism/continuous_velocities.h"
#include "bounds/mechanism/free_directions.h"
#include "bounds/mechanism/revolution_velocities.h"

namespace ElastoPlastic
{
  namespace
  {
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



    template <int dim>
    QuadraticVelocities<dim>::QuadraticVelocities(const SplitBody<dim> &body)
      : ContinuousVelocities<dim>(/* rate_degree = */ 1, /* trace_degree = */ 2)
      , mesh(body.mesh)
    {
      for (const auto &directions : free_directions_of_nodes(body))
        {
          nodes.push_back({directions, n});
          n += directions.size();
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
