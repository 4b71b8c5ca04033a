// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_to_text_h
#define base_to_text_h

#include <sstream>
#include <string>

namespace ElastoPlastic
{
  /// A number in a message, which may be infinite or none: deal.II's patterns
  /// refuse to write such.
  inline std::string
  to_text(const double value)
  {
    std::ostringstream text;
    text.precision(10);
    text << value;
    return text.str();
  }
} // namespace ElastoPlastic

#endif
