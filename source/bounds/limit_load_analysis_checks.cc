// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/exceptions.h"
#include "bounds/error/support_check.h"
#include "bounds/limit_load_analysis.h"
#include "problem/problem_checks.h"

// The problem of a limit load on a mesh, and what can be wrong with it although
// each entry is right. Included by limit_load_analysis.cc, whose local
// functions it uses.

namespace ElastoPlastic
{
  namespace
  {
    /// What is normal to the indenter, in a job that asks for its limit load,
    /// is normal to the sides that it fits.
    /// In space it always presses downwards.
    template <int dim>
    ContactGeometry
    contact_geometry(const Model<dim> &model, const Parameters &parameters)
    {
      const ContactGeometry geometry = model.contact.geometry;
      if (dim == 3 || geometry == ContactGeometry::vertical ||
          model.strain_model.kinematics == Kinematics::plane_stress ||
          parameters.material.criteria.has_soil())
        return ContactGeometry::vertical;
      return parameters.analysis == Analysis::limit_load ?
               geometry :
               ContactGeometry::automatic;
    }



    /// Times r, the pressure of a weight is quadratic: so must the stresses be
    /// whose strength grows with it. In space, make_split_body() has looked at
    /// the loads.
    template <int dim>
    void
    check_loads(const SplitBody<dim> &body, const Parameters &parameters)
    {
      const unsigned int degree = degree_of_stresses(body, parameters);
      if constexpr (dim == 2)
        require_polynomial_tractions(body, degree);
      if (degree == 1 && body.is_axisymmetric() && body.has_friction() &&
          body.body_force.norm() + body.live_body_force.norm() > 0.)
        throw InputError("Limit load/Stresses",
                         Patterns::Tools::to_string(
                           parameters.limit_load.stresses),
                         "beside a 'Body force', bodies of revolution whose "
                         "strength grows with the pressure need 'quadratic' "
                         "stresses. Choose them, or 'automatic'.");
    }



    /// The indenter must reach a face of the @p body. @throws InputError
    template <int dim>
    void
    check_reach_of_indenter(const SplitBody<dim> &body)
    {
      if (std::none_of(body.conditions.begin(),
                       body.conditions.end(),
                       [](const auto &condition) {
                         return condition.is_reached;
                       }))
        throw InputError(
          "The indenter can never touch the body: no part of the contact "
          "boundary lies within its reach. Check 'Indenter/Position', its size "
          "and 'Indenter/Reach'.");
    }



    /// That stresses cannot press on the @p body anywhere, because the indenter
    /// reaches only parts of its faces; empty if they can.
    template <int dim>
    std::string
    warning_of_partial_reach(const SplitBody<dim> &body)
    {
      if (std::any_of(body.conditions.begin(),
                      body.conditions.end(),
                      [](const auto &condition) {
                        return condition.is_pressed();
                      }))
        return "";
      return "The indenter reaches parts of sides of the first mesh only. "
             "Stresses press where it reaches a whole side, and the lower bound "
             "is zero until there is one. Put the edges of the indenter on "
             "vertices of the mesh, or begin with smaller cells.";
    }
  } // namespace



  template <int dim>
  void
  LimitLoadAnalysis<dim>::check()
  {
    check_contact_boundaries(model, triangulation);
    check_symmetry_of_materials(model, triangulation);
    setup_body();
    if (gap_function.has_indenter())
      check_symmetry_of_indenter(model, gap_function, triangulation);
    check_supports_of_limit_load(model,
                                 parameters.limit_load.load,
                                 gap_function,
                                 triangulation);
    warn_if_any(log, warning_of_curved_body(triangulation));
    if (first_rank && model.indenter.shape)
      warn_if_any(log, warning_of_partial_reach(body));
  }



  // For the first rank.
  template <int dim>
  void
  LimitLoadAnalysis<dim>::setup_body()
  {
    auto mesh = make_split_mesh(triangulation);
    rethrow_collectively(communicator, [&]() {
      if (!first_rank)
        return;
      const Loads<dim> mesh_loads        = loads(mesh);
      body                               = make_split_body<dim>(std::move(mesh),
                                  model.boundary_conditions,
                                  model.materials,
                                  {[this](const Point<dim> &x) {
                                     return gap_function.value(x);
                                   },
                                                                 parameters.indenter.surface,
                                                                 contact_geometry(model, parameters),
                                                                 gap_function.footprint()},
                                  mesh_loads,
                                  model.strain_model.kinematics);
      const MaterialParameters &material = parameters.material;
      body.set_friction(
        material.criteria.friction_slopes(material.n_materials()));
      check_loads(body, parameters);
      if (model.indenter.shape)
        check_reach_of_indenter(body);
      if (!model.indenter.shape && body.load_factor_unit == 0)
        throw ConvergenceError("No load acts on the body.");
    });
  }
} // namespace ElastoPlastic
