// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_silent_error_stream_h
#define base_silent_error_stream_h

#include <iostream>

namespace ElastoPlastic
{
  /// As long as it lives, keeps what is sent to std::cerr from the user: what
  /// libraries print there, on every rank, before they report an error.
  class SilentErrorStream
  {
  public:
    SilentErrorStream()
      : buffer(std::cerr.rdbuf(nullptr))
    {}

    ~SilentErrorStream()
    {
      std::cerr.rdbuf(buffer); // clears the state, too
    }

    SilentErrorStream(const SilentErrorStream &) = delete;
    SilentErrorStream &
    operator=(const SilentErrorStream &) = delete;

  private:
    std::streambuf *const buffer;
  };
} // namespace ElastoPlastic

#endif
