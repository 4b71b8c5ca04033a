// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_loaded_body_h
#define loads_loaded_body_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <string>
#include <vector>

#include "base/expression.h"
#include "base/kinematics.h"
#include "loads/boundary_conditions.h"

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
    is_present() const
    {
      return !expressions.empty();
    }

    /// In a body with finite strains, per volume of the undeformed body.
    /// @throws InputError if it is not finite, see Expression::value()
    Tensor<1, dim>
    value(const Point<dim> &point, const double time) const;

  private:
    /// One for each component, or none.
    std::vector<std::shared_ptr<const Expression<dim>>> expressions;
  };



  /// What holds and loads the body, but for the indenter, and what its strains
  /// are.
  template <int dim>
  struct LoadedBody
  {
    BoundaryConditions<dim> boundary_conditions;
    BodyForce<dim>          body_force;
    StrainModel             strain_model;
  };



  /// Computes the nodal forces int traction . phi_i ds and int f . phi_i dx of
  /// the tractions and body forces f of @p body at @p time, condensed with @p
  /// constraints. @p forces has its layout. Collective.
  template <int dim>
  void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &forces,
                          const DoFHandler<dim>           &dof_handler,
                          const AffineConstraints<double> &constraints,
                          const LoadedBody<dim>           &body,
                          const double                     time);
} // namespace ElastoPlastic

#endif
