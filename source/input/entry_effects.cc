// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "input/entry_effects.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace EntryReasons;
    using Effects = std::map<std::string, Reason>;



    void
    add(Effects           &effects,
        const std::string &section,
        const Names       &entries,
        const Reason      &reason)
    {
      for (const std::string &entry : entries)
        effects.emplace(section.empty() ? entry : section + "/" + entry,
                        reason);
    }



    const Reason of_space      = with("Dimension", {"3"});
    const Reason of_section    = with("Dimension", {"2"});
    const Reason with_indenter = without("Indenter/Type", "none");
    const Reason no_limit_load = without("Analysis", "limit load");
    const Reason of_contact    = all({with_indenter, no_limit_load});



    void
    add_body(Effects &effects)
    {
      const Reason of_box = with("Geometry/Type", {"box"});
      add(effects,
          "",
          {"Dimension", "Analysis", "Body force", "Strain"},
          always());
      add(effects, "", {"Kinematics"}, of_section);
      add(effects, "Geometry", {"Type", "Initial refinements"}, always());
      add(effects, "Geometry", {"Local refinements", "Material id"}, always());
      add(effects, "Geometry", {"Boundary parts"}, always());
      add(effects,
          "Geometry",
          {"Lower corner",
           "Upper corner",
           "Repetitions",
           "Grading",
           "Grading centre"},
          of_box);
      add(effects, "Geometry", {"Circle radius"}, all({of_box, of_space}));
      add(effects,
          "Geometry",
          {"Circle centre"},
          all({of_box, of_space, with_nonzero("Geometry/Circle radius")}));
      add(effects,
          "Geometry",
          {"Radius"},
          with("Geometry/Type", {"half ball", "sector"}));
      add(effects, "Geometry", {"Part"}, with("Geometry/Type", {"half ball"}));
      add(effects,
          "Geometry",
          {"Sector angle", "Height", "Core radius"},
          with("Geometry/Type", {"sector"}));
      add(effects,
          "Geometry",
          {"File", "Material groups", "Curves"},
          with("Geometry/Type", {"file"}));
      add(effects,
          "Geometry",
          {"Local radius", "Local centre"},
          with_nonzero("Geometry/Local refinements"));
      add(effects,
          "Boundary conditions",
          {"Fixed",
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
      const Reason nonlinear = with("Material/Law", {"nonlinear hardening"});
      add(effects,
          "Material",
          {"Law", "Young's modulus", "Poisson's ratio", "Rate law"},
          always());
      add(effects, "Material", {"Yield criterion"}, always());
      add(effects,
          "Initial stress",
          {"Stress xx", "Stress yy", "Stress zz", "Stress xy"},
          always());
      add(effects, "Initial stress", {"Stress xz", "Stress yz"}, of_space);
      const auto obeys = [](const Names &criteria) {
        return with("Material/Yield criterion", criteria);
      };
      add(effects,
          "Material",
          {"Yield stress"},
          all({without("Material/Law", "linear elastic"),
               obeys({"von Mises", "Hosford", "Hill"})}));
      add(effects, "Material", {"Hosford exponent"}, obeys({"Hosford"}));
      add(effects, "Material", {"Hill ratios", "Axes"}, obeys({"Hill"}));
      const Names soil = {"Mohr-Coulomb", "Drucker-Prager"};
      add(effects, "Material", {"Cohesion", "Friction angle"}, obeys(soil));
      add(effects,
          "Material",
          {"Isotropic hardening modulus"},
          with("Material/Law",
               {"isotropic hardening",
                "combined hardening",
                "nonlinear hardening"}));
      add(effects,
          "Material",
          {"Kinematic hardening modulus"},
          with("Material/Law", {"kinematic hardening", "combined hardening"}));
      add(effects,
          "Material",
          {"Voce stress",
           "Power law exponent",
           "Hardening table",
           "Back stress moduli"},
          nonlinear);
      add(effects,
          "Material",
          {"Voce rate"},
          all({nonlinear, with_nonzero("Material/Voce stress")}));
      add(effects,
          "Material",
          {"Power law reference strain"},
          all({nonlinear, with_nonzero("Material/Power law exponent")}));
      add(effects,
          "Material",
          {"Recovery rates"},
          all({nonlinear, without("Material/Back stress moduli", "none")}));
      add(effects,
          "Material",
          {"Rate exponent", "Reference rate"},
          with("Material/Rate law", {"Perzyna", "Norton", "Cowper-Symonds"}));
      add(effects,
          "Material",
          {"Rate stress"},
          with("Material/Rate law", {"Perzyna", "Norton"}));
      add(effects,
          "Material",
          {"Relaxation time"},
          with("Material/Rate law", {"Duvaut-Lions"}));
    }



    void
    add_indenter(Effects &effects)
    {
      const auto of_type = [](const Names &types) {
        return with("Indenter/Type", types);
      };
      const Names with_heights = {"image", "height matrix"};
      add(effects, "Indenter", {"Type"}, always());
      add(effects,
          "Indenter",
          {"Radius"},
          of_type({"sphere",
                   "paraboloid",
                   "cylinder",
                   "circular punch",
                   "spheroconical tip"}));
      add(effects,
          "Indenter",
          {"Semi-apex angle"},
          of_type({"cone", "wedge", "spheroconical tip"}));
      add(effects,
          "Indenter",
          {"Half width"},
          of_type({"strip punch", "rectangular punch"}));
      add(effects,
          "Indenter",
          {"Area coefficients"},
          of_type({"area function"}));
      add(effects, "Indenter", {"Expression"}, of_type({"expression"}));
      add(effects,
          "Indenter",
          {"Number of faces",
           "Face angle",
           "Rotation",
           "Rounding radius",
           "Truncation"},
          of_type({"pyramid"}));
      add(effects,
          "Indenter",
          {"File"},
          of_type({"image", "height matrix", "STL surface"}));
      add(effects,
          "Indenter",
          {"Size", "Height scale", "Side down"},
          of_type(with_heights));
      add(effects, "Indenter", {"Length scale"}, of_type({"STL surface"}));
      add(effects,
          "Indenter",
          {"Position", "Initial gap", "Reach"},
          with_indenter);
      add(effects,
          "Indenter",
          {"Surface"},
          all({with_indenter, with("Analysis", {"limit load"})}));
      add(effects,
          "Contact",
          {"Edge"},
          all({of_contact, with_several_steps()}));
      add(effects,
          "Contact",
          {"Geometry", "Friction coefficient"},
          with_indenter);
    }



    void
    add_loading(Effects &effects)
    {
      const Reason driven =
        all({no_limit_load, with_indenter, without_history()});
      add(effects, "Loading", {"Control"}, driven);
      add(effects,
          "Loading",
          {"Depth"},
          all({driven, with("Loading/Control", {"depth"})}));
      add(effects,
          "Loading",
          {"Force"},
          all({driven, with("Loading/Control", {"force"})}));
      add(effects, "Loading", {"History", "Path"}, of_contact);
      add(effects,
          "Loading",
          {"Final time"},
          all({no_limit_load, without_history()}));
      add(effects, "Loading", {"Number of steps"}, no_limit_load);
      add(effects,
          "Loading",
          {"Step control", "Integration", "Maximum number of cuts"},
          all({no_limit_load, with_several_steps()}));
      add(effects,
          "Loading",
          {"Step tolerance"},
          with("Loading/Step control", {"accurate"}));
      add(effects, "Limit load", {"Load"}, with("Analysis", {"limit load"}));
      add(effects,
          "Limit load",
          {"Stresses"},
          with("Analysis", {"limit load", "contact with error bound"}));
    }



    void
    add_discretization(Effects &effects)
    {
      const Reason refining = without("Refinement/Strategy", "none");
      const Reason marking = with("Refinement/Strategy", {"adaptive", "Kelly"});
      add(effects,
          "Discretization",
          {"Polynomial degree", "Volumetric treatment"},
          no_limit_load);
      add(effects,
          "Refinement",
          {"Strategy", "Maximum number of unknowns"},
          always());
      add(effects,
          "Refinement",
          {"Goal"},
          all({with("Analysis", {"contact with error bound"}),
               with("Refinement/Strategy", {"adaptive"})}));
      add(effects, "Refinement", {"Number of cycles"}, refining);
      add(effects,
          "Refinement",
          {"Refinement fraction", "Coarsening fraction"},
          marking);
      add(effects,
          "Refinement",
          {"Steps between adaptations"},
          all({marking, with_several_steps()}));
      add(effects, "Refinement", {"Elements over contact radius"}, of_contact);
      add(effects,
          "Nonlinear solver",
          {"Tolerance",
           "Maximum number of iterations",
           "Loosest linear reduction"},
          no_limit_load);
      add(effects, "Linear solver", {"Type"}, no_limit_load);
      add(effects,
          "Linear solver",
          {"Maximum number of iterations"},
          all({no_limit_load, without("Linear solver/Type", "direct")}));
    }



    void
    add_results(Effects &effects)
    {
      const Reason profile = without("Output/Surface profile", "none");
      add(effects,
          "Evaluation",
          {"Beta",
           "Epsilon",
           "Young's modulus of the indenter",
           "Continuous stiffness"},
          all({of_contact, with_several_steps()}));
      add(effects,
          "Evaluation",
          {"Poisson's ratio of the indenter"},
          all({of_contact,
               with_several_steps(),
               with_nonzero("Evaluation/Young's modulus of the indenter")}));
      add(effects,
          "Output",
          {"Directory", "Fields", "Length unit", "Force unit", "Screen"},
          always());
      add(effects,
          "Output",
          {"Field times"},
          with("Output/Fields", {"at times"}));
      add(effects,
          "Output",
          {"Additional fields"},
          all({no_limit_load, without("Output/Fields", "never")}));
      add(effects,
          "Output",
          {"Minutes between checkpoints"},
          all({no_limit_load, with_several_steps()}));
      add(effects, "Output", {"Surface profile"}, of_contact);
      add(effects,
          "Output",
          {"Profile lines"},
          all({of_contact, of_space, profile}));
      add(effects, "Output", {"Probe points"}, no_limit_load);
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
