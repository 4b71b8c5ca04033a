// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/exceptions.h"
#include "indenter/height_file.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Whether every other comma, beginning with the first, has no blank behind
    /// it, and only those: so are lists of numbers with decimal commas.
    bool
    has_decimal_commas(const std::string &line)
    {
      if (line.find('.') != std::string::npos)
        return false;
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



    /// Whether numbers like 0,125, one below the other, are what the file
    /// holds: lines with one comma each, nothing but digits behind it, and no
    /// other sign that it separates.
    bool
    is_column_with_decimal_commas(const HeightFile &file)
    {
      std::istringstream lines(file.text());
      std::string        line;
      while (std::getline(lines, line))
        {
          line = Utilities::trim(line.substr(0, line.find('#')));
          if (line.empty())
            continue;
          const std::size_t comma = line.find(',');
          if (comma == std::string::npos ||
              line.find_first_of(". \t") != std::string::npos ||
              line.find_first_not_of("0123456789", comma + 1) !=
                std::string::npos)
            return false;
        }
      return true;
    }



    /// Whether the rows are the points of a lattice, x y z, all combinations of
    /// the x and y that there are.
    bool
    is_list_of_points(const std::vector<double> &numbers,
                      const unsigned int         n_columns)
    {
      if (n_columns != 3)
        return false;
      std::set<double>                    x, y;
      std::set<std::pair<double, double>> points;
      for (std::size_t i = 0; i < numbers.size(); i += n_columns)
        {
          x.insert(numbers[i]);
          y.insert(numbers[i + 1]);
          points.emplace(numbers[i], numbers[i + 1]);
        }
      return x.size() > 1 && y.size() > 1 &&
             points.size() == x.size() * y.size() &&
             points.size() * n_columns == numbers.size();
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
    if (n_rows > 1 && is_column_with_decimal_commas(file))
      file.reject(
        "all lines are two numbers without a decimal point, with a "
        "comma between them. " +
        decimal_point_hint +
        " If these are two columns, put a blank behind the commas.");
    if (is_list_of_points(numbers, n_columns))
      file.reject(
        "its rows are the points of a lattice, x y z. A height matrix "
        "holds heights only: a row for each y, from the largest to "
        "the smallest, with a number for each x.");
    return {n_rows, n_columns, numbers.begin()};
  }
} // namespace ElastoPlastic
