// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

#include "base/exceptions.h"
#include "base/expression.h"
#include "base/process.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What muParser says, as the continuation of a sentence; deal.II adds
    /// more.
    std::string
    reason(const ExceptionBase &exception)
    {
      static const std::string before = "The parser said: ";
      std::ostringstream       text;
      exception.print_info(text);
      const std::string message = text.str();
      const auto        begin   = message.rfind(before);
      if (begin == std::string::npos)
        return "";
      const auto end = message.find('\n', begin);
      return " (" +
             message.substr(begin + before.size(),
                            end - begin - before.size()) +
             ")";
    }



    /// Whether the bracket at @p position opens the arguments of a function.
    bool
    opens_arguments(const std::string &text, const std::size_t position)
    {
      const std::string before = Utilities::trim(text.substr(0, position));
      return !before.empty() &&
             (std::isalnum(before.back()) || before.back() == '_');
    }



    /// Where a ',' stands that does not separate arguments of a function.
    std::size_t
    find_stray_comma(const std::string &text)
    {
      std::vector<bool> in_arguments = {false}; // by open brackets
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '(')
          in_arguments.push_back(opens_arguments(text, i));
        else if (text[i] == ')' && in_arguments.size() > 1)
          in_arguments.pop_back();
        else if (text[i] == ',' && !in_arguments.back())
          return i;
      return std::string::npos;
    }



    /// Whether there is a '=' that is no part of '==', '<=', '>=' or '!='.
    bool
    has_assignment(const std::string &text)
    {
      static const std::string comparing = "=<>!";
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=' &&
            (i == 0 || comparing.find(text[i - 1]) == std::string::npos) &&
            text.substr(i + 1, 1) != "=")
          return true;
      return false;
    }



    /// Whether the '-' at @p position is that of a number.
    bool
    is_sign(const std::string &text, const std::size_t position)
    {
      const std::string before = Utilities::trim(text.substr(0, position));
      return text[position] == '-' &&
             (before.empty() ||
              !(std::isalnum(before.back()) || before.back() == ')'));
    }



    /// The number with a decimal point that a ',' between digits looks like.
    std::string
    with_decimal_point(const std::string &text, const std::size_t comma)
    {
      static const std::string digits = "0123456789";
      std::size_t              begin =
        comma == 0 ? 0 : text.find_last_not_of(digits, comma - 1) + 1;
      const bool is_empty = begin == comma;
      if (begin > 0 && is_sign(text, begin - 1))
        --begin;
      const std::size_t end      = text.find_first_not_of(digits, comma + 1);
      const std::string whole    = text.substr(begin, comma - begin),
                        fraction = text.substr(comma + 1, end - comma - 1);
      return is_empty || fraction.empty() ? "" : whole + "." + fraction;
    }



    /// Refuses what muParser takes for something else than is meant.
    void
    check_text(const std::string &path, const std::string &text)
    {
      const std::size_t comma = find_stray_comma(text);
      if (comma != std::string::npos)
        {
          const std::string number = with_decimal_point(text, comma);
          throw InputError(path,
                           text,
                           "a ',' can only stand between the arguments of a "
                           "function. " +
                             (number.empty() ?
                                "An expression has a single value." :
                                "Numbers have a decimal point: write " +
                                  number + "."));
        }
      if (text.find(';') != std::string::npos)
        throw InputError(path,
                         text,
                         "a ';' stands between the components of a vector, and "
                         "this expression has a single value.");
      if (has_assignment(text))
        throw InputError(path,
                         text,
                         "a '=' would give a variable another value. Write "
                         "'==' to compare.");
    }
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const std::string        &path,
                              const std::string        &text,
                              const ExpressionVariables dependence)
    : path(path)
    , text(text)
    , time_is_variable(dim > 1 &&
                       dependence == ExpressionVariables::position_and_time)
  {
    const std::string coordinates = dim == 1 ? "t" :
                                    dim == 2 ? "x,y" :
                                               "x,y,z",
                      variables = coordinates + (time_is_variable ? ",t" : "");
    check_text(path, text);
    try
      {
        const SilentErrorStream silence;
        function.initialize(variables,
                            text,
                            {{"pi", numbers::PI}, {"e", numbers::E}},
                            time_is_variable);
        function.value(Point<dim>()); // deal.II parses at the first use
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(path,
                         text,
                         "this is not an expression in " + variables +
                           " that can be evaluated" + reason(exception) + ".");
      }
  }



  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &point, const double time) const
  {
    if (time_is_variable)
      function.set_time(time);
    const double result = function.value(point);
    if (!std::isfinite(result))
      {
        std::ostringstream where;
        if (dim == 1)
          where << "at t = " << point;
        else
          where << "at (" << point << ") and t = " << time;
        where << " its value is "
              << (std::isnan(result) ? "not a number" : "infinite")
              << ". It must be finite wherever it is needed.";
        const InputError error(path, text, where.str());
        AssertThrow(dim == 1 || may_throw_alone(), ExcMessage(error.what()));
        throw error;
      }
    return result;
  }



  template class Expression<1>;
  template class Expression<2>;
  template class Expression<3>;
} // namespace ElastoPlastic
