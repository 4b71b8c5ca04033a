// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/exceptions.h"
#include "io/parameter_reference.h"
#include "io/parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    /// deal.II's own words on what is wrong, in one line.
    std::string
    reason(const ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      std::istringstream words(text.str());
      std::string        result;
      for (std::string word; words >> word;)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }



    void
    parse_file(ParameterHandler &prm, const std::string &file)
    {
      if (!std::ifstream(file))
        throw InputError("The parameter file '" + file +
                         "' does not exist or cannot be read.");
      try
        {
          prm.parse_input(file);
        }
      catch (const ExceptionBase &exception)
        {
          throw InputError("In the parameter file '" + file +
                           "': " + reason(exception) +
                           " All entries are listed by elasto_plastic_contact "
                           "--print-parameters.");
        }
    }



    void
    set_entry(ParameterHandler  &prm,
              const std::string &path,
              const std::string &value)
    {
      std::vector<std::string> names = Utilities::split_string_list(path, '/');
      const std::string        entry = names.back();
      names.pop_back();
      try
        {
          // deal.II creates unknown sections on entering: ask before
          for (const std::string &section : names)
            {
              if (!prm.subsection_path_exists({section}))
                throw InputError("The option --set '" + path + "=" + value +
                                 "' names the section '" + section +
                                 "', which does not exist.");
              prm.enter_subsection(section);
            }
          prm.set(entry, value);
          for (unsigned int i = 0; i < names.size(); ++i)
            prm.leave_subsection();
        }
      catch (const ExceptionBase &exception)
        {
          throw InputError("In the option --set '" + path + "=" + value +
                           "': " + reason(exception) +
                           " All entries are listed by elasto_plastic_contact "
                           "--print-parameters.");
        }
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
  } // namespace



  void
  Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Dimension",
                      dimension,
                      "2: plane strain; 3: a body in space.",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Analysis",
                      analysis,
                      "contact: an indenter pressed into an elasto-plastic "
                      "body, or a body loaded by its boundary conditions.",
                      Patterns::Selection("contact"));
    geometry.add_parameters(prm);
    boundary_conditions.add_parameters(prm);
    material.add_parameters(prm);
    indenter.add_parameters(prm);
    loading.add_parameters(prm);
    discretization.add_parameters(prm);
    refinement.add_parameters(prm);
    newton.add_parameters(prm);
    linear_solver.add_parameters(prm);
    output.add_parameters(prm);
  }



  Parameters
  Parameters::read(const CommandLine &command_line)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);

    parse_file(prm, command_line.parameter_file);
    for (const auto &[path, value] : command_line.overrides)
      set_entry(prm, path, value);
    if (!command_line.output_directory.empty())
      set_entry(prm, "Output/Directory", command_line.output_directory);
    if (command_line.quiet)
      set_entry(prm, "Output/Screen", "quiet");

    parameters.effective_input = as_text(prm);
    try
      {
        parameters.check();
      }
    catch (const InputError &error)
      {
        throw InputError(command_line.parameter_file + ": " + error.what());
      }
    return parameters;
  }



  void
  Parameters::check() const
  {
    geometry.check(dimension);
    material.check();
    indenter.check(dimension);
    if (indenter.type != "none")
      loading.check();
    refinement.check();
    newton.check();

    const bool has_contact_boundary = !boundary_conditions.contact.empty();
    if (indenter.type == "none" && has_contact_boundary)
      throw InputError(
        "The entry 'Boundary conditions/Contact' names a boundary, but "
        "'Indenter/Type' is 'none'. Choose an indenter, or give the boundary "
        "another condition, for example free.");
    if (indenter.type != "none" && !has_contact_boundary)
      throw InputError(
        "There is an indenter ('Indenter/Type = " + indenter.type +
        "'), but 'Boundary conditions/Contact' is empty. Name "
        "the boundary that it presses on, for example top.");
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
