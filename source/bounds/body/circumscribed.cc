// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    /// By vertices of the mesh.
    using Displacements = std::map<unsigned int, Tensor<1, 3>>;



    /// How many times farther from the centre the ends of the edges that cross
    /// the edge of the disc must be. Of an edge between two points of the
    /// circle, half of which is seen from the centre under the angle a, these
    /// are 1 / cos(a) times: then no point of it is nearer than the radius, nor
    /// is any if its ends are still farther away.
    std::map<unsigned int, double>
    necessary_stretches(const SplitBody<3> &body)
    {
      std::map<unsigned int, double> stretches;
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        {
          const FaceCorners<3> corners = body.mesh.corners(body.mesh.faces[f]);
          if (!body.conditions[f].is_reached ||
              contains(*body.footprint.disc, corners))
            continue;
          for (unsigned int i = 0; i < 3; ++i)
            {
              const unsigned int j = (i + 1) % 3;
              if (!is_on_edge(*body.footprint.disc, corners[i]) ||
                  !is_on_edge(*body.footprint.disc, corners[j]))
                continue;
              const Point<3> middle(0.5 * (corners[i] + corners[j]));
              const double   stretch =
                (1. + rounding_of_circle) * body.footprint.disc->radius /
                from_above(middle).distance(body.footprint.disc->centre);
              for (const unsigned int end : {i, j})
                {
                  double &largest = stretches[body.mesh.faces[f].vertices[end]];
                  largest         = std::max(largest, stretch);
                }
            }
        }
      return stretches;
    }



    Displacements
    necessary_displacements(const SplitBody<3> &body)
    {
      Displacements displacements;
      for (const auto &[vertex, stretch] : necessary_stretches(body))
        {
          const Tensor<1, 2> radius = from_above(body.mesh.vertices[vertex]) -
                                      body.footprint.disc->centre;
          displacements[vertex] =
            (stretch - 1.) * Tensor<1, 3>({radius[0], radius[1], 0.});
        }
      return displacements;
    }



    /// The faces at the boundary around each vertex that moves.
    std::map<unsigned int, std::vector<unsigned int>>
    faces_around(const Displacements &displacements, const SplitBody<3> &body)
    {
      std::map<unsigned int, std::vector<unsigned int>> faces;
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        if (!body.mesh.faces[f].is_inside())
          for (const unsigned int v : body.mesh.faces[f].vertices)
            if (displacements.count(v) > 0)
              faces[v].push_back(f);
      return faces;
    }



    bool
    has_values(const FaceCondition<3> &condition)
    {
      return !std::all_of(condition.components.begin(),
                          condition.components.end(),
                          [&](const auto &component) {
                            return component.value.is_zero() &&
                                   component.live_load.is_zero();
                          });
    }



    /// Whether the boundary stays where it is, with its conditions: no face
    /// leaves its plane or has values of its own, and no vertex moves between
    /// two boundaries in one plane.
    bool
    keep_boundary(const Displacements &displacements, const SplitBody<3> &body)
    {
      const auto normal_of = [&](const unsigned int f) {
        return normal(body.mesh.corners(body.mesh.faces[f]));
      };
      for (const auto &[v, faces] : faces_around(displacements, body))
        for (const unsigned int f : faces)
          {
            const Tensor<1, 3> &moved = displacements.at(v), n = normal_of(f);
            if (std::abs(moved * n) > Tolerance::small_angle * moved.norm() ||
                has_values(body.conditions[f]))
              return false;
            for (const unsigned int g : faces)
              if (body.mesh.faces[f].boundary_id !=
                    body.mesh.faces[g].boundary_id &&
                  cross_product_3d(n, normal_of(g)).norm() <
                    Tolerance::small_angle)
                return false;
          }
      return true;
    }



    /// Whether no point gets into another material.
    bool
    keep_materials(const Displacements &displacements, const SplitBody<3> &body)
    {
      const auto slope = [&](const unsigned int t) {
        return body.has_friction() ? body.friction_slopes[t] : 0.;
      };
      std::map<unsigned int, unsigned int> first_simplices;
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        for (const unsigned int v : body.mesh.simplices[t].vertices)
          if (displacements.count(v) > 0)
            {
              const unsigned int other =
                first_simplices.emplace(v, t).first->second;
              const Material<double> &here  = body.materials[t],
                                     &there = body.materials[other];
              if (there.yield_radius != here.yield_radius ||
                  there.criteria != here.criteria || slope(other) != slope(t))
                return false;
            }
      return true;
    }



    double
    signed_volume(const Corners<3> &x)
    {
      return cross_product_3d(x[1] - x[0], x[2] - x[0]) * (x[3] - x[0]);
    }



    /// Whether all tetrahedra are the same way round in both meshes.
    bool
    keep_orientation(const SplitMesh<3> &moved, const SplitMesh<3> &mesh)
    {
      return std::all_of(mesh.simplices.begin(),
                         mesh.simplices.end(),
                         [&](const auto &tetrahedron) {
                           return signed_volume(moved.corners(tetrahedron)) *
                                    signed_volume(mesh.corners(tetrahedron)) >
                                  0.;
                         });
    }
  } // namespace



  SplitBody<3>
  circumscribe(const SplitBody<3> &body)
  {
    if (!body.footprint.disc)
      return body;
    const Displacements displacements = necessary_displacements(body);
    SplitBody<3>        result        = body;
    for (const auto &[vertex, displacement] : displacements)
      result.mesh.vertices[vertex] += displacement;
    if (!keep_boundary(displacements, body) ||
        !keep_materials(displacements, body) ||
        !keep_orientation(result.mesh, body.mesh))
      return body;
    for (unsigned int f = 0; f < result.mesh.faces.size(); ++f)
      if (result.conditions[f].is_reached)
        result.conditions[f].is_reached =
          overlaps(result.footprint, result.mesh.corners(result.mesh.faces[f]));
    return result;
  }
} // namespace ElastoPlastic
