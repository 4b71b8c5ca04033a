// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_expression_h
#define base_expression_h

#include <deal.II/base/function_parser.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// What an expression may depend on, besides constants.
  enum class ExpressionVariables
  {
    position_and_time, ///< with dim = 1 the time alone
    position
  };



  /// A scalar function of position and time that a user has typed, in the
  /// variables x, y (, z) and t and with everything muParser knows, but for
  /// lists and assignments: there, a decimal comma or a '=' instead of '=='
  /// would give another number in silence. With dim = 1, it is a function of
  /// time alone, which then is the coordinate of the point. It is parsed on
  /// construction.
  template <int dim>
  class Expression
  {
  public:
    /// @p path is the entry the text comes from, for error messages.
    /// @throws InputError if @p text is no such expression.
    Expression(const std::string        &path,
               const std::string        &text,
               const ExpressionVariables variables =
                 ExpressionVariables::position_and_time);

    /// A function of position should be evaluated within
    /// rethrow_collectively(): each rank has points of its own. Elsewhere, a
    /// value that is not finite takes all ranks down, so that none waits for
    /// ever. All ranks take functions of time at the same times.
    /// @throws InputError if the value is not finite.
    double
    value(const Point<dim> &point, const double time = 0) const;

  private:
    const std::string           path;
    const std::string           text;
    const bool                  time_is_variable;
    mutable FunctionParser<dim> function;
  };
} // namespace ElastoPlastic

#endif
