// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_height_file_h
#define contact_height_file_h

#include <cstddef>
#include <string>

namespace ElastoPlastic
{
  /// A whole input file in memory, with what an error message about it needs.
  class HeightFile
  {
  public:
    /// Read the file. @p path is the entry that names it. A file that cannot
    /// be read is an InputError.
    HeightFile(const std::string &path, const std::string &name);

    /// Throw an InputError about this file. @p what completes "..., but ".
    [[noreturn]] void
    reject(const std::string &what) const;

    /// Reject a header that promises no pixel or more than 3*10^7, whose
    /// heights take 240 MB on every rank.
    void
    check_n_pixels(const std::size_t width, const std::size_t height) const;

    /// Whether the file begins with these bytes.
    bool
    begins_with(const std::string &signature) const;

    const std::string path;
    const std::string name;
    const std::string content;
  };
} // namespace ElastoPlastic

#endif
