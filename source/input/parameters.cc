// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/exceptions.h"
#include "input/parameter_input.h"
#include "input/parameters.h"
#include "loading/indenter_path.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A relative name of an input file starts in the folder of the parameter
    /// file, wherever the program is run.
    void
    resolve_file(ParameterHandler  &prm,
                 const std::string &entry,
                 const std::string &file,
                 const std::string &parameter_file)
    {
      namespace fs = std::filesystem;
      if (!file.empty() && fs::path(file).is_relative())
        set_entry(prm,
                  entry,
                  fs::absolute(fs::path(parameter_file).parent_path() / file)
                    .lexically_normal()
                    .string());
    }



    std::string
    as_text(const ParameterHandler &prm)
    {
      std::ostringstream text;
      prm.print_parameters(text,
                           ParameterHandler::PRM |
                             ParameterHandler::KeepDeclarationOrder);
      return text.str();
    }



    // Without a next step, the points do not remember where they are.
    void
    check_continuous_stiffness(const Parameters &parameters)
    {
      if (!parameters.evaluation.continuous_stiffness)
        return;
      const std::string entry = "Evaluation/Continuous stiffness";
      if (!parameters.indenter.is_present() ||
          parameters.analysis == Analysis::limit_load)
        throw InputError(entry,
                         "true",
                         "it is that of a contact with an indenter, which "
                         "there is not. Set it to false.");
      if (parameters.loading.is_single_step())
        throw InputError(entry,
                         "true",
                         "it is found in load histories, and there is a single "
                         "load step. Set 'Loading/Number of steps' to 2 or "
                         "more.");
    }
  } // namespace



  void
  Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Dimension",
      dimension,
      "2: a section of the body, see 'Kinematics'; 3: a body in space.",
      Patterns::Integer(2, 3));
    prm.add_parameter("Analysis",
                      analysis,
                      "contact: an indenter pressed into an elasto-plastic "
                      "body, or a body loaded by its boundary conditions. "
                      "limit load: the largest force that the indenter can "
                      "exert on a perfectly plastic body, or the largest "
                      "factor of its tractions and body forces, between two "
                      "rigorous bounds, see the section 'Limit load'. "
                      "contact with error bound: contact in one load step, "
                      "with stresses in exact "
                      "equilibrium beside the displacement, and a guaranteed "
                      "bound of the error that follows from both.");
    body_force.add_parameters(prm);
    geometry.add_parameters(prm);
    boundary_conditions.add_parameters(prm);
    material.add_parameters(prm);
    initial_stress.add_parameters(prm);
    indenter.add_parameters(prm);
    contact.add_parameters(prm);
    loading.add_parameters(prm);
    limit_load.add_parameters(prm);
    discretization.add_parameters(prm);
    refinement.add_parameters(prm);
    newton.add_parameters(prm);
    linear_solver.add_parameters(prm);
    evaluation.add_parameters(prm);
    output.add_parameters(prm);
  }



  Parameters
  Parameters::read(const CommandLine &command_line)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);

    on_first_rank(MPI_COMM_WORLD,
                  [&]() { parameters.read_input(command_line, prm); });
    parameters.entries =
      Utilities::MPI::broadcast(MPI_COMM_WORLD, all_entries(prm));
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      for (const auto &[path, value] : parameters.entries)
        set_entry(prm, path, value);
    parameters.effective_input = as_text(prm);
    return parameters;
  }



  std::set<std::string>
  Parameters::entries_changed_in(const std::string &file) const
  {
    ParameterHandler prm;
    Parameters       parameters;
    parameters.add_parameters(prm);
    const std::map<std::string, std::string> defaults = all_entries(prm);

    std::set<std::string> changed;
    for (const std::string &path : entries_set_in(file, entries))
      if (entries.at(path) != defaults.at(path))
        changed.insert(path);
    return changed;
  }



  void
  Parameters::read_input(const CommandLine &command_line, ParameterHandler &prm)
  {
    read_parameter_file(prm,
                        command_line.parameter_file,
                        [](const std::string &warning) {
                          Log(MPI_COMM_SELF, Verbosity::quiet).warn(warning);
                        });
    for (const auto &[path, value] : command_line.overrides)
      set_entry(prm, path, value);
    if (!command_line.output_directory.empty())
      set_entry(prm, "Output/Directory", command_line.output_directory);
    if (command_line.quiet)
      set_entry(prm, "Output/Screen", "quiet");
    resolve_file(prm,
                 "Geometry/File",
                 geometry.gmsh_file.file,
                 command_line.parameter_file);
    resolve_file(prm,
                 "Indenter/File",
                 indenter.file,
                 command_line.parameter_file);
  }



  void
  Parameters::check() const
  {
    geometry.check(dimension);
    if (dimension == 3 && discretization.kinematics != Kinematics::cartesian)
      throw InputError("Kinematics",
                       discretization.kinematics,
                       "that is for two dimensions. Set 'Dimension = 2' for a "
                       "axisymmetric body or a sheet.");
    if (discretization.kinematics == Kinematics::plane_stress &&
        discretization.volumetric_treatment != VolumetricTreatment::standard)
      throw InputError("Discretization/Volumetric treatment",
                       discretization.volumetric_treatment,
                       "in plane stress the volume can change freely, and "
                       "there is nothing that locks. Choose 'standard'.");
    if (analysis != Analysis::contact)
      check_equilibrium_method();
    check_soil();
    check_contact_geometry();
    check_friction_and_path();
    loading.check();
    material.check();
    check_integration();
    check_yield_criterion();
    check_places_of_materials();
    indenter.check(dimension);
    refinement.check();
    if (refinement.goal == RefinementGoal::force &&
        analysis != Analysis::contact_with_error_bound)
      throw InputError("Refinement/Goal",
                       refinement.goal,
                       "only 'Analysis = contact with error bound' bounds the "
                       "force. Choose 'energy'.");
    linear_solver.check();
    newton.check();
    output.check();
    evaluation.check();
    check_continuous_stiffness(*this);

    if (!indenter.is_present() && !loading.history.empty() &&
        analysis != Analysis::limit_load)
      throw InputError("Loading/History",
                       loading.history,
                       "there is no indenter: 'Indenter/Type = none'. Other "
                       "loads are expressions of t: set 'Loading/Final time'.");
    const bool has_contact_boundary = !boundary_conditions.contact.empty();
    if (!indenter.is_present() && has_contact_boundary)
      throw InputError(
        "The entry 'Boundary conditions/Contact' names a boundary, but "
        "'Indenter/Type' is 'none'. Choose an indenter, or give the boundary "
        "another condition, for example free.");
    if (indenter.is_present() && !has_contact_boundary)
      throw InputError(
        "There is an indenter ('Indenter/Type = " + indenter.type +
        "'), but 'Boundary conditions/Contact' is empty. Name "
        "the boundary that it presses on, for example top.");
  }



  void
  Parameters::check_places_of_materials() const
  {
    if (const unsigned int n = material.n_materials();
        n > 1 && geometry.type != "file" && geometry.material_id.empty())
      throw InputError(
        "The entries of 'Material' describe " + std::to_string(n) +
        " materials, but 'Geometry/Material id' is empty: the whole body is of "
        "material 0. Say there which cells are of which material, or give "
        "every entry one value. " +
        decimal_point_hint);
  }



  // Each of the two alone is much worse than none (doc/theory, "The geometry
  // of the contact").
  void
  Parameters::check_contact_geometry() const
  {
    const bool is_finite = discretization.strain == Strain::logarithmic;
    if (contact.geometry == ContactGeometry::automatic ||
        is_finite == (contact.geometry == ContactGeometry::present))
      return;
    throw InputError(
      "Contact/Geometry",
      contact.geometry,
      is_finite ?
        "'Strain = logarithmic' needs the indenter where the surface is now: "
        "under a sharp tip the vertical gap makes the force a fifth too small. "
        "Choose 'present' or 'automatic'." :
        "with 'Strain = small' the force would be less than half of what it is, "
        "because the small strains of a moving surface are not those of its "
        "shape. Set 'Strain = logarithmic', or choose 'vertical', 'normal' or "
        "'automatic'.");
  }



  // The exact solution of their law in a step is that of a backward Euler step.
  void
  Parameters::check_integration() const
  {
    if (loading.integration != Integration::bdf2)
      return;
    const auto materials = material.materials();
    if (std::any_of(materials.begin(), materials.end(), has_recovery))
      throw InputError("Loading/Integration",
                       loading.integration,
                       "back stresses that recover ('Material/Recovery rates') "
                       "follow their law exactly in backward Euler steps only. "
                       "Choose 'backward Euler'.");
  }



  void
  Parameters::check_friction_and_path() const
  {
    IndenterPath(loading.path).check_components(dimension - 1);
    if (!loading.path.empty() &&
        discretization.kinematics == Kinematics::axisymmetric)
      throw InputError(
        "Loading/Path",
        loading.path,
        "an indenter that moves sideways is not axisymmetric. Set "
        "'Dimension = 3'.");
    if (indenter.surface != SurfaceFinish::smooth &&
        analysis != Analysis::limit_load)
      throw InputError("Indenter/Surface",
                       indenter.surface,
                       "that is for 'Analysis = limit load'. Choose 'smooth', "
                       "and set 'Contact/Friction coefficient', for instance "
                       "to stick.");
    const bool has_friction = contact.friction_coefficient() > 0.;
    if (!indenter.is_present() && (has_friction || !loading.path.empty()))
      throw InputError(has_friction ? "Contact/Friction coefficient" :
                                      "Loading/Path",
                       has_friction ? contact.friction : loading.path,
                       "there is no indenter: 'Indenter/Type = none'.");
    if (analysis != Analysis::contact &&
        (has_friction || !loading.path.empty()))
      throw InputError(
        has_friction ? "Contact/Friction coefficient" : "Loading/Path",
        has_friction ? contact.friction : loading.path,
        "'Analysis = " + Patterns::Tools::to_string(analysis) +
          "' knows indenters without friction only, that move up and down." +
          (analysis == Analysis::limit_load ?
             " Set 'Indenter/Surface = rough' if nothing slides." :
             ""));
  }



  // What the equilibrium method cannot do.
  void
  Parameters::check_equilibrium_method() const
  {
    const std::string entry =
      "'Analysis = " + Patterns::Tools::to_string(analysis) + "'";
    if (discretization.strain != Strain::small)
      throw InputError("Strain",
                       discretization.strain,
                       entry +
                         " is for small strains: its bounds do not hold "
                         "for others. Set 'Strain = small'.");
    if (contact.geometry == ContactGeometry::normal &&
        (analysis != Analysis::limit_load || dimension == 3 ||
         discretization.kinematics == Kinematics::plane_stress))
      throw InputError("Contact/Geometry",
                       contact.geometry,
                       entry +
                         " knows the vertical gap only, but for limit loads in "
                         "plane strain and of bodies of revolution. Choose "
                         "'vertical'.");
    if (analysis == Analysis::limit_load && !indenter.is_present() &&
        limit_load.load == GrowingLoad::indenter)
      throw InputError("Indenter/Type",
                       "none",
                       entry +
                         " looks for the largest force of an indenter. "
                         "Choose one, for example strip punch, or set 'Limit "
                         "load/Load = tractions'.");
    if (dimension == 3 && limit_load.stresses == StressDegree::quadratic)
      throw InputError("Limit load/Stresses",
                       "quadratic",
                       "stresses in space are linear. Leave 'automatic'.");
    if (!body_force.components.empty() &&
        (analysis == Analysis::contact_with_error_bound ||
         discretization.kinematics == Kinematics::plane_stress))
      throw InputError("Body force",
                       body_force.components,
                       entry + " knows no body forces" +
                         (analysis == Analysis::limit_load ?
                            " in plane stress" :
                            "") +
                         ". Leave it empty.");
    if (initial_stress.is_present() && analysis == Analysis::limit_load)
      throw InputError(
        entry +
        " finds what does not depend on an initial stress: the limit "
        "load of a perfectly plastic body is the same with any. Leave "
        "the entries of 'Initial stress' empty.");
    if (analysis == Analysis::contact_with_error_bound &&
        !loading.is_single_step())
      throw InputError("Analysis",
                       analysis,
                       "the equilibrium method takes one step from the virgin "
                       "state. Set 'Loading/Number of steps = 1', without "
                       "'Loading/History'.");
  }



  void
  Parameters::print_reference(std::ostream &out)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    print_parameter_reference(prm, out);
  }
} // namespace ElastoPlastic
