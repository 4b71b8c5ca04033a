// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loaded_once_h
#define loaded_once_h

// What loaded_once_client.cc, which is started in the place of a program, says
// to loaded_once.cc, which has loaded the program, through a connection of a
// local socket. A job is
//
// - one byte, with the descriptors of the standard streams 0, 1 and 2 attached;
// - the length of what follows, as std::size_t;
// - strings, each ended by a zero: the working directory, the number of
//   arguments, the arguments without the name of the program, and the
//   environment, NAME=VALUE.
//
// Meanwhile each byte is a signal for the process that does the job, which is
// killed where the connection ends. The answer is an int: the exit status, or
// minus the signal that has ended the process.

#include <array>
#include <cstddef>
#include <stdexcept>

#include <sys/socket.h>
#include <unistd.h>

namespace LoadedOnce
{
  /// The environment's variables for the path of the socket, for the program
  /// itself, and, in the process that loads it, for the descriptor at which it
  /// waits for connections.
  inline constexpr char socket_variable[]   = "LOADED_ONCE_SOCKET";
  inline constexpr char program_variable[]  = "LOADED_ONCE_PROGRAM";
  inline constexpr char listener_variable[] = "LOADED_ONCE_LISTENER";

  using Streams = std::array<int, 3>;



  /// A message of one byte with room for the descriptors of three streams.
  struct StreamMessage
  {
    StreamMessage()
    {
      header.msg_iov        = &part;
      header.msg_iovlen     = 1;
      header.msg_control    = room;
      header.msg_controllen = sizeof(room);
    }

    StreamMessage(const StreamMessage &) = delete;
    StreamMessage &
    operator=(const StreamMessage &) = delete;

    char  byte                                              = 0;
    iovec part                                              = {&byte, 1};
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof(Streams))] = {};
    msghdr header                                           = {};
  };



  /// Throws std::runtime_error if the other side is gone.
  inline void
  write_all(const int connection, const void *data, std::size_t size)
  {
    for (auto *next = static_cast<const char *>(data); size > 0;)
      {
        const ssize_t n = send(connection, next, size, MSG_NOSIGNAL);
        if (n <= 0)
          throw std::runtime_error("the other side is gone");
        next += n;
        size -= static_cast<std::size_t>(n);
      }
  }



  /// Throws std::runtime_error if the other side is gone.
  inline void
  read_all(const int connection, void *data, std::size_t size)
  {
    for (auto *next = static_cast<char *>(data); size > 0;)
      {
        const ssize_t n = TEMP_FAILURE_RETRY(read(connection, next, size));
        if (n <= 0)
          throw std::runtime_error("the other side is gone");
        next += n;
        size -= static_cast<std::size_t>(n);
      }
  }
} // namespace LoadedOnce

#endif
