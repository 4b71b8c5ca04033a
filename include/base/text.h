// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_text_h
#define base_text_h

#include <deal.II/base/utilities.h>

#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// The number that @p text is, if it is one. It may be infinite.
  inline std::optional<double>
  as_number(const std::string &text)
  {
    try
      {
        std::size_t  end   = 0;
        const double value = std::stod(text, &end);
        if (dealii::Utilities::trim(text.substr(end)).empty())
          return value;
      }
    catch (const std::exception &)
      {}
    return {};
  }



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



  /// The parts of the value @p text of the entry @p path between separators,
  /// without blanks around them; none of an empty text.
  /// @throws InputError if a part is empty, be it the last: then a separator
  /// is too many, or what belongs beside it has been forgotten.
  std::vector<std::string>
  split(const std::string &path, const std::string &text, const char separator);



  /// How many letters have to be inserted, removed or replaced to turn @p a
  /// into @p b; capitals are as good as small letters.
  unsigned int
  edit_distance(const std::string &a, const std::string &b);

  /// Completes a message that there is no @p path, such as "Material/Low": "
  /// Did you mean 'Material/Law'?" with the closest of @p paths. What comes
  /// after the last slash must be similar; the rest decides between several.
  /// Empty if nothing is similar.
  std::string
  did_you_mean(const std::string &path, const std::vector<std::string> &paths);



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
