// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_revolution_velocities_h
#define bounds_mechanism_revolution_velocities_h

#include <map>

#include "bounds/mechanism/continuous_velocities.h"

namespace ElastoPlastic
{
  /// Those of a body of revolution, by the coefficients of w and v_z in
  /// Bernstein's basis, which are continuous if neighbours have those of their
  /// side in common. No velocity crosses the axis, whatever w is. Along an
  /// oblique side that is closed, with the direction (d_r, d_z), v_z is d_z /
  /// d_r v_r = d_z / d_r (r / L) w, which is cubic: there, one unknown is the
  /// coefficient of w over d_r, and those of v_z follow.
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
    using Exponents = Bernstein<2>::Exponents;
    using Functions = std::map<unsigned int, SimplexVelocity<2>>;

    /// A vertex or a side: its unknowns follow one another.
    struct Node
    {
      std::vector<Tensor<1, 2>> directions;
      unsigned int              first_number;

      /// Whether this is a side along which velocities are oblique.
      bool
      is_oblique() const;
    };

    const Node &
    side(const unsigned int triangle, const unsigned int edge) const
    {
      return nodes[mesh.vertices.size() + mesh.simplices[triangle].edges[edge]];
    }

    void
    add_corner(Functions         &functions,
               const unsigned int triangle,
               const unsigned int corner) const;
    void
    add_side(Functions         &functions,
             const unsigned int triangle,
             const unsigned int edge) const;

    /// The radius of a corner in units of the length.
    double
    radius(const unsigned int triangle, const unsigned int corner) const
    {
      return mesh.vertices[mesh.simplices[triangle].vertices[corner]][0] /
             length_unit;
    }

    /// Adds (r / L) times a quadratic function to the radial velocity.
    void
    add_radial(SimplexVelocity<2> &velocity,
               const unsigned int  triangle,
               const Exponents    &exponents,
               const double        factor) const;

    const SplitMesh<2> &mesh;
    const double        length_unit;
    std::vector<Node>   nodes;            ///< vertices, then sides
    unsigned int        first_inside = 0; ///< of one unknown per triangle
    unsigned int        n            = 0;
  };
} // namespace ElastoPlastic

#endif
