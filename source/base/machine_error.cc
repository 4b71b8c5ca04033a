// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <filesystem>
#include <new>

#include "base/machine_error.h"

namespace ElastoPlastic
{
  std::optional<FileError>
  machine_error(const std::exception &exception)
  {
    if (dynamic_cast<const std::bad_alloc *>(&exception))
      return FileError(
        "there is not enough memory. Choose a coarser mesh, or "
        "more processes on more machines.");
    if (dynamic_cast<const std::filesystem::filesystem_error *>(&exception))
      return FileError(std::string("a file or folder cannot be used: ") +
                       exception.what());
    return {};
  }
} // namespace ElastoPlastic
