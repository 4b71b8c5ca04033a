// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <utility>

#include "base/exceptions.h"
#include "base/text.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Nobody has misspelt a longer one.
    constexpr std::size_t longest_name = 100;



    bool
    is_same_letter(const unsigned char a, const unsigned char b)
    {
      return std::tolower(a) == std::tolower(b);
    }



    /// What comes before and after the last slash.
    std::pair<std::string, std::string>
    split_at_last_slash(const std::string &path)
    {
      const auto slash = path.rfind('/');
      return slash == std::string::npos ?
               std::make_pair(std::string(), path) :
               std::make_pair(path.substr(0, slash), path.substr(slash + 1));
    }
  } // namespace



  std::vector<std::string>
  split(const std::string &path, const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    if (dealii::Utilities::trim(text).empty())
      return parts;
    std::istringstream rest(text + separator);
    for (std::string part; std::getline(rest, part, separator);)
      {
        parts.push_back(dealii::Utilities::trim(part));
        if (parts.back().empty())
          throw InputError(path,
                           text,
                           "number " + std::to_string(parts.size()) +
                             " of the parts that '" + separator +
                             "' separates is empty. Is one '" + separator +
                             "' too many, or has something been forgotten?" +
                             (separator == '|' &&
                                  text.find("||") != std::string::npos ?
                                " (In an expression, 'or' is max(a, b): '||' "
                                "would separate parts.)" :
                                ""));
      }
    return parts;
  }



  // Row i of the table holds the distances of the first i letters of a to the
  // beginnings of b.
  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    std::vector<unsigned int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i)
      {
        unsigned int diagonal = row[0];
        row[0]                = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
          {
            const unsigned int replaced =
              diagonal + !is_same_letter(a[i - 1], b[j - 1]);
            diagonal = row[j];
            row[j]   = std::min({row[j] + 1, row[j - 1] + 1, replaced});
          }
      }
    return row.back();
  }



  std::string
  did_you_mean(const std::string &path, const std::vector<std::string> &paths)
  {
    if (path.size() > longest_name)
      return "";
    const auto [section, name] = split_at_last_slash(path);
    const unsigned int farthest =
      std::max<unsigned int>(1, (name.size() + 1) / 3);

    std::string                           closest;
    std::pair<unsigned int, unsigned int> smallest = {farthest + 1, 0};
    for (const std::string &candidate : paths)
      {
        const auto [other_section, other_name] = split_at_last_slash(candidate);
        const unsigned int between_sections =
          edit_distance(section, other_section);
        const std::pair<unsigned int, unsigned int> distance = {
          edit_distance(name, other_name) + (between_sections > 0 ? 1 : 0),
          between_sections};
        if (distance < smallest)
          {
            smallest = distance;
            closest  = candidate;
          }
      }
    return closest.empty() ? "" : " Did you mean '" + closest + "'?";
  }



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
