// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>

#include "base/exceptions.h"
#include "base/expression.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Keeps what is sent to std::cerr from the user: deal.II prints there what
    /// muParser says, on every rank, before it throws.
    class SilentErrorStream
    {
    public:
      SilentErrorStream()
        : buffer(std::cerr.rdbuf(nullptr))
      {}

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(buffer);
        std::cerr.clear();
      }

    private:
      std::streambuf *const buffer;
    };



    /// What muParser says, as the continuation of a sentence; deal.II adds
    /// more.
    std::string
    reason(const ExceptionBase &exception)
    {
      static const std::regex parser_message("The parser said: ([^\n]*)");
      std::ostringstream      text;
      exception.print_info(text);
      const std::string message = text.str();
      std::smatch       found;
      return std::regex_search(message, found, parser_message) ?
               " (" + found.str(1) + ")" :
               "";
    }
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const std::string &path, const std::string &text)
    : path(path)
    , text(text)
  {
    const std::string variables = (dim == 1 ? "t" :
                                   dim == 2 ? "x,y,t" :
                                              "x,y,z,t");
    try
      {
        const SilentErrorStream silence;
        function.initialize(variables,
                            text,
                            {{"pi", numbers::PI}, {"e", numbers::E}},
                            /* time_dependent = */ dim > 1);
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
    if (dim > 1)
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
        throw InputError(path, text, where.str());
      }
    return result;
  }



  template class Expression<1>;
  template class Expression<2>;
  template class Expression<3>;
} // namespace ElastoPlastic
