// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/exceptions.h"
#include "mesh/disc.h"
#include "mesh/ready_meshes.h"

namespace ElastoPlastic
{
  namespace
  {
    std::vector<double>
    corner_or_default(const std::vector<double> &corner,
                      const unsigned int         dim,
                      const double               default_coordinate)
    {
      return corner.empty() ? std::vector<double>(dim, default_coordinate) :
                              corner;
    }



    /// @p n_steps geometrically growing steps from 0 to @p length, the last
    /// one @p ratio times as long as the first.
    std::vector<double>
    geometric_steps(const double       length,
                    const unsigned int n_steps,
                    const double       ratio)
    {
      std::vector<double> steps(n_steps);
      for (unsigned int i = 0; i < n_steps; ++i)
        steps[i] = n_steps == 1 ?
                     1. :
                     std::pow(ratio, static_cast<double>(i) / (n_steps - 1));
      const double sum = std::accumulate(steps.begin(), steps.end(), 0.);
      for (double &step : steps)
        step *= length / sum;
      return steps;
    }



    /// Steps that are shortest at @p centre and grow by @p ratio on either
    /// side of it. The number of steps is shared out in proportion to the
    /// lengths of the sides.
    std::vector<double>
    steps_around(const double       centre,
                 const double       lower,
                 const double       upper,
                 const unsigned int n_steps,
                 const double       ratio)
    {
      const double exact_share = n_steps * (centre - lower) / (upper - lower);
      unsigned int n_below =
        static_cast<unsigned int>(std::lround(exact_share));
      if (centre > lower && centre < upper)
        n_below = std::clamp(n_below, 1u, n_steps - 1);

      std::vector<double> steps =
        geometric_steps(centre - lower, n_below, ratio);
      std::reverse(steps.begin(), steps.end());
      for (const double step :
           geometric_steps(upper - centre, n_steps - n_below, ratio))
        steps.push_back(step);
      return steps;
    }



    template <int dim>
    BoundaryNames
    boundary_names()
    {
      if constexpr (dim == 2)
        return {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}};
      else
        return {{"left", 0},
                {"right", 1},
                {"front", 2},
                {"back", 3},
                {"bottom", 4},
                {"top", 5}};
    }



    template <typename T>
    [[noreturn]] void
    reject(const std::string    &entry,
           const std::vector<T> &values,
           const std::string    &remedy)
    {
      throw InputError("Geometry/" + entry, values, remedy);
    }



    void
    check_grading(const BoxParameters             &p,
                  const std::vector<double>       &lower,
                  const std::vector<double>       &upper,
                  const std::vector<unsigned int> &n_cells)
    {
      if (p.grading < 1)
        reject("Grading",
               std::vector<double>{p.grading},
               "it must not be less than 1: it is the ratio of the largest to "
               "the smallest cell.");
      if (p.grading_centre.empty())
        return;

      const std::size_t n_horizontal = lower.size() - 1;
      if (p.grading_centre.size() != n_horizontal)
        reject("Grading centre",
               p.grading_centre,
               "it must be empty or have one coordinate per horizontal "
               "direction, that is " +
                 std::to_string(n_horizontal) + ".");
      for (unsigned int d = 0; d < n_horizontal; ++d)
        {
          const double centre = p.grading_centre[d];
          if (centre < lower[d] || centre > upper[d])
            reject("Grading centre",
                   p.grading_centre,
                   "it must lie between 'Lower corner' and 'Upper corner'.");
          if (n_cells[d] < 2 && centre > lower[d] && centre < upper[d])
            reject("Grading centre",
                   p.grading_centre,
                   "a centre inside the box needs at least 2 'Repetitions' in "
                   "each horizontal direction: a mesh line passes through it.");
        }
    }



    void
    check_circle(const BoxParameters &p, const unsigned int dim)
    {
      if (!(p.circle_radius >= 0))
        reject("Circle radius",
               std::vector<double>{p.circle_radius},
               "it must not be negative.");
      if (p.circle_radius > 0 && dim != 3)
        reject("Circle radius",
               std::vector<double>{p.circle_radius},
               "circles are for three dimensions. In two, a line of the coarse "
               "mesh ('Repetitions') can end where a punch does.");
      if (!p.circle_centre.empty() && p.circle_centre.size() != 2)
        reject("Circle centre",
               p.circle_centre,
               "it must be empty or have the two coordinates x, y. " +
                 decimal_point_hint);
    }



    /// The box in space whose top has a circle.
    void
    make_box_with_circle(const BoxParameters                    &p,
                         const std::vector<std::vector<double>> &steps,
                         const Point<3>                         &lower,
                         const Point<3>                         &upper,
                         Triangulation<3>                       &triangulation)
    {
      Disc<2> disc{Point<2>(), p.circle_radius};
      std::copy(p.circle_centre.begin(),
                p.circle_centre.end(),
                &disc.centre[0]);

      Triangulation<2> section;
      GridGenerator::subdivided_hyper_rectangle(section,
                                                {steps[0], steps[1]},
                                                from_above(lower),
                                                from_above(upper),
                                                /* colorize = */ true);
      std::vector<double> heights = {lower[2]};
      for (const double step : steps[2])
        heights.push_back(heights.back() + step);
      heights.back() = upper[2];
      if (!divide_around_circle(disc, section))
        reject(
          "Circle radius",
          std::vector<double>{p.circle_radius},
          "it must be less than the sides of the cells of the coarse mesh "
          "around 'Circle centre', which must be a corner of cells. Choose "
          "fewer 'Repetitions', or another 'Grading'.");
      GridGenerator::extrude_triangulation(section, heights, triangulation);
      follow_circle(disc, triangulation);
    }



