// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_gap_function_h
#define contact_gap_function_h

#include <memory>

#include "contact/indenter.h"
#include "contact/indenter_parameters.h"

namespace ElastoPlastic
{
  /// The gap function g of doc/theory.md, "Johnson's formulation": an indenter
  /// that stands above the body. The last coordinate points up.
  template <int dim>
  class GapFunction
  {
  public:
    /// @param parameters must have passed their check. What is wrong in an
    /// expression or a file that they name is an InputError.
    /// @param surface_height is the last coordinate of the plane top surface.
    GapFunction(const IndenterParameters &parameters,
                const double              surface_height);

    /// False for the type "none".
    bool
    has_indenter() const;

    /// The horizontal position of the indenter.
    const Point<dim - 1> &
    position() const;

    /// The vertical distance from the point @p p of the undeformed body up to
    /// the undisplaced indenter; +infinity outside Gamma_0, where the indenter
    /// does not reach.
    double
    value(const Point<dim> &p) const;

  private:
    const std::unique_ptr<const Indenter<dim>> indenter;
    const Point<dim - 1>                       indenter_position;
    const double                               reach;
    const double                               tip_height;
  };
} // namespace ElastoPlastic

#endif
