// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_model_h
#define problem_model_h

#include <deal.II/distributed/tria.h>

#include <string>
#include <vector>

#include "contact/contact_parameters.h"
#include "contact/gap_function.h"
#include "input/parameters.h"
#include "loading/load_program.h"
#include "loads/loaded_body.h"
#include "material/material.h"
#include "mechanics/initial_stress.h"
#include "mesh/geometry.h"

namespace ElastoPlastic
{
  /// The problem that is solved (doc/theory, "Johnson's formulation"): body,
  /// material, supports, indenter and load, each in the type that the
  /// mathematics knows. Everything that a parameter file says about them, in
  /// words, expressions and files, has been read when a Model is there, and is
  /// read once. It does not change: meshes and all that grows during a
  /// computation belong to the analyses, which take it by const reference.
  template <int dim>
  struct Model : LoadedBody<dim>
  {
    Geometry<dim> geometry;

    /// The degree p of the elements FE_Q(p)^dim.
    unsigned int degree;

    /// The materials by material id; a single one stands for every id.
    std::vector<Material<double>> materials;

    PlacedIndenter<dim> indenter;
    ContactParameters   contact;

    /// As it is before the first step: an analysis takes a copy, which
    /// remembers what has been reached.
    LoadProgram load_program;

    InitialStress<dim> initial_stress = {};

    /// The same problem with Geometry::with_few_cells(@p n_cells).
    Model
    with_few_cells(const double n_cells) const
    {
      Model result    = *this;
      result.geometry = geometry.with_few_cells(n_cells);
      return result;
    }
  };



  /// What is allowed but hardly meant, in full sentences for the user.
  template <int dim>
  std::vector<std::string>
  warnings(const Model<dim> &model);



  /// Makes the first mesh of the body in the empty @p triangulation, and places
  /// the indenter above the highest point of its contact surface. Collective.
  /// @throws InputError
  template <int dim>
  GapFunction<dim>
  make_mesh_and_place_indenter(
    const Model<dim>                          &model,
    parallel::distributed::Triangulation<dim> &triangulation);



  /// The bounds that the indenter sets to the nodes of the mesh, which is flat
  /// or curved. @p gap_function must outlive them. Collective.
  template <int dim>
  ContactBounds<dim>
  make_contact_bounds(
    const Model<dim>                                &model,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation);



  /// The problem that @p parameters describe, which must have passed their
  /// check. Reads the files that they name.
  /// @throws InputError for what is wrong in expressions, tables and files, on
  /// all ranks.
  template <int dim>
  Model<dim>
  make_model(const Parameters &parameters);
} // namespace ElastoPlastic

#endif
