// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_input_file_h
#define base_input_file_h

#include <functional>
#include <string>

namespace ElastoPlastic
{
  /// The bytes of the file @p name, which the entry @p path names. The first
  /// rank reads it for all of them: on another machine, the file may be missing
  /// or another one. All ranks call this.
  /// @throws InputError if it cannot be read.
  std::string
  read_input_file(const std::string &path, const std::string &name);

  /// The text that @p bytes are, with '\n' at the ends of lines, be they those
  /// of Unix, of Windows or of an old Mac. Where editors have saved something
  /// else than plain text or UTF-8, @p reject is told so, in words that
  /// complete "the file ...".
  std::string
  plain_text(const std::string                              &bytes,
             const std::function<void(const std::string &)> &reject);
} // namespace ElastoPlastic

#endif
