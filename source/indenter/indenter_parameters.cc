// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/exceptions.h"
#include "indenter/indenter_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    add_shape(IndenterParameters &p, ParameterHandler &prm)
    {
      prm.add_parameter(
        "Type",
        p.type,
        "The shape of the rigid indenter. Sphere, paraboloid, cone, "
        "spheroconical tip, area function and circular "
        "punch are axisymmetric bodies; cylinder, wedge and strip punch have "
        "their axis along y. In two dimensions each shape is its section y = 0, "
        "so that cone and wedge, for instance, are the same there. 'expression', "
        "'image', 'height matrix' and 'STL surface' read the entries that name them "
        "below; 'none' "
        "is a body without contact.",
        Patterns::Selection(indenter_types()));
      prm.add_parameter(
        "Radius",
        p.radius,
        "Radius of sphere, cylinder and circular punch, and of the spherical cap "
        "of a spheroconical tip; radius of curvature R of "
        "the paraboloid, whose profile is r^2/(2R). Sphere and cylinder are true "
        "circles and end at this radius; the cap ends where it is tangent to the "
        "cone. Unit: length, > 0.",
        Patterns::Double());
      prm.add_parameter(
        "Semi-apex angle",
        p.semi_apex_angle,
        "Angle between axis and flank of cone, wedge and spheroconical tip; the "
        "profile of the first two is r/tan(angle). The default is the cone that displaces the same volume as "
        "Berkovich's pyramid. Unit: degrees, between 0 and 90, both excluded.",
        Patterns::Double());
      prm.add_parameter(
        "Half width",
        p.half_widths,
        "Half the width of the face: one value for a strip punch, one per "
        "horizontal direction (x, y) for a rectangular punch. Unit: length, > 0.",
        Patterns::List(Patterns::Double(), 1, 2));
      prm.add_parameter(
        "Area coefficients",
        p.area_coefficients,
        "C0, C1, C2, ... of the type 'area function', a calibrated tip: the body "
        "of revolution whose section at the height h above its lowest point has "
        "the area C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ..., up to "
        "h^(1/128). The area must grow with h, from h = 0 on. The default is "
        "the ideal pyramid of Berkovich or Vickers. Units: area over the power "
        "of the length.",
        Patterns::List(Patterns::Double(), 1, 9));
      prm.add_parameter(
        "Expression",
        p.expression,
        "The profile of the type 'expression': the height above the tip as a "
        "function of the horizontal coordinates x and y relative to 'Position' "
        "(y is 0 in two dimensions). It is used as typed: if its smallest value "
        "is not 0, the indenter does not just touch at 'Initial gap = 0'. It must "
        "be finite within 'Reach'. Its slope and curvature are difference "
        "quotients over 1e-4 of 'Reach', or 1e-5 of the body's size if that is "
        "smaller or there is no reach. Unit: length.",
        Patterns::Anything());
    }



    void
    add_pyramid(IndenterParameters &p, ParameterHandler &prm)
    {
      prm.add_parameter(
        "Number of faces",
        p.n_faces,
        "Of the type 'pyramid', which is regular and exists in three dimensions "
        "only. 4 for that of Vickers, 3 for that of Berkovich and the corner of "
        "a cube. Allowed: >= 3.",
        Patterns::Integer(3));
      prm.add_parameter(
        "Face angle",
        p.face_angle,
        "Angle between axis and faces of the pyramid: 68 for that of Vickers, "
        "65.27 for the modified one of Berkovich, which has the same area as "
        "Vickers' (65.03 for his original one), 35.2644 for the corner of a "
        "cube. Unit: degrees, between 0 and 90, both excluded.",
        Patterns::Double());
      prm.add_parameter(
        "Rotation",
        p.rotation,
        "From the x axis to the direction in which a face of the pyramid looks, "
        "about the vertical axis. With 0, y = 0 is a plane of symmetry, and x = "
        "0 is one if the number of faces is even. Unit: degrees, between -360 and "
        "360.",
        Patterns::Double());
      prm.add_parameter(
        "Rounding radius",
        p.rounding_radius,
        "Radius of a ball that rounds the tip of the pyramid, and its edges as "
        "well: the pyramid is what the ball reaches from inside, tangent to the "
        "faces. 0 stands for a sharp pyramid. Unit: length, >= 0.",
        Patterns::Double());
      prm.add_parameter(
        "Truncation",
        p.truncation,
        "The height that is cut off the sharp tip of the pyramid, which leaves a "
        "flat face. Not together with 'Rounding radius'. Unit: length, >= 0.",
        Patterns::Double());
    }



    void
    add_height_map(IndenterParameters &p, ParameterHandler &prm)
    {
      prm.add_parameter(
        "File",
        p.file,
        "The file of the types 'image', 'height matrix' and 'STL surface'. An image is a PNG of "
        "any kind (colours become grey, transparency is ignored), a PGM or a PBM, "
        "up to 16 bit. A matrix is a text of numbers separated by white space or "
        "commas, one row per line, '#' begins a comment; the first row has the "
        "largest y, like the top of an image. In two dimensions there is one row "
        "only. Heights are linear between the centres of the pixels and shifted so "
        "that the lowest is 0. An STL surface, text or binary, consists of up to "
        "2*10^6 triangles; its z axis points up, its origin, moved up or down to "
        "the lowest corner, comes to 'Position', and the lowest triangle "
        "above a point counts; triangles of the upper side do no harm. In two "
        "dimensions it is cut at y = 0. A relative name starts in the folder of the parameter file.",
        Patterns::Anything());
      prm.add_parameter(
        "Size",
        p.size,
        "Extent of the image or matrix along x (and y), from the centre of the "
        "first to that of the last pixel; its middle is at 'Position', and outside "
        "there is no indenter. Unit: length, each > 0.",
        Patterns::List(Patterns::Double(), 0, 2));
      prm.add_parameter(
        "Height scale",
        p.height_scale,
        "Difference in height between black and white for an image (unit: "
        "length), factor on the numbers of a height matrix. Allowed: > 0.",
        Patterns::Double());
      prm.add_parameter(
        "Length scale",
        p.length_scale,
        "Factor on the coordinates of an STL surface, such as 0.001 to make "
        "metres of millimetres. Allowed: > 0.",
        Patterns::Double());
      prm.add_parameter(
        "Side down",
        p.side_down,
        "What touches first: the dark or the light parts of an image, the low "
        "('dark') or the high ('light') values of a height matrix.");
    }



    void
    add_place(IndenterParameters &p, ParameterHandler &prm)
    {
      prm.add_parameter(
        "Position",
        p.position,
        "Horizontal coordinates x (and y) of the tip or of the middle of the face; "
        "empty stands for the origin. Unit: length.",
        Patterns::List(Patterns::Double(), 0, 2));
      prm.add_parameter(
        "Initial gap",
        p.initial_gap,
        "How far the undisplaced indenter is above the top surface. Unit: length, "
        ">= 0.",
        Patterns::Double());
      prm.add_parameter(
        "Reach",
        p.reach,
        "Contact is looked for only within this horizontal distance from "
        "'Position'; 0 stands for as far as the shape goes. Unit: length, >= 0.",
        Patterns::Double());
      prm.add_parameter(
        "Surface",
        p.surface,
        "For 'Analysis = limit load': along a smooth indenter the body slides "
        "without shear stress, on a rough one it does not slide unless it "
        "yields. The other analyses have 'Contact/Friction coefficient'.");
    }

    template <typename T>
    void
    require(const bool         condition,
            const std::string &entry,
            const T           &value,
            const std::string &remedy)
    {
      if (!condition)
        throw InputError("Indenter/" + entry, value, remedy);
    }



    bool
    all_positive(const std::vector<double> &values)
    {
      return std::all_of(values.begin(), values.end(), [](const double value) {
        return value > 0;
      });
    }
  } // namespace



  void
  IndenterParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Indenter");
    add_shape(*this, prm);
    add_pyramid(*this, prm);
    add_height_map(*this, prm);
    add_place(*this, prm);
    prm.leave_subsection();
  }



  void
  IndenterParameters::check_pyramid() const
  {
    require(face_angle > 0 && face_angle < 90,
            "Face angle",
            face_angle,
            "it must lie between 0 and 90 degrees, both excluded.");
    require(rounding_radius >= 0,
            "Rounding radius",
            rounding_radius,
            "it must not be negative; 0 stands for a sharp pyramid.");
    require(std::abs(rotation) <= 360,
            "Rotation",
            rotation,
            "it must lie between -360 and 360 degrees.");
    require(truncation >= 0,
            "Truncation",
            truncation,
            "it must not be negative; 0 stands for a sharp pyramid.");
    require(truncation == 0 || rounding_radius == 0,
            "Truncation",
            truncation,
            "'Rounding radius' rounds the tip already. Leave one of the two at "
            "0.");
  }



  void
  IndenterParameters::check(const unsigned int dim) const
  {
    require(radius > 0, "Radius", radius, "it must be greater than 0.");
    require(semi_apex_angle > 0 && semi_apex_angle < 90,
            "Semi-apex angle",
            semi_apex_angle,
            "it must lie between 0 and 90 degrees, both excluded. A flat face "
            "is a punch.");
    check_pyramid();
    require(all_positive(half_widths),
            "Half width",
            half_widths,
            "it must be greater than 0.");
    require(all_positive(size), "Size", size, "it must be greater than 0.");
    require(height_scale > 0,
            "Height scale",
            height_scale,
            "it must be greater than 0. To turn the indenter upside down, "
            "change 'Side down'.");
    require(length_scale > 0,
            "Length scale",
            length_scale,
            "it must be greater than 0.");
    require(initial_gap >= 0,
            "Initial gap",
            initial_gap,
            "it must not be negative: the undisplaced indenter stays outside "
            "the body. Push it in with the entries of 'Loading'.");
    require(reach >= 0,
            "Reach",
            reach,
            "it must not be negative; 0 stands for as far as the shape goes.");
    require(position.empty() || position.size() == dim - 1,
            "Position",
            position,
            "in " + std::to_string(dim) + " dimensions it must be empty or " +
              "hold one coordinate per horizontal direction (" +
              (dim == 2 ? "x" : "x, y") + "). " + decimal_point_hint);
  }
} // namespace ElastoPlastic
