// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cmath>

#include "base/exceptions.h"
#include "base/text.h"
#include "loading/indenter_path.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string path = "Loading/Path";
  }



  IndenterPath::IndenterPath(const std::string &text)
    : text(Utilities::trim(text))
  {
    if (this->text.empty())
      return;
    if (this->text.find('|') != std::string::npos ||
        as_number(this->text.substr(0, this->text.find(':'))))
      read_table();
    else
      read_expressions();
  }



  void
  IndenterPath::take_n_components(const std::vector<std::string> &words)
  {
    if (n_components > 0 && words.size() != n_components)
      throw InputError(path,
                       text,
                       "all rows must have the same number of components.");
    n_components = words.size();
    if (n_components < 1 || n_components > 2)
      throw InputError(path,
                       text,
                       "the indenter moves in one direction in the plane, in "
                       "two in space.");
  }



  void
  IndenterPath::read_table()
  {
    rows[0.] = {};
    for (const std::string &row : split(path, text, '|'))
      {
        const auto                     colon = row.find(':');
        const auto                     time  = as_number(row.substr(0, colon));
        const std::vector<std::string> words =
          colon == std::string::npos ? std::vector<std::string>() :
                                       split(path, row.substr(colon + 1), ',');
        Tensor<1, 2> displacement;
        bool         is_row = time && std::isfinite(*time) && !words.empty();
        for (unsigned int d = 0; is_row && d < words.size(); ++d)
          {
            const auto number = as_number(words[d]);
            is_row            = number && std::isfinite(*number);
            if (is_row && d < 2)
              displacement[d] = *number;
          }
        if (!is_row)
          throw InputError(path,
                           row,
                           "a row must look like '1.5: 0.02', or in space "
                           "'1.5: 0.02, 0': a time, then how far the indenter "
                           "has moved sideways then, in x (and y). Rows are "
                           "separated by '|'.");
        take_n_components(words);
        if (*time <= rows.rbegin()->first)
          throw InputError(path,
                           row,
                           "the times must increase, and the first must be "
                           "greater than 0.");
        rows[*time] = displacement;
      }
  }



  void
  IndenterPath::read_expressions()
  {
    const auto words = split(path, text, ';');
    take_n_components(words);
    for (const std::string &word : words)
      expressions.push_back(std::make_shared<const Expression<1>>(path, word));
    if (displacement(0.).norm() > 0.)
      throw InputError(
        path,
        text,
        "at t = 0 the indenter is at 'Indenter/Position': there, "
        "the expression must be 0.");
  }



  void
  IndenterPath::check_components(const unsigned int n) const
  {
    if (!is_at_rest() && n_components != n)
      throw InputError(path,
                       text,
                       n == 1 ?
                         "in two dimensions the indenter moves along x "
                         "only: give one number a row, or one "
                         "expression." :
                         "in three dimensions the indenter moves along x "
                         "and y: give two numbers a row, such as '1: "
                         "0.5, 0', or two expressions separated by "
                         "';'.");
  }



  std::vector<double>
  IndenterPath::corners() const
  {
    std::vector<double> times;
    for (const auto &[time, displacement] : rows)
      if (time > 0.)
        times.push_back(time);
    return times;
  }



  Tensor<1, 2>
  IndenterPath::displacement(const double time) const
  {
    Tensor<1, 2> result;
    for (unsigned int d = 0; d < expressions.size(); ++d)
      result[d] = expressions[d]->value(Point<1>(time));
    if (rows.empty())
      return result;
    const auto next = rows.lower_bound(time);
    if (next == rows.end())
      return rows.rbegin()->second;
    if (next == rows.begin())
      return next->second;
    const auto   last     = std::prev(next);
    const double fraction = (time - last->first) / (next->first - last->first);
    return (1. - fraction) * last->second + fraction * next->second;
  }
} // namespace ElastoPlastic
