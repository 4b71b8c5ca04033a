// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <map>
#include <utility>

#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/velocity_basis.h"

namespace ElastoPlastic
{
  namespace
  {
    bool
    is_radial(const Tensor<1, 2> &direction)
    {
      return std::abs(direction[1]) <= Tolerance::small_angle;
    }

    bool
    is_axial(const Tensor<1, 2> &direction)
    {
      return std::abs(direction[0]) <= Tolerance::small_angle;
    }

    bool
    is_oblique(const Tensor<1, 2> &direction)
    {
      return !is_radial(direction) && !is_axial(direction);
    }



    /// Of the function on a side between two corners that is @p i times that
    /// of the first and @p j times that of the second.
    Bernstein<2>::Exponents
    exponents_between(const std::array<unsigned int, 2> &corners,
                      const int                          i,
                      const int                          j)
    {
      Bernstein<2>::Exponents exponents = {};
      exponents[corners[0]] += i;
      exponents[corners[1]] += j;
      return exponents;
    }



    void
    add_axial(SimplexVelocity<2>            &velocity,
              const Bernstein<2>::Exponents &exponents,
              const double                   factor)
    {
      velocity.coefficients[Bernstein<2>::number_of(exponents)][1] += factor;
    }



    /// Those of a body of revolution, by the coefficients of w and v_z in
    /// Bernstein's basis, which are continuous if neighbours have those of
    /// their side in common. No velocity crosses the axis, whatever w is. Along
    /// an oblique side that is closed, with the direction (d_r, d_z), v_z is
    /// d_z / d_r v_r = d_z / d_r (r / L) w, which is cubic: there, one unknown
    /// is the coefficient of w over d_r, and those of v_z follow.
    class RevolutionVelocities
    {
    public:
      // A side has one coefficient of w and two of v_z that are not those of
      // its ends, a triangle one of v_z.
      explicit RevolutionVelocities(const SplitBody<2> &body)
        : mesh(body.mesh)
        , length_unit(body.length_unit)
      {
        for (const auto &directions : free_directions_of_nodes(body))
          {
            const bool is_side = nodes.size() >= mesh.vertices.size();
            nodes.push_back({directions, n});
            for (const auto &direction : directions)
              n += is_side && is_axial(direction) ? 2 : 1;
          }
        first_inside = n;
        n += mesh.simplices.size();
      }

      VelocityBasis<2>
      basis() const
      {
        VelocityBasis<2> basis = {n, {}};
        for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
          {
            Functions functions;
            for (unsigned int i = 0; i < 3; ++i)
              add_corner(functions, t, i);
            for (unsigned int e = 0; e < 3; ++e)
              add_side(functions, t, e);
            add_axial(functions[first_inside + t], {{1, 1, 1}}, 1.);

            auto &on_triangle = basis.on_simplices.emplace_back();
            for (const auto &[number, velocity] : functions)
              on_triangle.push_back({number, velocity});
          }
        return basis;
      }

    private:
      using Exponents = Bernstein<2>::Exponents;
      using Functions = std::map<unsigned int, SimplexVelocity<2>>;

      /// A vertex or a side: its unknowns follow one another.
      struct Node
      {
        std::vector<Tensor<1, 2>> directions;
        unsigned int              first_number;

        /// Whether this is a side along which velocities are oblique.
        bool
        is_oblique() const
        {
          return directions.size() == 1 &&
                 ElastoPlastic::is_oblique(directions[0]);
        }
      };

      const Node &
      side(const unsigned int t, const unsigned int edge) const
      {
        return nodes[mesh.vertices.size() + mesh.simplices[t].edges[edge]];
      }

      /// The radius of a corner in units of the length.
      double
      radius(const unsigned int t, const unsigned int corner) const
      {
        return mesh.vertices[mesh.simplices[t].vertices[corner]][0] /
               length_unit;
      }

      /// Adds (r / L) times a quadratic function to the radial velocity.
      void
      add_radial(SimplexVelocity<2> &velocity,
                 const unsigned int  t,
                 const Exponents    &exponents,
                 const double        factor) const
      {
        for (unsigned int k = 0; k < 3; ++k)
          {
            Exponents raised = exponents;
            ++raised[k];
            velocity.coefficients[Bernstein<2>::number_of(raised)][0] +=
              factor * raised[k] / 3. * radius(t, k);
          }
      }

      // Along an oblique side, r w has the coefficients r_0 w_0, (r_1 w_0 + 2
      // r_0 w_01) / 3, (r_0 w_1 + 2 r_1 w_01) / 3 and r_1 w_1.
      void
      add_corner(Functions         &functions,
                 const unsigned int t,
                 const unsigned int corner) const
      {
        const auto &[directions, first_number] =
          nodes[mesh.simplices[t].vertices[corner]];
        for (unsigned int d = 0; d < directions.size(); ++d)
          {
            const Tensor<1, 2> &direction = directions[d];
            SimplexVelocity<2> &velocity  = functions[first_number + d];
            const auto          at_corner = [corner](const int degree) {
              return exponents_between({{corner, corner}}, degree, 0);
            };
            if (is_axial(direction))
              add_axial(velocity, at_corner(3), 1.);
            else
              add_radial(velocity, t, at_corner(2), direction[0]);
            if (!is_oblique(direction))
              continue;
            add_axial(velocity, at_corner(3), direction[1] * radius(t, corner));
            for (unsigned int e = 0; e < 3; ++e)
              if (const auto ends = ends_of_edge<2>(e);
                  side(t, e).is_oblique() &&
                  (ends[0] == corner || ends[1] == corner))
                {
                  const unsigned int other = ends[0] + ends[1] - corner;
                  add_axial(velocity,
                            exponents_between({{corner, other}}, 2, 1),
                            direction[1] * radius(t, other) / 3.);
                }
          }
      }

      // The coefficients of v_z are in the order of the numbers of the
      // vertices.
      void
      add_side(Functions         &functions,
               const unsigned int t,
               const unsigned int edge) const
      {
        const auto &vertices = mesh.simplices[t].vertices;
        auto        ends     = ends_of_edge<2>(edge);
        if (vertices[ends[0]] > vertices[ends[1]])
          std::swap(ends[0], ends[1]);
        unsigned int number = side(t, edge).first_number;
        for (const Tensor<1, 2> &direction : side(t, edge).directions)
          {
            const auto between = [&ends](const int i, const int j) {
              return exponents_between(ends, i, j);
            };
            if (is_axial(direction))
              {
                add_axial(functions[number++], between(2, 1), 1.);
                add_axial(functions[number++], between(1, 2), 1.);
                continue;
              }
            SimplexVelocity<2> &velocity = functions[number++];
            add_radial(velocity, t, between(1, 1), direction[0]);
            if (is_oblique(direction))
              {
                const double factor = 2. / 3. * direction[1];
                add_axial(velocity, between(2, 1), factor * radius(t, ends[0]));
                add_axial(velocity, between(1, 2), factor * radius(t, ends[1]));
              }
          }
      }

      const SplitMesh<2> &mesh;
      const double        length_unit;
      std::vector<Node>   nodes;            ///< vertices, then sides
      unsigned int        first_inside = 0; ///< of one unknown per triangle
      unsigned int        n            = 0;
    };
  } // namespace



  VelocityBasis<2>
  revolution_velocities(const SplitBody<2> &body)
  {
    return RevolutionVelocities(body).basis();
  }
} // namespace ElastoPlastic
