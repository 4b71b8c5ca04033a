// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/distributed/tria.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "mesh/boundary_names.h"
#include "mesh/geometry.h"
#include "mesh/local_refinement.h"
#include "mesh/material_ids.h"

namespace ElastoPlastic
{
  namespace
  {
    using Warn = std::function<void(const std::string &)>;



    /// A kind of body: its name, how entries are checked, how its mesh is made.
    template <int dim>
    struct GeometryType
    {
      using P = GeometryParameters;
      using T = Triangulation<dim>;

      std::string                                                name;
      std::function<void(const P &)>                             check;
      std::function<BoundaryNames(const P &, const Warn &, T &)> make;
    };



    /// All geometries. A new one is a pair of files, and a line here.
    template <int dim>
    const std::vector<GeometryType<dim>> &
    geometry_types()
    {
      using P = GeometryParameters;
      using T = Triangulation<dim>;

      // clang-format off
      static const std::vector<GeometryType<dim>> list = {
        {"box",       [](const P &p) { p.box.check(dim); },       [](const P &p, const Warn &, T &t) { return make_box(p.box, t); }},
        {"half ball", [](const P &p) { p.half_ball.check(dim); }, [](const P &p, const Warn &, T &t) { return make_half_ball(p.half_ball, t); }},
        {"sector",    [](const P &p) { p.sector.check(dim); },    [](const P &p, const Warn &, T &t) { return make_sector(p.sector, t); }},
        {"file",      [](const P &p) { p.gmsh_file.check(dim); }, [](const P &p, const Warn &w, T &t) { return make_mesh_from_gmsh_file(p.gmsh_file, w, t); }}};
      // clang-format on
      return list;
    }



    template <int dim>
    const GeometryType<dim> &
    find_type(const std::string &name)
    {
      for (const auto &type : geometry_types<dim>())
        if (type.name == name)
          return type;
      AssertThrow(false, ExcInternalError());
      return geometry_types<dim>().front();
    }



    template <int dim>
    BoundaryNames
    make_coarse_mesh(const GeometryParameters &parameters,
                     const Warn               &warn,
                     Triangulation<dim>       &coarse_mesh)
    {
      try
        {
          return find_type<dim>(parameters.type)
            .make(parameters, warn, coarse_mesh);
        }
      catch (const ExceptionBase &)
        {
          throw InputError(
            "The mesh of the geometry '" + parameters.type +
            "' has cells without a volume. Are the lengths and ratios in "
            "'Geometry' extremely large or small, or is the body far from the "
            "origin? Then its lengths are lost in the rounding of "
            "coordinates: move it.");
        }
    }



    std::string
    all_names()
    {
      std::string names;
      for (const auto &type : geometry_types<3>())
        names += (names.empty() ? "" : "|") + type.name;
      return names;
    }
  } // namespace



