// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_reactions_h
#define loads_reactions_h

#include <string>
#include <vector>

#include "loads/supports.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The forces of the supports on the body, boundary by boundary: the virtual
  /// work on a displacement field that is one at the nodes of a boundary and
  /// zero at all other nodes, in each direction that the boundary holds. An
  /// unknown that several boundaries hold is shared equally between them, so
  /// that the forces of all boundaries add up to what the body needs for its
  /// equilibrium (doc/theory, "Reactions").
  ///
  /// In an axisymmetric body there is the axial direction only, of whole rings.
  template <int dim>
  class Reactions
  {
  public:
    /// All arguments must outlive this object. They may change: mesh, unknowns
    /// and supports are those at the time of a call.
    Reactions(const LoadedBody<dim> &body,
              const DoFHandler<dim> &dof_handler,
              const Supports<dim>   &supports)
      : body(body)
      , dof_handler(dof_handler)
      , supports(supports)
    {}


    /// "top_x", "top_y": boundary and direction of each force.
    std::vector<std::string>
    names() const;

    /// The forces at @p time, in the order of names(). @p contact_forces are
    /// the nodal forces of the indenter on the body. Collective.
    std::vector<double>
    compute(const SolidOperator<dim> &solid,
            const VectorType         &displacement,
            const VectorType         &contact_forces,
            const double              time) const;

    /// The sum of all vertical ones, at the cost of one. Collective.
    double
    vertical_force(const SolidOperator<dim> &solid,
                   const VectorType         &displacement,
                   const VectorType         &contact_forces,
                   const double              time) const;

  private:
    struct Component
    {
      std::string        name;
      types::boundary_id boundary;
      unsigned int       direction;
    };

    std::vector<Component>
    components() const;

    /// The unknowns of this rank that a component is about.
    IndexSet
    unknowns(const Component &component) const;

    /// All nodal forces but those of the supports, condensed with the hanging
    /// nodes only, not with skew rollers.
    VectorType
    loads_on_body(const VectorType &contact_forces, const double time) const;

    /// What all forces but @p loads do on the field that @p motion gives on the
    /// supports, which becomes continuous.
    double
    work(const SolidOperator<dim> &solid,
         const VectorType         &displacement,
         const VectorType         &loads,
         VectorType               &motion) const;

    const LoadedBody<dim> &body;
    const DoFHandler<dim> &dof_handler;
    const Supports<dim>   &supports;
  };
} // namespace ElastoPlastic

#endif
