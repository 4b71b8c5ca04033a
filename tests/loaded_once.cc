// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A library for LD_PRELOAD that lets a program run many times and be loaded
// once. deal.II comes with two hundred shared libraries, and to load them takes
// longer than many a run. The library takes the place of the program's main(),
// reads jobs from standard input until its end, and forks a process for each,
// in which the program's own main() does what it always does, MPI_Init()
// included.
//
// A job is a number of strings and a line break, then the strings, each ended
// by a zero: the file for standard output, then the arguments of the program
// with its name. Standard error is that of all. The answer is a line on
// standard output: the exit status, or minus the signal that has ended the
// process.
//
// What a process has got from its environment when it was loaded, such as the
// kernels of OpenBLAS, is the same for all jobs.

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
  using Main = int (*)(int, char **, char **);

  Main main_of_program = nullptr;



  /// Of the next job; empty at the end of all.
  std::vector<std::string>
  read_job()
  {
    std::size_t n_strings = 0;
    if (!(std::cin >> n_strings) || !std::cin.ignore())
      return {};
    std::vector<std::string> strings(n_strings);
    for (std::string &text : strings)
      std::getline(std::cin, text, '\0');
    return strings;
  }



  /// In a process of its own. Does not return.
  [[noreturn]] void
  run(std::vector<std::string> &job, char **environment)
  {
    const int input  = open("/dev/null", O_RDONLY);
    const int output = open(job[0].c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (input < 0 || output < 0 || dup2(input, STDIN_FILENO) < 0 ||
        dup2(output, STDOUT_FILENO) < 0)
      _exit(EXIT_FAILURE);
    close(input);
    close(output);
    std::vector<char *> arguments;
    for (std::size_t i = 1; i < job.size(); ++i)
      arguments.push_back(job[i].data());
    arguments.push_back(nullptr);
    std::exit(main_of_program(static_cast<int>(job.size() - 1),
                              arguments.data(),
                              environment));
  }



  /// In the place of the program's main().
  int
  run_jobs(int /*argc*/, char ** /*argv*/, char **environment)
  {
    for (auto job = read_job(); !job.empty(); job = read_job())
      {
        const pid_t process = fork();
        if (process == 0)
          run(job, environment);
        int status = 0;
        if (process < 0 || waitpid(process, &status, 0) < 0)
          return EXIT_FAILURE;
        std::cout << (WIFEXITED(status) ? WEXITSTATUS(status) :
                                          -WTERMSIG(status))
                  << std::endl;
      }
    return EXIT_SUCCESS;
  }
} // namespace



/// Takes the place of the C library's own function of this name, which calls
/// main().
extern "C" int
__libc_start_main(Main   main,
                  int    argc,
                  char **argv,
                  void (*init)(),
                  void (*fini)(),
                  void (*rtld_fini)(),
                  void *stack_end)
{
  main_of_program = main;
  unsetenv("LD_PRELOAD");
  const auto start = reinterpret_cast<decltype(&__libc_start_main)>(
    dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(run_jobs, argc, argv, init, fini, rtld_fini, stack_end);
}