  void
  GeometryParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Geometry");
    prm.add_parameter(
      "Type",
      type,
      "The body: a box with the boundaries left and right (x), front and back "
      "(y, in three dimensions only), bottom and top; the lower half of a "
      "ball: top (flat) and curved; in three dimensions, a sector of a round "
      "block: top, bottom, side, front and back; or a mesh from a file. Entries "
      "of other types are ignored.",
      Patterns::Selection(all_names()));
    box.add_parameters(prm);
    half_ball.add_parameters(prm);
    sector.add_parameters(prm);
    gmsh_file.add_parameters(prm);
    prm.add_parameter(
      "Initial refinements",
      initial_refinements,
      "How many times to halve all cells of the coarse mesh before the first "
      "computation. Allowed: 0 to 20.",
      Patterns::Integer(0, 20));
    prm.add_parameter(
      "Local refinements",
      local_refinements,
      "How many times to halve, after the initial refinements, the cells near "
      "a point: first those within the local radius, then those within half "
      "of it, and so on. Where the indenter touches, cells of the same shape "
      "as elsewhere are better than stretched ones. Allowed: 0 to 20.",
      Patterns::Integer(0, 20));
    prm.add_parameter("Local radius",
                      local_radius,
                      "The distance from the local centre within which cells "
                      "are halved first. Unit: length; allowed: > 0.",
                      Patterns::Double());
    prm.add_parameter("Local centre",
                      local_centre,
                      "The point x, y (, z) that the cells become smaller to; "
                      "empty stands for the origin. Unit: length.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter(
      "Material id",
      material_id,
      "Which of the materials each cell consists of: an expression in x, y "
      "(, z), evaluated at the centre of each cell of the mesh that is solved, "
      "also after each refinement, and rounded to a whole number >= 0; "
      "conditions are written if(y > -0.1, 1, 0). Empty stands for 0, or with "
      "the type file for what 'Material groups' says.",
      Patterns::Anything());
    prm.add_parameter(
      "Boundary parts",
      boundary_parts,
      "Parts of boundaries that are to have conditions of their own: "
      "'surcharge: top; x > 1' calls those sides of the boundary top surcharge "
      "on which the expression in x, y (, z) is not 0, and what is left remains "
      "top. Parts are separated by '|', which cannot be used in the "
      "expressions. They end between cells of the coarse mesh, as it is before "
      "'Initial refinements'. Empty stands for none.",
      Patterns::Anything());
    prm.leave_subsection();
  }



  void
  GeometryParameters::check(const unsigned int dim) const
  {
    if (!(local_radius > 0))
      throw InputError("Geometry/Local radius",
                       local_radius,
                       "it must be greater than 0.");
    if (!local_centre.empty() && local_centre.size() != dim)
      throw InputError("Geometry/Local centre",
                       local_centre,
                       "it must be empty or hold one coordinate for each of "
                       "the " +
                         std::to_string(dim) + " dimensions. " +
                         decimal_point_hint);
    if (type == "file" && !material_id.empty() &&
        !gmsh_file.material_groups.empty())
      throw InputError("Geometry/Material id",
                       material_id,
                       "'Geometry/Material groups' says of which material the "
                       "cells of the mesh file are. Leave one of them empty.");
    if (dim == 2)
      find_type<2>(type).check(*this);
    else
      find_type<3>(type).check(*this);
  }



  template <int dim>
  Geometry<dim>::Geometry(const GeometryParameters &parameters)
    : parameters(parameters)
  {
    const bool check_for_distorted_cells = true;
    const auto mesh =
      std::make_shared<Triangulation<dim>>(Triangulation<dim>::none,
                                           check_for_distorted_cells);
    names = make_coarse_mesh(
      parameters,
      [this](const std::string &warning) { warning_texts.push_back(warning); },
      *mesh);
    name_boundary_parts("Geometry/Boundary parts",
                        parameters.boundary_parts,
                        *mesh,
                        names);
    coarse_mesh = mesh;
  }



  // Each more of them makes 2^dim times as many cells.
  template <int dim>
  Geometry<dim>
  Geometry<dim>::with_few_cells(const double n_cells) const
  {
    Geometry result                       = *this;
    result.parameters.initial_refinements = 0;
    while (result.n_initial_refinements() < n_initial_refinements())
      {
        parallel::distributed::Triangulation<dim> mesh(MPI_COMM_SELF);
        result.make_mesh(mesh);
        if (GeometryInfo<dim>::max_children_per_cell *
              static_cast<double>(mesh.n_active_cells()) >
            n_cells)
          break;
        ++result.parameters.initial_refinements;
      }
    return result;
  }



  template <int dim>
  void
  Geometry<dim>::check_size(const MPI_Comm communicator) const
  {
    check_n_cells("Geometry/Initial refinements",
                  parameters.initial_refinements,
                  coarse_mesh->n_active_cells() *
                    std::pow(2., dim * parameters.initial_refinements),
                  max_n_cells(communicator));
  }



  template <int dim>
  void
  Geometry<dim>::make_mesh(Triangulation<dim> &triangulation) const
  {
    const MPI_Comm communicator = communicator_of(triangulation);
    check_size(communicator);
    triangulation.copy_triangulation(*coarse_mesh);
    triangulation.refine_global(parameters.initial_refinements);
    refine_locally(parameters, max_n_cells(communicator), triangulation);
    if (!parameters.material_id.empty())
      set_material_ids("Geometry/Material id",
                       parameters.material_id,
                       triangulation);
  }



  template <int dim>
  void
  coarsen_to_coarse_mesh(Triangulation<dim> &triangulation)
  {
    while (triangulation.n_global_levels() > 1)
      triangulation.coarsen_global();
  }



  template class Geometry<2>;
  template class Geometry<3>;
  template void
  coarsen_to_coarse_mesh(Triangulation<2> &);
  template void
  coarsen_to_coarse_mesh(Triangulation<3> &);
} // namespace ElastoPlastic
