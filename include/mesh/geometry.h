// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_geometry_h
#define mesh_geometry_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <string>
#include <vector>

#include "mesh/boundary_names.h"
#include "mesh/gmsh_file.h"
#include "mesh/ready_meshes.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Geometry": the body and its first mesh.
  struct GeometryParameters
  {
    std::string         type = "box";
    BoxParameters       box;
    HalfBallParameters  half_ball;
    SectorParameters    sector;
    GmshFileParameters  gmsh_file;
    unsigned int        initial_refinements = 0;
    unsigned int        local_refinements   = 0;
    double              local_radius        = 1;
    std::vector<double> local_centre;
    std::string         material_id;    ///< expression; empty: see make_mesh()
    std::string         boundary_parts; ///< see name_boundary_parts()

    void
    add_parameters(ParameterHandler &prm);

    /// Check what concerns the chosen type. @throws InputError for the first
    /// value that is not allowed.
    void
    check(const unsigned int dim) const;
  };



  /// The body: its coarse mesh with manifolds and boundary ids, what its
  /// boundaries are called, and how it is refined for the first computation.
  /// Meshes are made from it as often as they are needed.
  template <int dim>
  class Geometry
  {
  public:
    /// @p parameters must have passed their check. Reads the mesh file that
    /// they name, if any. @throws InputError
    explicit Geometry(const GeometryParameters &parameters);

    const BoundaryNames &
    boundary_names() const
    {
      return names;
    }

    /// What does not prevent the mesh from being used, but may not be meant.
    const std::vector<std::string> &
    warnings() const
    {
      return warning_texts;
    }

    unsigned int
    n_initial_refinements() const
    {
      return parameters.initial_refinements;
    }

    /// The same body with as many of its initial refinements as leave it some
    /// @p n_cells cells at most; with none, if that is still too much.
    Geometry
    with_few_cells(const double n_cells) const;

    /// @throws InputError if the initial refinements make more cells than are
    /// possible here. Collective over @p communicator.
    void
    check_size(const MPI_Comm communicator) const;

    /// Fills the empty @p triangulation, serial or distributed, with the mesh
    /// of the body: coarse mesh, manifolds, boundary ids, material ids and the
    /// initial and local refinements.
    ///
    /// The material id of a cell, whenever it has been made, is the value of
    /// the expression at its centre, see set_material_ids(). Without an
    /// expression it is 0, or what the mesh file says.
    ///
    /// Before Triangulation::load() call coarsen_to_coarse_mesh().
    ///
    /// Collective; errors are thrown on all ranks.
    void
    make_mesh(Triangulation<dim> &triangulation) const;

  private:
    GeometryParameters                        parameters;
    std::shared_ptr<const Triangulation<dim>> coarse_mesh;
    BoundaryNames                             names;
    std::vector<std::string>                  warning_texts;
  };



  /// Undoes all refinements.
  template <int dim>
  void
  coarsen_to_coarse_mesh(Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
