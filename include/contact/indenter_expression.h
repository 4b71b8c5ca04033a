// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_indenter_expression_h
#define contact_indenter_expression_h

#include <string>

#include "base/expression.h"
#include "contact/indenter.h"

namespace ElastoPlastic
{
  /// An indenter whose profile a user has typed in the horizontal coordinates
  /// x and y. In two dimensions it is the section y = 0.
  template <int dim>
  class IndenterExpression : public Indenter<dim>
  {
  public:
    /// @param path is the entry the text comes from. A text that does not parse
    /// is an InputError.
    IndenterExpression(const std::string &path, const std::string &text);

    /// Throws InputError where the value is not finite.
    double
    profile(const Point<dim - 1> &x) const override;

  private:
    const Expression<2> expression;
  };
} // namespace ElastoPlastic

#endif
