// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "base/exceptions.h"
#include "contact/height_file.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Whether every other comma, beginning with the first, has no blank behind
    /// it, and only those: so are lists of numbers with decimal commas.
    bool
    has_decimal_commas(const std::string &line)
    {
      unsigned int n_commas = 0;
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (line[i] == ',')
          if ((std::isspace(static_cast<unsigned char>(line[i + 1])) != 0) !=
              (++n_commas % 2 == 0))
            return false;
      return n_commas > 1;
    }



    /// The numbers of one line; @p place is where it stands, for messages.
    std::vector<double>
    decode_row(const HeightFile  &file,
               const std::string &line,
               const std::string &place)
    {
      if (has_decimal_commas(line))
        file.reject("numbers" + place +
                    " have commas, with and without white "
                    "space behind them in turn. " +
                    decimal_point_hint);
      std::vector<double> row;
      for (const std::string &field : Utilities::split_string_list(line, ','))
        {
          std::istringstream words(field);
          std::string        word;
          if (!(words >> word))
            file.reject("two commas" + place + " have no number between them.");
          const std::size_t n_before = row.size();
          do
            {
              char *end = nullptr;
              row.push_back(std::strtod(word.c_str(), &end));
              if (end != word.c_str() + word.size() ||
                  !std::isfinite(row.back()))
                file.reject("number " + std::to_string(row.size()) + place +
                            " is not a finite number. A height matrix holds "
                            "numbers, white space, commas and comments that "
                            "begin with '#'.");
          } while (words >> word);
          if (row.size() > n_before + 1 && field.size() < line.size())
            file.reject("numbers" + place +
                        " are separated by white space, and by commas too. " +
                        decimal_point_hint);
        }
      return row;
    }
  } // namespace



  Table<2, double>
  decode_matrix(const HeightFile &file)
  {
    std::vector<double> numbers;
    unsigned int        n_rows = 0, n_columns = 0;

    std::istringstream lines(file.text());
    std::string        line;
    for (unsigned int line_number = 1; std::getline(lines, line); ++line_number)
      {
        line = Utilities::trim(line.substr(0, line.find('#')));
        if (line.empty())
          continue;

        const std::string place = " in line " + std::to_string(line_number);
        const std::vector<double> row = decode_row(file, line, place);
        if (n_rows == 0)
          n_columns = row.size();
        if (row.size() != n_columns)
          file.reject("the row" + place + " has length " +
                      std::to_string(row.size()) + ", the ones before it " +
                      std::to_string(n_columns) +
                      ". All rows must have the same length.");
        numbers.insert(numbers.end(), row.begin(), row.end());
        ++n_rows;
      }

    if (numbers.empty())
      file.reject("this file holds no numbers.");
    return {n_rows, n_columns, numbers.begin()};
  }
} // namespace ElastoPlastic
