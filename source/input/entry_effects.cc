// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "input/entry_effects.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace EntryReasons;
    using Effects = std::map<std::string, Reason>;



    /// What adds some of a section's entries.
    auto
    entries_of(const std::string &section, Effects &effects)
    {
      return [prefix = section.empty() ? "" : section + "/",
              &effects](const Names &entries, const Reason &reason) {
        for (const std::string &entry : entries)
          effects.emplace(prefix + entry, reason);
      };
    }



    const Reason of_space      = with("Dimension", {"3"});
    const Reason of_section    = with("Dimension", {"2"});
    const Reason with_indenter = without("Indenter/Type", "none");
    const Reason no_limit_load = without("Analysis", "limit load");
    const Reason of_contact    = all({with_indenter, no_limit_load});



    void
    add_body(Effects &effects)
    {
      const auto general  = entries_of("", effects);
      const auto geometry = entries_of("Geometry", effects);
      const auto boundary_conditions =
        entries_of("Boundary conditions", effects);
      const Reason of_box = with("Geometry/Type", {"box"});
      general({"Dimension", "Analysis", "Body force", "Strain"}, always());
      general({"Kinematics"}, of_section);
      geometry({"Type", "Initial refinements"}, always());
      geometry({"Local refinements", "Material id"}, always());
      geometry({"Boundary parts"}, always());
      geometry({"Lower corner",
                "Upper corner",
                "Repetitions",
                "Grading",
                "Grading centre"},
               of_box);
      geometry({"Circle radius"}, all({of_box, of_space}));
      geometry({"Circle centre"},
               all({of_box, of_space, with_nonzero("Geometry/Circle radius")}));
      geometry({"Radius"}, with("Geometry/Type", {"half ball", "sector"}));
      geometry({"Part"}, with("Geometry/Type", {"half ball"}));
      geometry({"Sector angle", "Height", "Core radius"},
               with("Geometry/Type", {"sector"}));
      geometry({"File", "Material groups", "Curves"},
               with("Geometry/Type", {"file"}));
      geometry({"Local radius", "Local centre"},
               with_nonzero("Geometry/Local refinements"));
      boundary_conditions({"Fixed",
                           "Roller",
                           "Free",
                           "Contact",
                           "Prescribed displacement",
                           "Traction"},
                          always());
    }



    void
    add_material(Effects &effects)
    {
      const auto   material       = entries_of("Material", effects);
      const auto   initial_stress = entries_of("Initial stress", effects);
      const Reason nonlinear = with("Material/Law", {"nonlinear hardening"});
      material({"Law", "Young's modulus", "Poisson's ratio", "Rate law"},
               always());
      material({"Yield criterion"}, always());
      initial_stress({"Stress xx", "Stress yy", "Stress zz", "Stress xy"},
                     always());
      initial_stress({"Stress xz", "Stress yz"}, of_space);
      const auto obeys = [](const Names &criteria) {
        return with("Material/Yield criterion", criteria);
      };
      material({"Yield stress"},
               all({without("Material/Law", "linear elastic"),
                    obeys({"von Mises", "Hosford", "Hill"})}));
      material({"Hosford exponent"}, obeys({"Hosford"}));
      material({"Hill ratios", "Axes"}, obeys({"Hill"}));
      const Names soil = {"Mohr-Coulomb", "Drucker-Prager"};
      material({"Cohesion", "Friction angle"}, obeys(soil));
      material({"Isotropic hardening modulus"},
               with("Material/Law",
                    {"isotropic hardening",
                     "combined hardening",
                     "nonlinear hardening"}));
      material({"Kinematic hardening modulus"},
               with("Material/Law",
                    {"kinematic hardening", "combined hardening"}));
      material({"Voce stress",
                "Power law exponent",
                "Hardening table",
                "Back stress moduli"},
               nonlinear);
      material({"Voce rate"},
               all({nonlinear, with_nonzero("Material/Voce stress")}));
      material({"Power law reference strain"},
               all({nonlinear, with_nonzero("Material/Power law exponent")}));
      material({"Recovery rates"},
               all(
                 {nonlinear, without("Material/Back stress moduli", "none")}));
      material({"Rate exponent", "Reference rate"},
               with("Material/Rate law",
                    {"Perzyna", "Norton", "Cowper-Symonds"}));
      material({"Rate stress"},
               with("Material/Rate law", {"Perzyna", "Norton"}));
      material({"Relaxation time"},
               with("Material/Rate law", {"Duvaut-Lions"}));
    }



    void
    add_indenter(Effects &effects)
    {
      const auto indenter = entries_of("Indenter", effects);
      const auto contact  = entries_of("Contact", effects);
      const auto of_type  = [](const Names &types) {
        return with("Indenter/Type", types);
      };
      const Names with_heights = {"image", "height matrix"};
      indenter({"Type"}, always());
      indenter({"Radius"},
               of_type({"sphere",
                        "paraboloid",
                        "cylinder",
                        "circular punch",
                        "spheroconical tip"}));
      indenter({"Semi-apex angle"},
               of_type({"cone", "wedge", "spheroconical tip"}));
      indenter({"Half width"}, of_type({"strip punch", "rectangular punch"}));
      indenter({"Area coefficients"}, of_type({"area function"}));
      indenter({"Expression"}, of_type({"expression"}));
      indenter({"Number of faces",
                "Face angle",
                "Rotation",
                "Rounding radius",
                "Truncation"},
               of_type({"pyramid"}));
      indenter({"File"}, of_type({"image", "height matrix", "STL surface"}));
      indenter({"Size", "Height scale", "Side down"}, of_type(with_heights));
      indenter({"Length scale"}, of_type({"STL surface"}));
      indenter({"Position", "Initial gap", "Reach"}, with_indenter);
      indenter({"Surface"},
               all({with_indenter, with("Analysis", {"limit load"})}));
      contact({"Edge"}, all({of_contact, with_several_steps()}));
      contact({"Geometry", "Friction coefficient"}, with_indenter);
    }



    void
    add_loading(Effects &effects)
    {
      const auto   loading    = entries_of("Loading", effects);
      const auto   limit_load = entries_of("Limit load", effects);
      const Reason driven =
        all({no_limit_load, with_indenter, without_history()});
      loading({"Control"}, driven);
      loading({"Depth"}, all({driven, with("Loading/Control", {"depth"})}));
      loading({"Force"}, all({driven, with("Loading/Control", {"force"})}));
      loading({"History", "Path"}, of_contact);
      loading({"Final time"}, all({no_limit_load, without_history()}));
      loading({"Number of steps"}, no_limit_load);
      loading({"Step control", "Integration", "Maximum number of cuts"},
              all({no_limit_load, with_several_steps()}));
      loading({"Step tolerance"}, with("Loading/Step control", {"accurate"}));
      limit_load({"Load"}, with("Analysis", {"limit load"}));
      limit_load({"Stresses"},
                 with("Analysis", {"limit load", "contact with error bound"}));
    }



    void
    add_discretization(Effects &effects)
    {
      const auto   discretization   = entries_of("Discretization", effects);
      const auto   refinement       = entries_of("Refinement", effects);
      const auto   nonlinear_solver = entries_of("Nonlinear solver", effects);
      const auto   linear_solver    = entries_of("Linear solver", effects);
      const Reason refining         = without("Refinement/Strategy", "none");
      const Reason marking = with("Refinement/Strategy", {"adaptive", "Kelly"});
      discretization({"Polynomial degree", "Volumetric treatment"},
                     no_limit_load);
      refinement({"Strategy", "Maximum number of unknowns"}, always());
      refinement({"Goal"},
                 all({with("Analysis", {"contact with error bound"}),
                      with("Refinement/Strategy", {"adaptive"})}));
      refinement({"Number of cycles"}, refining);
      refinement({"Refinement fraction", "Coarsening fraction"}, marking);
      refinement({"Passes"}, all({marking, with("Analysis", {"limit load"})}));
      refinement({"Steps between adaptations"},
                 all({marking, with_several_steps()}));
      refinement({"Elements over contact radius"}, of_contact);
      nonlinear_solver({"Tolerance",
                        "Maximum number of iterations",
                        "Loosest linear reduction"},
                       no_limit_load);
      linear_solver({"Type"}, no_limit_load);
      linear_solver({"Maximum number of iterations"},
                    all({no_limit_load,
                         without("Linear solver/Type", "direct")}));
    }



    void
    add_results(Effects &effects)
    {
      const auto   evaluation = entries_of("Evaluation", effects);
      const auto   output     = entries_of("Output", effects);
      const Reason profile    = without("Output/Surface profile", "none");
      evaluation({"Beta",
                  "Epsilon",
                  "Young's modulus of the indenter",
                  "Continuous stiffness"},
                 all({of_contact, with_several_steps()}));
      evaluation({"Poisson's ratio of the indenter"},
                 all({of_contact,
                      with_several_steps(),
                      with_nonzero(
                        "Evaluation/Young's modulus of the indenter")}));
      output({"Directory", "Fields", "Length unit", "Force unit", "Screen"},
             always());
      output({"Field times"}, with("Output/Fields", {"at times"}));
      output({"Additional fields"},
             all({no_limit_load, without("Output/Fields", "never")}));
      output({"Minutes between checkpoints"},
             all({no_limit_load, with_several_steps()}));
      output({"Surface profile"}, of_contact);
      output({"Profile lines"}, all({of_contact, of_space, profile}));
      output({"Probe points"}, no_limit_load);
    }



    const Effects &
    all_effects()
    {
      static const Effects effects = []() {
        Effects result;
        add_body(result);
        add_material(result);
        add_indenter(result);
        add_loading(result);
        add_discretization(result);
        add_results(result);
        return result;
      }();
      return effects;
    }
  } // namespace



  std::string
  why_without_effect(const std::string &path, const EntryValues &values)
  {
    const auto found = all_effects().find(path);
    return found == all_effects().end() ? "" : found->second(values);
  }



  bool
  effect_is_known(const std::string &path)
  {
    return all_effects().count(path) > 0;
  }



  std::vector<std::string>
  entries_without_effect(const std::set<std::string> &set,
                         const EntryValues           &values)
  {
    std::vector<std::string> sentences;
    for (const std::string &path : set)
      if (const std::string why = why_without_effect(path, values);
          !why.empty())
        sentences.push_back("'" + path + "' (" + why + ")");
    return sentences;
  }
} // namespace ElastoPlastic
