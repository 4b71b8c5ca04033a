// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_file_h
#define mesh_gmsh_file_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <functional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What refinement makes of the curved boundaries of a mesh file; see the
  /// entry "Curves".
  enum class Curves
  {
    followed,
    straight
  };

  template <>
  inline const EnumNames<Curves> enum_names<Curves> = {
    {"followed", Curves::followed}, {"straight", Curves::straight}};



  /// The entries of the section "Geometry" about a mesh file.
  struct GmshFileParameters
  {
    std::string              file;
    std::vector<std::string> material_groups;
    Curves                   curves = Curves::followed;

    /// Declare the entries in the current section.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError if the file cannot be opened or is damaged.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation with the mesh of a file that Gmsh has written.
  /// Boundary ids are the numbers of the physical groups (see GmshBoundaries),
  /// material ids too or, if they are given, the places in the list of groups;
  /// 0 for what is in no group. Cells that meet at a corner or an edge only are
  /// not connected, and curves are followed if that is wanted (see
  /// follow_curved_boundaries()). @p warn is told what may not be meant.
  /// @throws InputError if the file is damaged or does not hold a mesh of
  /// quadrilaterals (2D, in the plane z = const) or hexahedra (3D) with a
  /// boundary that is divided.
  template <int dim>
  BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &parameters,
                           const std::function<void(const std::string &)> &warn,
                           Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
