// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "evaluation/imprint.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    SurfaceRow
    surface_row(const SolveResult       &result,
                const unsigned int       line,
                const SurfacePoint<dim> &point)
    {
      SurfaceRow row;
      row.step = result.step;
      row.time = result.time;
      row.line = line;
      for (unsigned int d = 0; d < dim; ++d)
        {
          row.position[d]      = point.position[d];
          row.displacement[d]  = point.displacement[d];
          row.contact_shear[d] = point.shear[d];
        }
      row.gap              = point.gap;
      row.contact_pressure = point.pressure;
      row.stick            = point.stick;
      return row;
    }
  } // namespace



  template <int dim>
  Imprint<dim>::Imprint(const NominalContact<dim> &contact,
                        const GapFunction<dim>    &gap_function,
                        const std::string         &profile_lines)
    : contact(contact)
    , gap_function(gap_function)
    , has_own_lines(!profile_lines.empty())
  {
    if constexpr (dim == 3)
      lines = read_profile_lines(profile_lines, gap_function.position());
    else if (has_own_lines)
      throw InputError("Output/Profile lines",
                       profile_lines,
                       "in two dimensions the contact surface is a line "
                       "itself, all of which is written. Leave the entry "
                       "empty.");
  }



  template <int dim>
  void
  Imprint<dim>::check_lines(
    [[maybe_unused]] const ContactSurface<dim> &surface) const
  {
    if constexpr (dim == 3)
      for (const ProfileLine &line : lines)
        if (has_own_lines && surface.along(line).empty())
          throw InputError(
            "Output/Profile lines",
            Patterns::Tools::to_string(line.point) + "; " +
              Patterns::Tools::to_string(
                Point<2>(line.point + line.end * line.direction)),
            "this line does not meet any side of a face of the contact "
            "surface, seen from above. Choose a longer one across the "
            "boundary of 'Boundary conditions/Contact'.");
  }



  template <int dim>
  void
  Imprint<dim>::measure(SolveResult               &result,
                        const ContactSurface<dim> &surface) const
  {
    const Point<dim - 1> axis = gap_function.position();
    result.contact_radius     = contact.radius(result.contact_area);
    result.pile_up =
      surface.highest(axis,
                      2. * std::max(result.contact_radius, largest_radius));
    if (!(result.pile_up > 0.))
      result.pile_up = surface.height_of_edge(axis, result.contact_radius);
  }



  template <int dim>
  std::vector<SurfaceRow>
  Imprint<dim>::profile(const SolveResult         &result,
                        const ContactSurface<dim> &surface) const
  {
    std::vector<SurfaceRow> rows;
    if constexpr (dim == 2)
      for (const auto &point : surface.nodes())
        rows.push_back(surface_row(result, 0, point));
    else
      for (unsigned int i = 0; i < lines.size(); ++i)
        for (const auto &point : surface.along(lines[i]))
          rows.push_back(surface_row(result, i + 1, point));
    return rows;
  }



  template class Imprint<2>;
  template class Imprint<3>;
} // namespace ElastoPlastic
