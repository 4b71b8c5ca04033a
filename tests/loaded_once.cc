// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A library for LD_PRELOAD that lets a program run many times and be loaded
// once. deal.II comes with two hundred shared libraries, and to load them takes
// longer than many a run. The library takes the place of the program's main(),
// waits for the jobs of loaded_once_client.cc and forks a process for each, in
// which the program's own main() does what it always does, MPI_Init() included.
//
// What a process has got from its environment when it was loaded, such as the
// kernels of OpenBLAS, is the same for all jobs.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "loaded_once.h"

#include <dlfcn.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>

extern char **environ;

namespace
{
  using Main = int (*)(int, char **, char **);

  Main main_of_program = nullptr;

  struct Job
  {
    LoadedOnce::Streams      streams;
    std::string              directory;
    std::vector<std::string> arguments, environment;
  };



  /// The parts of a text, each of which ends with a zero.
  std::vector<std::string>
  split(const std::string &text)
  {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < text.size();
         begin += parts.back().size() + 1)
      parts.emplace_back(text.c_str() + begin);
    return parts;
  }



  Job
  receive_job(const int connection)
  {
    Job                       job;
    LoadedOnce::StreamMessage message;
    if (recvmsg(connection, &message.header, 0) != 1)
      throw std::runtime_error("the other side is gone");
    std::memcpy(job.streams.data(),
                CMSG_DATA(CMSG_FIRSTHDR(&message.header)),
                sizeof(job.streams));
    std::size_t size = 0;
    LoadedOnce::read_all(connection, &size, sizeof(size));
    std::string text(size, '\0');
    LoadedOnce::read_all(connection, text.data(), size);

    const std::vector<std::string> parts = split(text);
    job.directory                        = parts.at(0);
    const auto arguments                 = parts.begin() + 2;
    const auto environment               = arguments + std::stoi(parts.at(1));
    job.arguments.assign(arguments, environment);
    job.environment.assign(environment, parts.end());
    return job;
  }



  std::vector<char *>
  pointers(std::vector<std::string> &texts)
  {
    std::vector<char *> result;
    for (std::string &text : texts)
      result.push_back(text.data());
    result.push_back(nullptr);
    return result;
  }



  /// In a process of its own. Does not return.
  [[noreturn]] void
  run(Job &job)
  {
    for (int stream = 0; stream < 3; ++stream)
      {
        dup2(job.streams[stream], stream);
        close(job.streams[stream]);
      }
    if (chdir(job.directory.c_str()) != 0)
      _exit(EXIT_FAILURE);
    clearenv();
    for (std::string &entry : job.environment)
      putenv(entry.data());
    job.arguments.insert(job.arguments.begin(),
                         std::getenv(LoadedOnce::program_variable));
    std::exit(main_of_program(static_cast<int>(job.arguments.size()),
                              pointers(job.arguments).data(),
                              environ));
  }



  /// Hands signals on to a process until it has ended, of which the reading end
  /// of a pipe tells, and returns how it has.
  int
  watch(const pid_t process, const int end, const int connection)
  {
    pollfd watched[] = {{end, 0, 0}, {connection, POLLIN, 0}};
    while (TEMP_FAILURE_RETRY(poll(watched, 2, -1)) > 0 &&
           watched[0].revents == 0)
      {
        char       number = 0;
        const bool more   = read(connection, &number, 1) == 1;
        kill(process, more ? number : SIGKILL);
        if (!more)
          watched[1].fd = -1;
      }
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }



  /// What is done for a connection, in a process of its own, and its exit
  /// status.
  int
  serve(const int connection)
  {
    try
      {
        Job job     = receive_job(connection);
        int ends[2] = {-1, -1};
        if (pipe(ends) != 0)
          return EXIT_FAILURE;
        const pid_t process = fork();
        if (process == 0)
          {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            close(connection);
            close(ends[0]);
            run(job);
          }
        close(ends[1]);
        for (const int stream : job.streams)
          close(stream);
        if (process < 0)
          return EXIT_FAILURE;
        const int status = watch(process, ends[0], connection);
        LoadedOnce::write_all(connection, &status, sizeof(status));
        return EXIT_SUCCESS;
      }
    catch (const std::exception &)
      {
        return EXIT_FAILURE;
      }
  }



  /// So that what they took is known of this process, too.
  extern "C" void
  wait_for_ended(int /*number*/)
  {
    const int before = errno;
    while (waitpid(-1, nullptr, WNOHANG) > 0)
      ;
    errno = before;
  }



  /// In the place of the program's main(), until the process is ended, if not
  /// before, with the one that has started it.
  int
  run_jobs(int /*argc*/, char ** /*argv*/, char ** /*environment*/)
  {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    std::signal(SIGCHLD, wait_for_ended);
    const int listener = std::atoi(std::getenv(LoadedOnce::listener_variable));
    for (int connection = 0; connection >= 0; close(connection))
      {
        connection = TEMP_FAILURE_RETRY(accept(listener, nullptr, nullptr));
        if (fork() == 0)
          {
            close(listener);
            std::signal(SIGCHLD, SIG_DFL);
            _exit(serve(connection));
          }
      }
    return EXIT_FAILURE;
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
