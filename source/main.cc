// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <iostream>

#include "base/exceptions.h"
#include "elasto_plastic_contact.h"
#include "io/command_line.h"
#include "io/parameters.h"
#include "version.h"

namespace
{
  using namespace ElastoPlastic;

  template <int dim>
  void
  solve_contact_problem(const CommandLine &command_line,
                        const Parameters  &parameters)
  {
    ElastoPlasticContact<dim> problem(parameters, MPI_COMM_WORLD);
    if (command_line.task == CommandLine::Task::run)
      problem.run(command_line.overwrite);
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
        case CommandLine::Task::validate:
        case CommandLine::Task::run:
          {
            const Parameters parameters = Parameters::read(command_line);
            if (parameters.dimension == 2)
              solve_contact_problem<2>(command_line, parameters);
            else
              solve_contact_problem<3>(command_line, parameters);
            break;
          }
      }
  }
} // namespace



// The dimension is an entry of the parameter file. Errors that the user can act
// on arrive here as exceptions, with the same message on all ranks; anything
// else is a bug, and a single rank that has met one must take the others down.
int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool first_rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  try
    {
      std::ostream nowhere(nullptr);
      run(CommandLine::parse(argc, argv), first_rank ? std::cout : nowhere);
      return static_cast<int>(ExitStatus::success);
    }
  catch (const Error &error)
    {
      if (first_rank)
        std::cerr << "Error: " << error.what() << std::endl;
      return static_cast<int>(error.status);
    }
  catch (const std::exception &bug)
    {
      std::cerr << "Error: this should not have happened, please report it:\n"
                << bug.what() << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
}
