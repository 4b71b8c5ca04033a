// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_expression_h
#define indenter_indenter_expression_h

#include <string>

#include "base/expression.h"
#include "indenter/indenter.h"

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
    /// @param reach is where the indenter ends, a distance from the tip; it may
    /// be infinite.
    IndenterExpression(const std::string &path,
                       const std::string &text,
                       const double       reach);

    /// Throws InputError where the value is not finite within the reach.
    double
    profile(const Point<dim - 1> &x) const override;

    /// The derivatives are difference quotients over 1e-4 of the reach, or 1e-5
    /// of the size of the body if that is smaller.
    IndenterSurface<dim>
    surface_for(const Point<dim - 1> &origin,
                const Point<dim - 1> &x,
                const double          body_size) const override;

  private:
    const Expression<2> expression;
    const double        reach;
  };
} // namespace ElastoPlastic

#endif
