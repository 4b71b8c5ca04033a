// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// messages TABLE FOLDER [--reverse]
//
// Runs the program inside this process once for each row of TABLE (written by
// message_test.cmake), in the new folder FOLDER, and checks with which exit
// status it ends and what it writes to standard error: all ranks together one
// message that fits, and at most one error. Whatever depends on what an earlier
// run has left behind fails in one of the two orders.

#include <deal.II/base/mpi.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.h"

#include <unistd.h>

namespace
{
  using namespace dealii;

  struct Row
  {
    std::string              name;
    int                      status = 0;
    std::string              message; ///< regular expression
    std::vector<std::string> arguments;
  };

  const unsigned int seconds_of_a_run = 120;

  /// Of the run that is under way, for those who end it.
  std::string        current_name;
  std::ostringstream current_errors;



  std::vector<Row>
  read_table(const std::string &name)
  {
    std::ifstream    file(name);
    std::vector<Row> rows;
    std::string      keyword, text;
    while (file >> keyword && file.ignore() && std::getline(file, text))
      if (keyword == "name")
        rows.push_back({text, 0, "", {}});
      else if (keyword == "status")
        rows.back().status = std::stoi(text);
      else if (keyword == "message")
        rows.back().message = text;
      else
        rows.back().arguments.push_back(text);
    return rows;
  }



  /// What is global in a process and must be after a run what it was before.
  std::string
  global_state()
  {
    std::ostringstream text;
    for (std::ios *const stream :
         std::initializer_list<std::ios *>{&std::cout, &std::cerr})
      text << "stream " << stream->rdbuf() << ' ' << stream->rdstate() << ' '
           << stream->flags() << ' ' << stream->precision() << ' '
           << stream->fill() << '\n';
    text << "locale " << std::locale().name() << '\n';
    const auto folder = std::filesystem::current_path();
    text << "folder " << folder << '\n';
    for (const auto &descriptor :
         std::filesystem::directory_iterator("/proc/self/fd"))
      {
        std::error_code closed;
        const auto file = std::filesystem::read_symlink(descriptor, closed);
        if (file.string().find(folder.string()) == 0)
          text << "open " << file << '\n';
      }
    return text.str();
  }



  /// Long messages are broken into lines at any blank.
  std::string
  on_one_line(const std::string &text)
  {
    return Utilities::trim(std::regex_replace(text, std::regex("\\s+"), " "));
  }



  /// The errors and warnings that @p text consists of; the first of them is
  /// what stands before, and should be empty.
  std::vector<std::string>
  messages_in(const std::string &text)
  {
    static const std::regex  begin("(^|\n)(?=(Error|Warning): )");
    std::vector<std::string> messages;
    for (std::sregex_token_iterator i(text.begin(), text.end(), begin, -1);
         i != std::sregex_token_iterator();
         ++i)
      messages.push_back(on_one_line(*i));
    return messages;
  }



  /// Why standard error is not what @p row demands, or nothing.
  std::string
  complaint(const Row &row, const int status, const std::string &errors)
  {
    const std::regex pattern(row.message);
    unsigned int     n_fitting = 0, n_errors = 0, n_others = 0;
    for (const std::string &message : messages_in(errors))
      {
        n_fitting += std::regex_search(message, pattern);
        n_errors += message.find("Error: ") == 0;
        n_others += !message.empty() && message.find("Error: ") != 0 &&
                    message.find("Warning: ") != 0;
      }
    std::ostringstream text;
    if (status != row.status)
      text << "  exit status " << status << " instead of " << row.status
           << '\n';
    if (n_fitting != 1)
      text << "  " << n_fitting << " messages fit '" << row.message << "'\n";
    if (n_errors != (row.status == 0 ? 0 : 1))
      text << "  there are " << n_errors << " errors\n";
    if (n_others != 0)
      text << "  there is text that belongs to no message\n";
    return text.str();
  }



  /// @return the exit status. @p errors and @p output receive what this rank
  /// writes.
  int
  run(const Row &row, std::ostream &errors, std::ostream &output)
  {
    std::vector<const char *> arguments = {"elasto_plastic_contact"};
    for (const std::string &argument : row.arguments)
      arguments.push_back(argument.c_str());
    std::streambuf *const error_buffer  = std::cerr.rdbuf(errors.rdbuf());
    std::streambuf *const output_buffer = std::cout.rdbuf(output.rdbuf());
    alarm(seconds_of_a_run);
    const int status =
      ElastoPlastic::run_program(arguments.size(), arguments.data());
    alarm(0);
    std::cerr.rdbuf(error_buffer);
    std::cout.rdbuf(output_buffer);
    return status;
  }



  /// Collective. @return whether all is as @p row demands, on all ranks.
  bool
  passes(const Row &row)
  {
    current_name = row.name;
    current_errors.str("");
    std::ostringstream output;
    const std::string  state_before = global_state();
    const int          status       = run(row, current_errors, output);

    std::string problems;
    if (global_state() != state_before)
      problems = "  the run has left behind:\n" + global_state() +
                 "  where there was:\n" + state_before;
    std::string errors;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, current_errors.str()))
      errors += of_rank;
    problems += complaint(row, status, errors);

    std::set<std::string> of_all_ranks;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, problems))
      if (!of_rank.empty())
        of_all_ranks.insert(of_rank);
    if (!of_all_ranks.empty() &&
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << "FAILED " << row.name << ":\n";
        for (const std::string &of_rank : of_all_ranks)
          std::cout << of_rank;
        std::cout << "Standard error:\n"
                  << errors << "Standard output:\n"
                  << output.str() << std::endl;
      }
    return of_all_ranks.empty();
  }



  /// A run that does not come to its end takes this process with it, but says
  /// which one it is.
  void
  name_the_run(const int signal)
  {
    const std::string text = "FAILED " + current_name + ": signal " +
                             std::to_string(signal) +
                             (signal == SIGALRM ? " (it hangs)\n" : "\n");
    if (write(STDOUT_FILENO, text.data(), text.size()) > 0)
      _exit(1);
  }
} // namespace



/// Takes the place of MPI's own function of this name.
extern "C" int
MPI_Abort(MPI_Comm communicator, int status)
{
  const std::string text =
    "FAILED " + current_name + ": MPI_Abort\n" + current_errors.str();
  if (write(STDOUT_FILENO, text.data(), text.size()) <= 0)
    return MPI_ERR_IO;
  return PMPI_Abort(communicator, status);
}



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  for (const int signal : {SIGALRM, SIGSEGV, SIGABRT, SIGFPE})
    std::signal(signal, name_the_run);

  std::vector<Row> rows = read_table(argv[1]);
  if (argc > 3)
    std::reverse(rows.begin(), rows.end());
  if (is_first)
    {
      std::filesystem::remove_all(argv[2]);
      std::filesystem::create_directory(argv[2]);
    }
  MPI_Barrier(MPI_COMM_WORLD);
  std::filesystem::current_path(argv[2]);

  unsigned int n_failures = 0;
  for (const Row &row : rows)
    n_failures += !passes(row);
  if (is_first)
    std::cout << n_failures << " of " << rows.size() << " runs have failed"
              << std::endl;
  return n_failures == 0 && !rows.empty() ? 0 : 1;
}
