// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/exceptions.h"
#include "base/input_file.h"
#include "base/rethrow_collectively.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Whether every other byte of the beginning is zero: English text in
    /// UTF-16.
    bool
    looks_like_utf_16(const std::string &bytes)
    {
      return bytes.size() >= 4 && ((bytes[0] == 0) != (bytes[1] == 0)) &&
             (bytes[0] == 0) == (bytes[2] == 0) &&
             (bytes[1] == 0) == (bytes[3] == 0);
    }



    bool
    begins_with(const std::string &bytes, const std::string &mark)
    {
      return bytes.compare(0, mark.size(), mark) == 0;
    }
  } // namespace



  std::string
  read_input_file(const std::string &path, const std::string &name)
  {
    std::string bytes;
    on_first_rank(MPI_COMM_WORLD, [&]() {
      std::error_code ignored;
      std::ifstream   stream;
      if (std::filesystem::is_regular_file(name, ignored))
        stream.open(name, std::ios::binary);
      if (!stream.is_open())
        throw InputError(path,
                         name,
                         "there is no such file, or it cannot be read. A "
                         "relative name starts in the folder of the parameter "
                         "file.");
      bytes.assign(std::istreambuf_iterator<char>(stream), {});
    });
    return Utilities::MPI::broadcast(MPI_COMM_WORLD, bytes);
  }



  std::string
  plain_text(const std::string                              &bytes,
             const std::function<void(const std::string &)> &reject)
  {
    const std::string remedy =
      " Save it as plain text, or as UTF-8 without byte order mark.";
    if (begins_with(bytes, "\xFF\xFE") || begins_with(bytes, "\xFE\xFF") ||
        looks_like_utf_16(bytes))
      reject("is in UTF-16, which some editors call Unicode." + remedy);
    if (begins_with(bytes, "\xEF\xBB\xBF"))
      reject("begins with a byte order mark, which editors do not show." +
             remedy);

    std::string text;
    text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
      if (bytes[i] != '\r')
        text += bytes[i];
      else if (bytes.compare(i, 2, "\r\n") != 0)
        text += '\n';
    return text;
  }
} // namespace ElastoPlastic
