// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_initial_stress_h
#define mechanics_initial_stress_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <memory>
#include <string>

#include "base/expression.h"
#include "base/kinematics.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Initial stress".
  struct InitialStressParameters
  {
    /// Expressions of the position, in the order of the raw entries of a
    /// SymmetricTensor<2, 3>: xx, yy, zz, xy, xz, yz. An empty one is zero.
    std::array<std::string, 6> components;

    void
    add_parameters(ParameterHandler &prm);

    /// Whether a component is given.
    bool
    is_present() const;
  };



  /// The stress that the body bears when its history begins, where it has its
  /// undeformed shape (doc/theory, "Initial stress").
  template <int dim>
  class InitialStress
  {
  public:
    /// None.
    InitialStress() = default;

    /// @throws InputError for what is no expression, and for components that a
    /// body of this @p kinematics does not have.
    InitialStress(const InitialStressParameters &parameters,
                  const Kinematics               kinematics);

    bool
    is_present() const;

    /// @throws InputError if it is not finite, see Expression::value()
    SymmetricTensor<2, 3>
    value(const Point<dim> &point) const;

  private:
    /// By the raw entries of the tensor; none for those that are zero.
    std::array<std::shared_ptr<const Expression<dim>>, 6> expressions;
  };
} // namespace ElastoPlastic

#endif
