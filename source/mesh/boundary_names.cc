// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/exceptions.h"
#include "base/expression.h"
#include "base/text.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  namespace
  {
    /// "name: boundary; condition".
    struct PartText
    {
      std::string name, boundary, condition;
    };



    // The name of a boundary may contain colons, and an expression none.
    PartText
    read_part(const std::string &path, const std::string &text)
    {
      const std::size_t colon = text.find(':'), semicolon = text.rfind(';');
      if (colon == std::string::npos || semicolon == std::string::npos ||
          semicolon < colon)
        throw InputError(path,
                         text,
                         "it must look like 'name: boundary; condition', for "
                         "instance 'surcharge: top; x > 1', with '|' between "
                         "parts.");
      return {Utilities::trim(text.substr(0, colon)),
              Utilities::trim(text.substr(colon + 1, semicolon - colon - 1)),
              Utilities::trim(text.substr(semicolon + 1))};
    }



    /// Points that are spread over a face with these corners, none of them on
    /// its edges, where parts may meet.
    template <int dim, typename Face>
    std::vector<Point<dim>>
    points_inside(const Face &face)
    {
      constexpr unsigned int n_intervals = 16;
      constexpr double       inset       = 1e-6;

      std::vector<Point<1>> along;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        along.emplace_back(
          std::clamp(i / double(n_intervals), inset, 1. - inset));
      const Quadrature<1>       line(along);
      const Quadrature<dim - 1> lattice(line);

      std::vector<Point<dim>> points;
      for (const Point<dim - 1> &point : lattice.get_points())
        {
          Point<dim> x;
          for (const unsigned int v : face->vertex_indices())
            x += GeometryInfo<dim - 1>::d_linear_shape_function(point, v) *
                 face->vertex(v);
          points.push_back(x);
        }
      return points;
    }



    /// Whether a face is in the part where @p condition is not zero.
    template <int dim, typename Face>
    bool
    is_in_part(const std::string     &path,
               const std::string     &text,
               const Expression<dim> &condition,
               const Face            &face)
    {
      const auto points = points_inside<dim>(face);
      const bool first  = condition.value(points.front()) != 0.;
      for (const Point<dim> &point : points)
        if ((condition.value(point) != 0.) != first)
          {
            std::ostringstream remedy;
            remedy << "the part ends within a side of a cell of the coarse "
                      "mesh, near the point ("
                   << face->center()
                   << "). Let it end between cells as they are before 'Initial "
                      "refinements': move it, or the cells, for instance with "
                      "'Repetitions'.";
            throw InputError(path, text, remedy.str());
          }
      return first;
    }



    types::boundary_id
    first_unused_id(const BoundaryNames &names)
    {
      types::boundary_id id = 0;
      while (
        std::any_of(names.begin(), names.end(), [id](const auto &boundary) {
          return boundary.second == id;
        }))
        ++id;
      return id;
    }



    template <int dim>
    void
    name_boundary_part(const std::string  &path,
                       const std::string  &text,
                       Triangulation<dim> &coarse_mesh,
                       BoundaryNames      &names)
    {
      const PartText part  = read_part(path, text);
      const auto     whole = names.find(part.boundary);
      if (whole == names.end())
        throw InputError(path,
                         text,
                         "there is no boundary '" + part.boundary +
                           "'. The geometry has: " + list_of_names(names) +
                           ".");
      if (part.name.empty() || names.count(part.name) > 0 ||
          part.name.find(',') != std::string::npos)
        throw InputError(path,
                         text,
                         "the part needs a name that no boundary has, and "
                         "without ','. The geometry has: " +
                           list_of_names(names) + ".");
      const Expression<dim>    condition(path,
                                      part.condition,
                                      ExpressionVariables::position);
      const types::boundary_id id        = first_unused_id(names);
      bool                     has_faces = false, leaves_faces = false;
      for (const auto &cell : coarse_mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == whole->second)
            {
              const bool is_in = is_in_part(path, text, condition, face);
              has_faces |= is_in;
              leaves_faces |= !is_in;
              if (is_in)
                face->set_boundary_id(id);
            }
      if (!has_faces || !leaves_faces)
        throw InputError(path,
                         text,
                         std::string("the condition holds ") +
                           (has_faces ? "everywhere" : "nowhere") + " on '" +
                           part.boundary +
                           "'. A part is where it holds, and the rest keeps "
                           "the name of the boundary.");
      names.emplace(part.name, id);
    }
  } // namespace



  template <int dim>
  void
  name_boundary_parts(const std::string  &path,
                      const std::string  &text,
                      Triangulation<dim> &coarse_mesh,
                      BoundaryNames      &names)
  {
    for (const std::string &part : split(path, text, '|'))
      name_boundary_part(path, part, coarse_mesh, names);
  }



  template void
  name_boundary_parts(const std::string &,
                      const std::string &,
                      Triangulation<2> &,
                      BoundaryNames &);
  template void
  name_boundary_parts(const std::string &,
                      const std::string &,
                      Triangulation<3> &,
                      BoundaryNames &);
} // namespace ElastoPlastic