    std::vector<unsigned int>
    repetitions_per_direction(const BoxParameters &p, const unsigned int dim)
    {
      return p.repetitions.size() == 1 ?
               std::vector<unsigned int>(dim, p.repetitions.front()) :
               p.repetitions;
    }
  } // namespace



  void
  BoxParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Lower corner",
      lower_corner,
      "Type box: the corner with the smallest coordinates x, y (, z), one per "
      "dimension; empty stands for the origin. Unit: length.",
      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter(
      "Upper corner",
      upper_corner,
      "Type box: the corner with the largest coordinates, each larger than "
      "that of the lower corner; empty stands for all 1. The top, where "
      "contact usually happens, is at its last coordinate. Unit: length.",
      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter(
      "Repetitions",
      repetitions,
      "Type box: how many cells the coarse mesh has in each direction: one "
      "number per dimension, or a single one for all. Allowed: >= 1.",
      Patterns::List(Patterns::Integer(0), 1, 3));
    prm.add_parameter(
      "Grading",
      grading,
      "Type box: how many times higher the lowest cells of the coarse mesh "
      "are than those at the top; the heights in between form a geometric "
      "sequence. 1 stands for cells of equal height. Allowed: >= 1.",
      Patterns::Double());
    prm.add_parameter(
      "Grading centre",
      grading_centre,
      "Type box: horizontal coordinates x (and y) of the point that the cells "
      "also become smaller to horizontally, by the same ratio. Mesh lines "
      "pass through it. Empty stands for equal cells in the horizontal "
      "directions. Unit: length; allowed: inside the box.",
      Patterns::List(Patterns::Double(), 0, 2));
    prm.add_parameter(
      "Circle radius",
      circle_radius,
      "Type box, in three dimensions: the radius of a circle, seen from above, "
      "that edges of cells lie on: the edge of a circular punch. Refinement "
      "follows it. Each cell around the centre becomes five. 0 stands for no "
      "circle. Unit: length; allowed: >= 0, and less than the sides of the "
      "cells of the coarse mesh around the centre.",
      Patterns::Double());
    prm.add_parameter(
      "Circle centre",
      circle_centre,
      "Type box, in three dimensions: the centre x, y of that circle, where "
      "lines of the coarse mesh must meet; empty stands for the origin. Unit: "
      "length.",
      Patterns::List(Patterns::Double(), 0, 2));
  }



  void
  BoxParameters::check(const unsigned int dim) const
  {
    const std::string needed =
      "it must be empty or have " + std::to_string(dim) +
      " coordinates, one per dimension. " + decimal_point_hint;
    if (!lower_corner.empty() && lower_corner.size() != dim)
      reject("Lower corner", lower_corner, needed);
    if (!upper_corner.empty() && upper_corner.size() != dim)
      reject("Upper corner", upper_corner, needed);

    const auto lower = corner_or_default(lower_corner, dim, 0.);
    const auto upper = corner_or_default(upper_corner, dim, 1.);
    for (unsigned int d = 0; d < dim; ++d)
      if (upper[d] <= lower[d])
        reject("Upper corner",
               upper,
               "each of its coordinates must be larger than that of 'Lower "
               "corner', which is '" +
                 Patterns::Tools::to_string(lower) + "'.");

    if (repetitions.size() != 1 && repetitions.size() != dim)
      reject("Repetitions",
             repetitions,
             "it must have one number, or one per dimension, that is " +
               std::to_string(dim) + ".");
    if (*std::min_element(repetitions.begin(), repetitions.end()) == 0)
      reject("Repetitions",
             repetitions,
             "there must be at least one cell in each direction.");
    const auto n_cells = repetitions_per_direction(*this, dim);
    if (std::accumulate(
          n_cells.begin(), n_cells.end(), 1., std::multiplies<>()) > 1e7)
      reject("Repetitions",
             repetitions,
             "each process holds the whole coarse mesh, which cannot have more "
             "than 1e7 cells. Fine meshes are made with 'Initial refinements' "
             "or 'Refinement'.");

    check_grading(*this, lower, upper, n_cells);
    check_circle(*this, dim);
  }



  template <int dim>
  BoundaryNames
  make_box(const BoxParameters &parameters, Triangulation<dim> &triangulation)
  {
    const auto lower   = corner_or_default(parameters.lower_corner, dim, 0.);
    const auto upper   = corner_or_default(parameters.upper_corner, dim, 1.);
    const auto n_cells = repetitions_per_direction(parameters, dim);

    std::vector<std::vector<double>> steps(dim);
    for (unsigned int d = 0; d < dim - 1; ++d)
      steps[d] = parameters.grading_centre.empty() ?
                   geometric_steps(upper[d] - lower[d], n_cells[d], 1.) :
                   steps_around(parameters.grading_centre[d],
                                lower[d],
                                upper[d],
                                n_cells[d],
                                parameters.grading);
    steps.back() = steps_around(upper.back(),
                                lower.back(),
                                upper.back(),
                                n_cells.back(),
                                parameters.grading);

    Point<dim> lower_point, upper_point;
    std::copy(lower.begin(), lower.end(), &lower_point[0]);
    std::copy(upper.begin(), upper.end(), &upper_point[0]);
    if constexpr (dim == 3)
      if (parameters.circle_radius > 0)
        {
          make_box_with_circle(
            parameters, steps, lower_point, upper_point, triangulation);
          return boundary_names<dim>();
        }
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, steps, lower_point, upper_point, /* colorize = */ true);
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_material_id(0); // colours cells, too
    return boundary_names<dim>();
  }



  template BoundaryNames
  make_box(const BoxParameters &, Triangulation<2> &);
  template BoundaryNames
  make_box(const BoxParameters &, Triangulation<3> &);
} // namespace ElastoPlastic
