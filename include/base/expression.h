// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_expression_h
#define base_expression_h

#include <deal.II/base/function_parser.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A scalar function of position and time that a user has typed, in the
  /// variables x, y (, z) and t and with everything muParser knows; with dim =
  /// 1, of time alone, which then is the coordinate of the point. It is
  /// parsed on construction; what does not parse, and a value that is not
  /// finite, is an InputError that names the entry.
  template <int dim>
  class Expression
  {
  public:
    /// @p path is the entry the text comes from, for error messages.
    Expression(const std::string &path, const std::string &text);

    double
    value(const Point<dim> &point, const double time = 0) const;

  private:
    const std::string           path;
    const std::string           text;
    mutable FunctionParser<dim> function;
  };
} // namespace ElastoPlastic

#endif
