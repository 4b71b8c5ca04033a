// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/text.h"
#include "evaluation/contact_surface.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string lines_entry = "Output/Profile lines";



    /// @throws InputError
    Point<2>
    read_end_of_line(const std::string &text, const std::string &line)
    {
      const auto parts = split(lines_entry, text, ',');
      Point<2>   point;
      bool       is_point = parts.size() == 2;
      for (unsigned int d = 0; d < 2 && is_point; ++d)
        if (const auto value = as_number(parts[d]); value)
          point[d] = *value;
        else
          is_point = false;
      if (!is_point || !std::isfinite(point.norm()))
        throw InputError(lines_entry,
                         line,
                         "it must look like 'x, y; x, y', the horizontal "
                         "coordinates of both ends of a line, with '|' between "
                         "lines.");
      return point;
    }
  } // namespace



  std::vector<ProfileLine>
  read_profile_lines(const std::string &text, const Point<2> &axis)
  {
    std::vector<ProfileLine> lines;
    for (const std::string &line : split(lines_entry, text, '|'))
      {
        const auto     ends  = split(lines_entry, line, ';');
        const Point<2> begin = read_end_of_line(ends[0], line);
        const Point<2> end =
          read_end_of_line(ends.size() == 2 ? ends[1] : "", line);
        const double length = begin.distance(end);
        if (length == 0.)
          throw InputError(lines_entry, line, "both ends are the same point.");
        lines.push_back({begin, (end - begin) / length, 0., length});
      }
    if (lines.empty())
      lines.push_back({axis, Point<2>::unit_vector(0)});
    return lines;
  }



  namespace
  {
    /// The pairs of neighbouring nodes of a face, of which there are
    /// (degree + 1)^(dim - 1) in lexicographic order.
    template <int dim>
    std::vector<std::array<unsigned int, 2>>
    neighboring_nodes(const unsigned int degree)
    {
      std::vector<std::array<unsigned int, 2>> pairs;
      unsigned int                             stride = 1;
      const unsigned int n = Utilities::pow(degree + 1, dim - 1);
      for (unsigned int d = 0; d < dim - 1; ++d, stride *= degree + 1)
        for (unsigned int i = 0; i < n; ++i)
          if (i / stride % (degree + 1) < degree)
            pairs.push_back({{i, i + stride}});
      return pairs;
    }



    template <int dim>
    SurfacePoint<dim>
    point_between(const SurfacePoint<dim> &a,
                  const SurfacePoint<dim> &b,
                  const double             share)
    {
      const auto between = [share](const auto &x, const auto &y) {
        return (1. - share) * x + share * y;
      };
      return {Point<dim>(between(a.position, b.position)),
              between(a.displacement, b.displacement),
              between(a.gap, b.gap),
              between(a.pressure, b.pressure),
              between(a.active, b.active),
              between(a.shear, b.shear),
              between(a.stick, b.stick)};
    }



    /// The points of all ranks in the order of @p keys, of which those that
    /// agree up to rounding count once.
    template <int dim, typename Key>
    std::vector<SurfacePoint<dim>>
    gather_and_sort(const std::vector<SurfacePoint<dim>> &own_points,
                    const MPI_Comm                        communicator,
                    const Key                            &keys)
    {
      std::vector<SurfacePoint<dim>> points;
      for (const auto &of_rank :
           Utilities::MPI::all_gather(communicator, own_points))
        points.insert(points.end(), of_rank.begin(), of_rank.end());
      std::sort(points.begin(),
                points.end(),
                [&](const auto &a, const auto &b) {
                  return keys(a) < keys(b);
                });
      double size = 0;
      for (const auto &point : points)
        size = std::max(size, point.position.distance(points[0].position));
      points.erase(std::unique(points.begin(),
                               points.end(),
                               [&](const auto &a, const auto &b) {
                                 return a.position.distance(b.position) <=
                                        1e-10 * size;
                               }),
                   points.end());
      return points;
    }



    /// Seen from above.
    Tensor<1, 2>
    offset(const ProfileLine &line, const SurfacePoint<3> &point)
    {
      return Tensor<1, 2>(
        {point.position[0] - line.point[0], point.position[1] - line.point[1]});
    }



    /// Adds where @p line meets the side from @p a to @p b: nowhere, at one
    /// point, or if the side lies in the line, at both ends.
    void
    add_intersections(std::vector<SurfacePoint<3>> &points,
                      const ProfileLine            &line,
                      const SurfacePoint<3>        &a,
                      const SurfacePoint<3>        &b)
    {
      const double tolerance = 1e-8 * a.position.distance(b.position);
      const auto   distance  = [&](const SurfacePoint<3> &point) {
        const double value =
          cross_product_2d(line.direction) * offset(line, point);
        return std::abs(value) <= tolerance ? 0. : value;
      };
      const auto add = [&](const SurfacePoint<3> &point) {
        const double way = offset(line, point) * line.direction;
        if (way >= line.begin - tolerance && way <= line.end + tolerance)
          points.push_back(point);
      };
      const double of_a = distance(a), of_b = distance(b);
      if (of_a == 0.)
        add(a);
      if (of_b == 0.)
        add(b);
      if (of_a * of_b < 0.)
        add(point_between(a, b, of_a / (of_a - of_b)));
    }
  } // namespace



  template <int dim>
  ContactSurface<dim>::ContactSurface(
    const DoFHandler<dim>              &dof_handler,
    const std::set<types::boundary_id> &boundaries,
    const SurfaceFields                &fields)
    : communicator(communicator_of(dof_handler))
    , at_present_place(fields.at_present_place)
  {
    const auto               &fe = dof_handler.get_fe();
    const Quadrature<dim - 1> nodes(
      fe.base_element(0).get_unit_face_support_points());
    const auto to_lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim - 1>(fe.degree);
    const auto                     pairs = neighboring_nodes<dim>(fe.degree);
    FEFaceValues<dim>              values(fe, nodes, update_quadrature_points);
    std::vector<SurfacePoint<dim>> points(nodes.size());
    const bool                     has_friction = fields.shear.size() > 0;
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());

    for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
      {
        values.reinit(cell, f);
        cell->face(f)->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [component, node] = fe.face_system_to_component_index(i);
            auto &point                  = points[to_lexicographic[node]];
            point.displacement[component] = fields.displacement(dofs[i]);
            if (has_friction)
              point.shear[component] = fields.shear(dofs[i]);
            if (component == dim - 1)
              {
                point.position = values.quadrature_point(node);
                point.gap      = fields.gap(dofs[i]);
                point.pressure = fields.pressure(dofs[i]);
                point.active   = fields.active(dofs[i]);
                if (has_friction)
                  point.stick = fields.stick(dofs[i]);
              }
          }
        for (const auto &[begin, end] : pairs)
          sides.push_back({points[begin], points[end]});
      }
  }



  template <int dim>
  std::vector<SurfacePoint<dim>>
  ContactSurface<dim>::nodes() const
  {
    std::vector<SurfacePoint<dim>> ends;
    for (const Side &side : sides)
      for (const auto *const end : {&side.begin, &side.end})
        ends.push_back(*end);
    return gather_and_sort(ends, communicator, [](const auto &point) {
      return std::make_pair(point.position[0], point.position[dim - 1]);
    });
  }



  template <>
  std::vector<SurfacePoint<3>>
  ContactSurface<3>::along(const ProfileLine &line) const
  {
    std::vector<SurfacePoint<3>> points;
    for (const Side &side : sides)
      add_intersections(points, line, side.begin, side.end);
    return gather_and_sort(points, communicator, [&](const auto &point) {
      return offset(line, point) * line.direction;
    });
  }



  template <int dim>
  double
  ContactSurface<dim>::distance_from(const Point<dim - 1>    &axis,
                                     const SurfacePoint<dim> &point) const
  {
    Tensor<1, dim - 1> distance;
    for (unsigned int d = 0; d < dim - 1; ++d)
      distance[d] = point.position[d] - axis[d] +
                    (at_present_place ? point.displacement[d] : 0.);
    return distance.norm();
  }



  template <int dim>
  double
  ContactSurface<dim>::highest(const Point<dim - 1> &axis,
                               const double          distance) const
  {
    double height = -std::numeric_limits<double>::infinity();
    for (const Side &side : sides)
      for (const auto *const end : {&side.begin, &side.end})
        if (distance_from(axis, *end) <= distance)
          height = std::max(height, end->displacement[dim - 1]);
    return Utilities::MPI::max(height, communicator);
  }



  template <int dim>
  double
  ContactSurface<dim>::height_of_edge(const Point<dim - 1> &axis,
                                      const double          distance) const
  {
    double sum = 0;
    double n   = 0;
    for (const Side &side : sides)
      if ((side.begin.active == 1.) != (side.end.active == 1.))
        {
          const double begin = distance_from(axis, side.begin);
          const double end   = distance_from(axis, side.end);
          const double share =
            begin == end ? 0.5 : (distance - begin) / (end - begin);
          sum += point_between(side.begin,
                               side.end,
                               std::max(0., std::min(share, 1.)))
                   .displacement[dim - 1];
          n += 1.;
        }
    n = Utilities::MPI::sum(n, communicator);
    return n > 0. ? Utilities::MPI::sum(sum, communicator) / n : 0.;
  }



  template class ContactSurface<2>;
  template class ContactSurface<3>;
} // namespace ElastoPlastic
