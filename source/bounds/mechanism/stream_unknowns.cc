// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>

#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/stream_unknowns.h"

namespace ElastoPlastic
{
  StreamUnknowns::StreamUnknowns(const SplitBody<2> &body)
    : body(body)
    , first_on_sides(body.mesh.vertices.size())
    , first_inside(first_on_sides + 2 * body.mesh.faces.size())
    , first_flux(first_inside + body.mesh.simplices.size())
    , first_velocity(first_flux + body.mesh.vertices.size())
    , zero(first_velocity + 3 * body.mesh.faces.size())
    , vertex_has_flux(body.mesh.vertices.size(), body.is_axisymmetric())
  {
    find_flux();
    number();
  }



  void
  StreamUnknowns::find_flux()
  {
    const auto is_on_axis = [this](const unsigned int v) {
      return body.is_on_axis(body.mesh.vertices[v]);
    };
    for (const auto &triangle : body.mesh.simplices)
      if (std::any_of(triangle.vertices.begin(),
                      triangle.vertices.end(),
                      is_on_axis))
        for (const unsigned int v : triangle.vertices)
          vertex_has_flux[v] = false;
  }



  bool
  StreamUnknowns::has_flux(const unsigned int t) const
  {
    const auto &vertices = body.mesh.simplices[t].vertices;
    return std::any_of(vertices.begin(),
                       vertices.end(),
                       [this](const unsigned int v) {
                         return vertex_has_flux[v];
                       });
  }



  unsigned int
  StreamUnknowns::cubic(const unsigned int s,
                        const unsigned int first_vertex,
                        const unsigned int i) const
  {
    const auto        &vertices = body.mesh.faces[s].vertices;
    const unsigned int k        = vertices[0] == first_vertex ? i : 3 - i;
    return k == 0 ? vertices[0] :
           k == 3 ? vertices[1] :
                    first_on_sides + 2 * s + k - 1;
  }



  // r^2 chi is constant along a side with chi if r is, and else only if it
  // vanishes.
  void
  StreamUnknowns::close_side(Sets &sets, const unsigned int s) const
  {
    const auto    &vertices = body.mesh.faces[s].vertices;
    const Point<2> a        = body.mesh.vertices[vertices[0]],
                   b        = body.mesh.vertices[vertices[1]];
    if (body.is_on_axis(a) && body.is_on_axis(b))
      return;
    const bool varies = std::abs(body.weight(a) - body.weight(b)) >
                        Tolerance::on_axis * a.distance(b);
    for (unsigned int i = 0; i < 4; ++i)
      sets.union_set(cubic(s, vertices[0], i), varies ? zero : vertices[0]);
    sets.union_set(first_flux + vertices[0], first_flux + vertices[1]);
  }



  void
  StreamUnknowns::number()
  {
    Sets sets(zero + 1);
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      {
        if (body.support_of(s).is_closed)
          close_side(sets, s);
        if (!body.mesh.faces[s].is_inside())
          for (unsigned int i = 0; i < 3; ++i)
            sets.union_set(first_velocity + 3 * s + i, zero);
      }
    bool is_known = false;
    for (unsigned int v = 0; v < vertex_has_flux.size(); ++v)
      if (!vertex_has_flux[v])
        {
          sets.union_set(first_flux + v, zero);
          is_known = body.is_axisymmetric();
        }
    if (!is_known)
      sets.union_set(body.is_axisymmetric() ? first_flux : 0, zero);

    std::map<unsigned int, unsigned int> of_sets;
    for (unsigned int i = 0; i < zero; ++i)
      {
        const unsigned int set = sets.find_set(i);
        numbering.push_back(
          set == sets.find_set(zero) ?
            numbers::invalid_unsigned_int :
            of_sets.try_emplace(set, of_sets.size()).first->second);
      }
    n_unknowns = of_sets.size();
  }



  std::vector<unsigned int>
  StreamUnknowns::on_triangle(const unsigned int t) const
  {
    const auto               &triangle = body.mesh.simplices[t];
    std::vector<unsigned int> unknowns(triangle.vertices.begin(),
                                       triangle.vertices.end());
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int i = 1; i < 3; ++i)
        unknowns.push_back(cubic(triangle.faces[k], triangle.vertices[k], i));
    unknowns.push_back(first_inside + t);
    if (has_flux(t))
      for (const unsigned int v : triangle.vertices)
        unknowns.push_back(first_flux + v);
    for (unsigned int k = 0; k < 3; ++k)
      {
        const unsigned int s = triangle.faces[k];
        const bool         same_direction =
          body.mesh.faces[s].vertices[0] == triangle.vertices[k];
        for (unsigned int i = 0; i < 3; ++i)
          unknowns.push_back(first_velocity + 3 * s +
                             (same_direction ? i : 2 - i));
      }
    for (unsigned int &unknown : unknowns)
      unknown = numbering[unknown];
    return unknowns;
  }
} // namespace ElastoPlastic
