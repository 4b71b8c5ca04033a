// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Stands for the program where load_program.py has loaded it for a test: hands
// its arguments, streams, environment and working directory on to the process
// that has loaded the program, and signals, too, and ends as the program does
// there. (loaded_once.h)
//
// The program itself is started as one of several ranks, which mpirun must know
// by their processes, with a variable that counts when it is loaded, and where
// nothing waits: another ctest in the same folder may have taken the socket.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>

#include "loaded_once.h"

#include <sys/un.h>

extern char **environ;

namespace
{
  int connection = -1;



  std::string
  variable(const char *name)
  {
    const char *value = std::getenv(name);
    return value != nullptr ? value : "";
  }



  /// Whether there is a connection now.
  bool
  connect_to(const std::string &path)
  {
    sockaddr_un address = {};
    address.sun_family  = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    return connect(connection,
                   reinterpret_cast<const sockaddr *>(&address),
                   sizeof(address)) == 0;
  }



  void
  send_job(int argc, char **argv)
  {
    LoadedOnce::StreamMessage message;
    cmsghdr                  *attached = CMSG_FIRSTHDR(&message.header);
    attached->cmsg_level               = SOL_SOCKET;
    attached->cmsg_type                = SCM_RIGHTS;
    attached->cmsg_len                 = CMSG_LEN(sizeof(LoadedOnce::Streams));
    const LoadedOnce::Streams streams  = {{0, 1, 2}};
    std::memcpy(CMSG_DATA(attached), streams.data(), sizeof(streams));
    if (sendmsg(connection, &message.header, MSG_NOSIGNAL) != 1)
      throw std::runtime_error("the standard streams cannot be handed on");

    std::string text;
    const auto  add = [&text](const std::string &part) {
      text += part + '\0';
    };
    char *const directory = get_current_dir_name();
    add(directory != nullptr ? directory : ".");
    std::free(directory);
    add(std::to_string(argc - 1));
    for (int i = 1; i < argc; ++i)
      add(argv[i]);
    for (char **entry = environ; *entry != nullptr; ++entry)
      add(*entry);
    const std::size_t size = text.size();
    LoadedOnce::write_all(connection, &size, sizeof(size));
    LoadedOnce::write_all(connection, text.data(), size);
  }



  extern "C" void
  hand_on(int number)
  {
    const int                      before = errno;
    const char                     byte   = static_cast<char>(number);
    [[maybe_unused]] const ssize_t n = send(connection, &byte, 1, MSG_NOSIGNAL);
    errno                            = before;
  }
} // namespace



int
main(int argc, char **argv)
{
  try
    {
      const std::string program = variable(LoadedOnce::program_variable);
      if (!variable("OMPI_COMM_WORLD_SIZE").empty() ||
          !variable("OPENBLAS_CORETYPE").empty() ||
          !connect_to(variable(LoadedOnce::socket_variable)))
        {
          execv(program.c_str(), argv);
          throw std::runtime_error("cannot start '" + program + "'");
        }

      send_job(argc, argv);
      for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1})
        std::signal(number, hand_on);
      int status = 0;
      LoadedOnce::read_all(connection, &status, sizeof(status));
      if (status < 0)
        {
          std::signal(-status, SIG_DFL);
          std::raise(-status);
        }
      return status;
    }
  catch (const std::exception &error)
    {
      std::cerr << "loaded_once_client: " << error.what() << std::endl;
      return EXIT_FAILURE;
    }
}
