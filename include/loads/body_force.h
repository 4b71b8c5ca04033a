// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_body_force_h
#define loads_body_force_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

#include "base/expression.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entry "Body force".
  struct BodyForceParameters
  {
    std::string components;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// A force per volume that acts in the whole body, for instance its weight.
  template <int dim>
  class BodyForce
  {
  public:
    /// None.
    BodyForce() = default;

    /// @param components "component; component", expressions of position and
    /// time, or nothing. @throws InputError
    explicit BodyForce(const std::string &components);

    bool
    is_present() const;

    /// In a body with finite strains, per volume of the undeformed body.
    /// @throws InputError if it is not finite, see Expression::value()
    Tensor<1, dim>
    value(const Point<dim> &point, const double time) const;

  private:
    /// One for each component, or none.
    std::vector<std::shared_ptr<const Expression<dim>>> expressions;
  };
} // namespace ElastoPlastic

#endif
