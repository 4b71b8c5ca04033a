// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Indenters read from STL files: text and binary, heights, slopes and sections
// against a pyramid, the lowest of several triangles, and what is refused. The
// files are written into the working directory first.

#include <deal.II/base/mpi.h>

#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "indenter/height_file.h"
#include "indenter/indenter_parameters.h"
#include "refusal.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  void
  write(const std::string &name, const std::string &content)
  {
    std::ofstream(name, std::ios::binary) << content;
  }



  std::string
  text_of(const std::vector<Facet> &facets)
  {
    std::ostringstream text;
    text << "solid a tip\n";
    for (const Facet &facet : facets)
      {
        text << "facet normal 0 0 0\n outer loop\n";
        for (const Point<3> &corner : facet)
          text << "  vertex " << corner << '\n';
        text << " endloop\nendfacet\n";
      }
    text << "endsolid a tip\n";
    return text.str();
  }



  std::string
  in_large_letters(std::string text)
  {
    for (char &c : text)
      c = std::toupper(c);
    return text;
  }



  std::string
  binary_of(const std::vector<Facet> &facets)
  {
    std::string bytes = "solid, but binary";
    bytes.resize(80, ' ');
    const auto append = [&bytes](const auto number) {
      char raw[sizeof(number)];
      std::memcpy(raw, &number, sizeof(number));
      bytes.append(raw, sizeof(number));
    };
    append(std::uint32_t(facets.size()));
    for (const Facet &facet : facets)
      {
        bytes.append(12, '\0');
        for (const Point<3> &corner : facet)
          for (unsigned int d = 0; d < 3; ++d)
            append(float(corner[d]));
        bytes.append(2, '\0');
      }
    return bytes;
  }



  /// A closed pyramid upside down: four faces of slope 1/2 up to the height 2,
  /// where a square of half width 4 covers it; the tip is at z = -1. With a
  /// vertical triangle.
  std::vector<Facet>
  pyramid()
  {
    const Point<3>              tip(0, 0, -1);
    const std::vector<Point<3>> corners = {{4, -4, 1},
                                           {4, 4, 1},
                                           {-4, 4, 1},
                                           {-4, -4, 1}};
    std::vector<Facet>          facets;
    for (unsigned int i = 0; i < 4; ++i)
      facets.push_back({{tip, corners[(i + 1) % 4], corners[i]}});
    facets.push_back({{corners[0], corners[1], corners[2]}});
    facets.push_back({{corners[0], corners[2], corners[3]}});
    facets.push_back({{tip, tip + Point<3>(0, 0, 1), tip + Point<3>(1, 0, 1)}});
    return facets;
  }



  std::vector<Facet>
  moved(std::vector<Facet> facets, const Tensor<1, 3> &motion)
  {
    for (Facet &facet : facets)
      for (Point<3> &corner : facet)
        corner += motion;
    return facets;
  }



  IndenterParameters
  stl(const std::string &file)
  {
    IndenterParameters parameters;
    parameters.type = "STL surface";
    parameters.file = file;
    return parameters;
  }



  void
  print(const std::string &name, const IndenterSurface<3> &surface)
  {
    output() << "  " << name << ": " << surface.height << " | "
             << surface.slope + Tensor<1, 2>() << " | " << surface.curvature
             << std::endl;
  }



  void
  check_pyramid(const std::string &file, const double scale)
  {
    output() << file << ", scale " << scale << std::endl;
    IndenterParameters parameters = stl(file);
    parameters.length_scale       = scale;
    const auto indenter           = make_indenter<3>(parameters).shape;
    print("face", indenter->surface(scale * Point<2>(3., 1.)));
    print("face", indenter->surface(scale * Point<2>(-0.5, -3.)));
    print("edge", indenter->surface(scale * Point<2>(1., 4.)));
    output() << "  tip: " << indenter->profile(Point<2>()) << std::endl;
    print("beside", indenter->surface(scale * Point<2>(4.001, 0.)));
    for (const double height : {0.5, 2.})
      verify("  section",
             std::abs(indenter->section_area(scale * height) / scale / scale -
                      16 * height * height),
             1e-12);
    const auto plane = make_indenter<2>(parameters).shape;
    output() << "  plane: " << plane->profile(Point<1>(-3. * scale)) << ' '
             << plane->surface(Point<1>(-3. * scale)).slope << std::endl;
    verify("  its section",
           std::abs(plane->section_area(scale) / scale / scale -
                    numbers::PI * 4),
           1e-12);
  }



  /// A square face whose half width of 1/2 has lost its last digits.
  void
  check_rounded_edges()
  {
    const double             a      = 0.4999999;
    const Point<3>           corner = {a, a, 0}, opposite = {-a, -a, 0};
    const std::vector<Facet> face = {{{corner, opposite, {a, -a, 0}}},
                                     {{corner, opposite, {-a, a, 0}}}};
    write("face.stl", text_of(face));
    const auto indenter = make_indenter<3>(stl("face.stl")).shape;
    verify("edges of a face",
           indenter->profile({0.5, 0.5}) == 0. &&
             indenter->profile({-0.5, 0.1}) == 0. &&
             std::isinf(indenter->profile({0.50001, 0.1})));
  }



  void
  refuse(const std::string &name, const std::string &content)
  {
    write(name, content);
    output() << "  " << refusal([&]() { make_indenter<3>(stl(name)); })
             << std::endl;
  }



  std::string
  replaced(std::string text, const std::string &old, const std::string &by)
  {
    return text.replace(text.find(old), old.size(), by);
  }



  void
  check_errors()
  {
    output() << "Refused" << std::endl;
    const std::string text   = text_of(pyramid());
    const std::string binary = binary_of(pyramid());
    refuse("empty.stl", "");
    refuse("other.stl", "ply\nformat ascii 1.0\n");
    refuse("truncated.stl", text.substr(0, 400));
    refuse("unfinished.stl", text.substr(0, text.rfind("endsolid")));
    refuse("comma.stl", replaced(text, "4 4 1", "4,0 4 1"));
    refuse("infinite.stl", replaced(text, "4 4 1", "4 inf 1"));
    refuse("quadrilateral.stl", replaced(text, "endloop", "vertex 1 2 3"));
    refuse("no_outer.stl", replaced(text, "outer", "inner"));
    refuse("far.stl", text_of(moved(pyramid(), Point<3>(0, 1e5, 0))));
    refuse("no_facets.stl", "solid\nendsolid\n");
    refuse("vertical.stl",
           text_of(
             {{{Point<3>(0, 0, 0), Point<3>(1, 1, 0), Point<3>(2, 2, 5)}}}));
    refuse("short_binary.stl", binary.substr(0, binary.size() - 1));
    refuse("infinite_binary.stl",
           binary.substr(0, 96) + "\xff\xff\xff\xff" + binary.substr(100));
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  write("text.stl", text_of(pyramid()));
  write("two_solids.stl", text_of(pyramid()) + text_of(pyramid()));
  write("binary.stl", binary_of(pyramid()));
  check_pyramid("text.stl", 1);
  check_pyramid("binary.stl", 0.25);
  verify("two solids",
         make_indenter<3>(stl("two_solids.stl")).shape->profile({1., 3.}) ==
           1.5);
  write("large_letters.stl", in_large_letters(text_of(pyramid())));
  verify("large letters",
         make_indenter<3>(stl("large_letters.stl")).shape->profile({1., 3.}) ==
           1.5);
  check_rounded_edges();
  check_errors();
}
