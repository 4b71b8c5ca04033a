// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_parameters_h
#define input_parameters_h

#include <iosfwd>
#include <map>
#include <set>
#include <string>

#include "adaptivity/refinement.h"
#include "base/enum_names.h"
#include "contact/contact_parameters.h"
#include "evaluation/indentation_test.h"
#include "indenter/indenter_parameters.h"
#include "input/command_line.h"
#include "input/limit_load_parameters.h"
#include "loading/loading_parameters.h"
#include "loads/boundary_conditions.h"
#include "loads/loaded_body.h"
#include "material/material_parameters.h"
#include "mechanics/discretization_parameters.h"
#include "mechanics/initial_stress.h"
#include "mesh/geometry.h"
#include "output/output_parameters.h"
#include "solver/solver_parameters.h"

namespace ElastoPlastic
{
  /// What is computed; see the entry "Analysis".
  enum class Analysis
  {
    contact,
    limit_load,
    contact_with_error_bound
  };

  template <>
  inline const EnumNames<Analysis> enum_names<Analysis> = {
    {"contact", Analysis::contact},
    {"limit load", Analysis::limit_load},
    {"contact with error bound", Analysis::contact_with_error_bound}};



  /// Everything a parameter file can say. Each module of the program declares
  /// and documents its own section; here they are only put together, and what
  /// concerns several of them is checked.
  struct Parameters
  {
    unsigned int dimension = 3;
    Analysis     analysis  = Analysis::contact;

    GeometryParameters          geometry;
    BodyForceParameters         body_force;
    BoundaryConditionParameters boundary_conditions;
    MaterialParameters          material;
    InitialStressParameters     initial_stress;
    IndenterParameters          indenter;
    ContactParameters           contact;
    LoadingParameters           loading;
    LimitLoadParameters         limit_load;
    DiscretizationParameters    discretization;
    RefinementParameters        refinement;
    NewtonParameters            newton;
    LinearSolverParameters      linear_solver;
    EvaluationParameters        evaluation;
    OutputParameters            output;

    /// The complete effective input, in the format of a parameter file.
    std::string effective_input;

    /// The same, entry by entry: paths like "Material/Law" and values.
    std::map<std::string, std::string> entries;

    /// Reads the file and the overrides of the command line: on the first
    /// rank, for all. Collective.
    /// @throws InputError with file, line, section, entry, value and remedy.
    static Parameters
    read(const CommandLine &command_line);

    /// The entries that the file, or one that it includes, sets to other values
    /// than the defaults. (One that the program has written sets all entries.)
    /// @throws InputError as read().
    std::set<std::string>
    entries_changed_in(const std::string &file) const;

    /// Whether the entries make sense, each alone and together, as far as
    /// can be said before there is a mesh.
    /// @throws InputError with section, entry, value and remedy.
    void
    check() const;

    /// Writes all entries with default, range, unit and meaning as the user
    /// guide's reference (Markdown).
    static void
    print_reference(std::ostream &out);

  private:
    void
    add_parameters(ParameterHandler &prm);

    void
    read_input(const CommandLine &command_line, ParameterHandler &prm);

    void
    check_equilibrium_method() const;

    void
    check_soil() const;

    void
    check_places_of_materials() const;

    void
    check_contact_geometry() const;

    void
    check_friction_and_path() const;

    void
    check_integration() const;

    void
    check_yield_criterion() const;
  };
} // namespace ElastoPlastic

#endif
