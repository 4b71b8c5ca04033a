// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "base/exceptions.h"
#include "indenter/height_file.h"
#include "indenter/indenter_height_map.h"
#include "indenter/indenter_parameters.h"
#include "indenter/indenter_shapes.h"
#include "indenter/indenter_stl_surface.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Pointer = std::unique_ptr<Indenter<dim>>;



    /// @throws InputError if the list is not of the length that a shape needs.
    void
    require_length(const std::string         &entry,
                   const std::vector<double> &values,
                   const unsigned int         length,
                   const std::string         &remedy)
    {
      if (values.size() != length)
        throw InputError("Indenter/" + entry, values, remedy);
    }



    template <int dim>
    std::string
    one_per_direction(const std::string &what)
    {
      return "in " + std::to_string(dim) + " dimensions " + what +
             " per horizontal direction (" + (dim == 2 ? "x" : "x, y") + ").";
    }



    double
    reach_of(const IndenterParameters &p)
    {
      return p.reach > 0 ? p.reach : std::numeric_limits<double>::infinity();
    }



    template <int dim>
    Pointer<dim>
    expression(const IndenterParameters &p)
    {
      return std::make_unique<IndenterExpression<dim>>("Indenter/Expression",
                                                       p.expression,
                                                       reach_of(p));
    }



    template <int dim>
    Pointer<dim>
    revolve(const Section &section)
    {
      return std::make_unique<IndenterSymmetric<dim>>(Symmetry::revolution,
                                                      section);
    }



    template <int dim>
    Pointer<dim>
    extrude(const Section &section)
    {
      return std::make_unique<IndenterSymmetric<dim>>(Symmetry::translation,
                                                      section);
    }



    template <int dim>
    Pointer<dim>
    height_map(
      const IndenterParameters                                  &p,
      const std::function<Table<2, double>(const HeightFile &)> &decode)
    {
      require_length("Size",
                     p.size,
                     dim - 1,
                     one_per_direction<dim>(
                       "an image or a height matrix needs one extent"));
      const HeightFile       file("Indenter/File", p.file);
      const Table<2, double> heights = decode(file);
      if (dim == 2 && heights.n_rows() != 1)
        file.reject("it has " + std::to_string(heights.n_rows()) +
                    " rows. In two dimensions an indenter has a single one.");
      if (heights.n_cols() < 2 || (dim == 3 && heights.n_rows() < 2))
        file.reject("it has " + std::to_string(heights.n_rows()) + " x " +
                    std::to_string(heights.n_cols()) +
                    " heights (rows x columns). An indenter needs at least " +
                    (dim == 2 ? "1 x 2." : "2 x 2."));

      const double sign = (p.side_down == SideDown::light ? -1 : 1);
      return std::make_unique<IndenterHeightMap<dim>>(heights,
                                                      sign * p.height_scale,
                                                      p.size);
    }



    template <int dim>
    Pointer<dim>
    stl_surface(const IndenterParameters &p)
    {
      std::vector<Facet> facets =
        decode_stl(HeightFile("Indenter/File", p.file));
      for (Facet &facet : facets)
        for (Point<3> &corner : facet)
          corner *= p.length_scale;
      return std::make_unique<IndenterStlSurface<dim>>(facets);
    }



    template <int dim>
    Pointer<dim>
    strip_punch(const IndenterParameters &p)
    {
      require_length("Half width",
                     p.half_widths,
                     1,
                     "a strip punch has a single half width, that along x. " +
                       decimal_point_hint);
      return extrude<dim>(Sections::face(p.half_widths.front()));
    }



    template <int dim>
    Pointer<dim>
    rectangular_punch(const IndenterParameters &p)
    {
      require_length("Half width",
                     p.half_widths,
                     dim - 1,
                     one_per_direction<dim>(
                       "a rectangular punch needs one half width"));
      return std::make_unique<IndenterRectangularPunch<dim>>(p.half_widths);
    }



    template <int dim>
    Pointer<dim>
    pyramid(const IndenterParameters &p)
    {
      PyramidShape shape;
      shape.n_faces         = p.n_faces;
      shape.face_angle      = p.face_angle;
      shape.rotation        = p.rotation;
      shape.rounding_radius = p.rounding_radius;
      shape.truncation      = p.truncation;
      if constexpr (dim == 3)
        return make_pyramid(shape);
      else
        throw InputError(
          "Indenter/Type",
          p.type,
          "in two dimensions there are no pyramids. The cone that displaces the "
          "same volume is 'Type = cone' with 'Semi-apex angle = " +
            Patterns::Tools::to_string(semi_apex_angle_of_cone(shape)) + "'.");
    }



    template <int dim>
    Pointer<dim>
    area_function(const IndenterParameters &p)
    {
      const AreaFunction area(p.area_coefficients);
      if (const auto height = area.height_of_decrease())
        throw InputError("Indenter/Area coefficients",
                         p.area_coefficients,
                         "the section of the tip must grow with the height "
                         "above it, which it does not at the height " +
                           Patterns::Tools::to_string(*height) +
                           ". Fit fewer coefficients, or none below 0. " +
                           decimal_point_hint);
      return revolve<dim>(Sections::of_area(area));
    }



    /// A shape: the name a user types and what it stands for.
    template <int dim>
    using Shape =
      std::pair<std::string,
                std::function<Pointer<dim>(const IndenterParameters &)>>;



    /// The list of all indenters. A new shape is a section or a class derived
    /// from Indenter, and a line here.
    template <int dim>
    const std::vector<Shape<dim>> &
    shapes()
    {
      using P = IndenterParameters;
      using namespace Sections;

      // clang-format off
      static const std::vector<Shape<dim>> list = {
        {"sphere",            [](const P &p) { return revolve<dim>(circle(p.radius)); }},
        {"paraboloid",        [](const P &p) { return revolve<dim>(parabola(p.radius)); }},
        {"cylinder",          [](const P &p) { return extrude<dim>(circle(p.radius)); }},
        {"cone",              [](const P &p) { return revolve<dim>(flank(p.semi_apex_angle)); }},
        {"wedge",             [](const P &p) { return extrude<dim>(flank(p.semi_apex_angle)); }},
        {"circular punch",    [](const P &p) { return revolve<dim>(face(p.radius)); }},
        {"spheroconical tip", [](const P &p) { return revolve<dim>(spheroconical(p.radius, p.semi_apex_angle)); }},
        {"pyramid",           pyramid<dim>},
        {"area function",     area_function<dim>},
        {"strip punch",       strip_punch<dim>},
        {"rectangular punch", rectangular_punch<dim>},
        {"expression",        expression<dim>},
        {"image",             [](const P &p) { return height_map<dim>(p, decode_image); }},
        {"height matrix",     [](const P &p) { return height_map<dim>(p, decode_matrix); }},
        {"STL surface",       stl_surface<dim>},
        {"none",              [](const P &) { return nullptr; }}};
      // clang-format on
      return list;
    }
  } // namespace



  std::string
  indenter_types()
  {
    std::string types;
    for (const auto &[name, make] : shapes<3>())
      types += (types.empty() ? "" : "|") + name;
    return types;
  }



  template <int dim>
  PlacedIndenter<dim>
  make_indenter(const IndenterParameters &parameters)
  {
    PlacedIndenter<dim> indenter;
    for (const auto &[name, make] : shapes<dim>())
      if (name == parameters.type)
        indenter.shape = make(parameters);
    for (unsigned int d = 0; d < parameters.position.size(); ++d)
      indenter.position[d] = parameters.position[d];
    indenter.initial_gap = parameters.initial_gap;
    indenter.reach       = reach_of(parameters);
    return indenter;
  }



  template PlacedIndenter<2>
  make_indenter(const IndenterParameters &);
  template PlacedIndenter<3>
  make_indenter(const IndenterParameters &);
} // namespace ElastoPlastic
