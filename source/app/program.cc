// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <chrono>
#include <iostream>
#include <utility>

#include "app/bounds.h"
#include "app/program.h"
#include "app/ready_cases.h"
#include "base/exceptions.h"
#include "base/version.h"
#include "contact_run/elasto_plastic_contact.h"
#include "input/command_line.h"
#include "input/parameters.h"
#include "problem/model.h"

namespace
{
  using namespace ElastoPlastic;

  template <int dim>
  void
  solve_contact_problem(const Model<dim>  &model,
                        const CommandLine &command_line,
                        const Parameters  &parameters)
  {
    ElastoPlasticContact<dim> problem(model,
                                      parameters,
                                      MPI_COMM_WORLD,
                                      StrictBounds<dim>::make_error_bound);
    if (command_line.resume)
      problem.resume();
    else
      {
        StrictBounds<dim>::require_safe_load(model, parameters, MPI_COMM_WORLD);
        problem.run(command_line.overwrite);
      }
  }



  template <int dim>
  void
  analyze_in(const CommandLine &command_line,
             const Parameters  &parameters,
             std::ostream      &out)
  {
    const bool is_limit_load = parameters.analysis == Analysis::limit_load;
    if (is_limit_load && command_line.resume)
      throw InputError(
        "A limit load analysis has no load steps and keeps no "
        "checkpoints: there is nothing to resume. Leave out "
        "--resume.");
    const Model<dim> model = make_model<dim>(parameters);
    if (command_line.task == CommandLine::Task::validate)
      validate(model, command_line, parameters, MPI_COMM_WORLD, out);
    else if (is_limit_load)
      StrictBounds<dim>::find_limit_load(model,
                                         parameters,
                                         MPI_COMM_WORLD,
                                         command_line.overwrite);
    else
      solve_contact_problem(model, command_line, parameters);
  }



  /// @p name, or where the ready case of this name lies.
  std::string
  find_parameter_file(const std::string &name)
  {
    std::string file;
    on_first_rank(MPI_COMM_WORLD, [&]() {
      file =
        ReadyCases(ReadyCases::places_of_this_program()).file_meant_by(name);
    });
    return Utilities::MPI::broadcast(MPI_COMM_WORLD, file);
  }



  /// @throws InputError that names the parameter file.
  void
  analyze(CommandLine command_line, std::ostream &out)
  {
    const std::string name =
      std::exchange(command_line.parameter_file,
                    find_parameter_file(command_line.parameter_file));
    const Parameters parameters = Parameters::read(command_line);
    std::ostream     nowhere(nullptr);
    std::ostream    &report =
      parameters.output.screen == Verbosity::quiet ? nowhere : out;
    if (command_line.parameter_file != name)
      report << "Parameter file: " << command_line.parameter_file << std::endl;
    try
      {
        parameters.check();
        if (parameters.dimension == 2)
          analyze_in<2>(command_line, parameters, report);
        else
          analyze_in<3>(command_line, parameters, report);
      }
    catch (const InputError &error)
      {
        throw InputError(command_line.parameter_file + ": " + error.what());
      }
  }



  void
  run(const CommandLine &command_line, std::ostream &out)
  {
    switch (command_line.task)
      {
        case CommandLine::Task::print_help:
          out << CommandLine::help();
          break;
        case CommandLine::Task::print_version:
          out << "ElastoPlasticContact " << ELASTO_PLASTIC_CONTACT_VERSION
              << std::endl;
          break;
        case CommandLine::Task::print_parameters:
          Parameters::print_reference(out);
          break;
        case CommandLine::Task::list_cases:
          on_first_rank(MPI_COMM_WORLD, [&]() {
            ReadyCases(ReadyCases::places_of_this_program()).print(out);
          });
          break;
        case CommandLine::Task::validate:
        case CommandLine::Task::run:
          analyze(command_line, out);
          break;
      }
  }



  /// Processes that are started side by side may have been told different
  /// things. @throws InputError
  void
  require_same_arguments(const int argc, const char *const *const argv)
  {
    std::string arguments;
    for (int i = 1; i < argc; ++i)
      arguments += (i > 1 ? " " : "") + std::string(argv[i]);
    const std::string of_first =
      Utilities::MPI::broadcast(MPI_COMM_WORLD, arguments);
    rethrow_collectively(MPI_COMM_WORLD, [&]() {
      if (arguments != of_first)
        throw InputError(
          "Wrong usage: all processes of a run must have the same arguments, "
          "but the first has '" +
          of_first + "' and another '" + arguments + "'.");
    });
  }



  /// Where memory ends on one rank, it mostly ends on all at the same time: the
  /// first one says so and takes the others down while they wait for it.
  void
  let_others_speak_first()
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    std::this_thread::sleep_for(std::chrono::milliseconds(500) *
                                std::min(rank, 10u));
  }
} // namespace



// The dimension is an entry of the parameter file. Errors that the user can act
// on arrive here as exceptions, with the same message on all ranks; anything
// else is a limit of the machine or a bug, and a single rank that has met one
// must take the others down.
int
ElastoPlastic::run_program(const int argc, const char *const *const argv)
{
  const bool first_rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  try
    {
      std::ostream nowhere(nullptr);
      require_same_arguments(argc, argv);
      run(CommandLine::parse(argc, argv), first_rank ? std::cout : nowhere);
      return static_cast<int>(ExitStatus::success);
    }
  catch (const Error &error)
    {
      if (first_rank)
        std::cerr << "Error: " << error.what() << std::endl;
      return static_cast<int>(error.status);
    }
  catch (const std::exception &exception)
    {
      if (const auto error = machine_error(exception))
        {
          let_others_speak_first();
          std::cerr << "Error: " << error->what() << std::endl;
          MPI_Abort(MPI_COMM_WORLD, static_cast<int>(error->status));
        }
      std::cerr << "Error: this should not have happened, please report it:\n"
                << exception.what() << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
  return 1; // not reached
}
