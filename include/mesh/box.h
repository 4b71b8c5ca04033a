// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_box_h
#define mesh_box_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <vector>

#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Geometry" that shape a box. Lists have one
  /// value per direction.
  struct BoxParameters
  {
    std::vector<double>       lower_corner; ///< empty stands for the origin
    std::vector<double>       upper_corner; ///< empty stands for (1, 1, 1)
    std::vector<unsigned int> repetitions = {1}; ///< or one for all directions
    double                    grading     = 1;
    std::vector<double>       grading_centre;    ///< horizontal; may be empty
    double                    circle_radius = 0; ///< 0 stands for no circle
    std::vector<double>       circle_centre; ///< empty stands for the origin

    /// Declare the entries in the current section.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation with the coarse mesh of a box, cells graded
  /// geometrically towards the top and the grading centre. Its boundaries are
  /// left and right (x), front and back (y, 3D only), bottom and top. In three
  /// dimensions, edges of cells may lie on a circle: see
  /// divide_around_circle().
  /// @throws InputError if there is no room for it.
  template <int dim>
  BoundaryNames
  make_box(const BoxParameters &parameters, Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
