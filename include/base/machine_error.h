// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_machine_error_h
#define base_machine_error_h

#include <exception>
#include <optional>

#include "base/exceptions.h"

namespace ElastoPlastic
{
  /// What a user is told where the machine is at its limits, which the standard
  /// library says by exceptions of its own: no memory, or a file or folder that
  /// cannot be used. Nothing for any other exception, which is a bug.
  std::optional<FileError>
  machine_error(const std::exception &exception);
} // namespace ElastoPlastic

#endif
