// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "output/columns.h"

// A line for each column, however long.
// clang-format off
namespace ElastoPlastic
{
  namespace
  {
    std::function<double(const MeshChange &)>
    on_old_mesh(double SolveResult::*const value)
    {
      return [value](const MeshChange &change) { return change.before.*value; };
    }



    std::function<double(const MeshChange &)>
    on_new_mesh(double SolveResult::*const value)
    {
      return [value](const MeshChange &change) { return change.after.*value; };
    }
  } // namespace



  const Columns<SolveResult> &
  statistics_columns()
  {
    using R = SolveResult;
    static const Columns<R> columns = {
      {"step", "1", "load step", &R::step},
      {"cycle", "1", "number of the mesh, from 0", &R::cycle},
      {"cells", "1", "of the mesh", &R::cells},
      {"dofs", "1", "unknowns, those of hanging nodes included", &R::dofs},
      {"newton_iterations", "1", "of the solve", &R::newton_iterations},
      {"linear_iterations", "1", "of the solve, all Newton steps together", &R::linear_iterations},
      {"active_nodes", "1", "nodes in contact", &R::active_nodes},
      {"force", "force", "of the indenter", &R::force},
      {"depth", "length", "of the indenter", &R::depth},
      {"residual", "1", "forces on the free unknowns relative to all forces (after unloading: to those there have been), at the end", &R::residual},
      {"force_balance_error", "1", "contact force against reactions and tractions, relative to the largest sum of all nodal forces so far", &R::force_balance_error},
      {"max_penetration", "length", "largest violation of the contact conditions of the nodes", &R::max_penetration},
      {"complementarity_error", "1", "sum of force times distance over force times depth", &R::complementarity_error},
      {"estimated_error", "indicator", "the norm of the Kelly indicators, which steers the mesh and is no bound of any error; with `Analysis = contact with error bound`, the guaranteed bound of the error in the energy norm. nan after the first step of a load history, unless the fields are written or the mesh may change at its end", &R::estimated_error},
      {"wall_seconds", "seconds", "of the solve", &R::wall_seconds},
      {"memory_mb", "MB", "peak memory of all ranks together", &R::memory_mb},
      {"max_hanging_penetration", "length", "largest penetration of a hanging node", &R::max_hanging_penetration},
      {"min_pressure", "stress", "smallest pressure of an active node; negative would be tension", &R::min_pressure},
      {"contact_area", "area", "of the touched part of the faces (`Contact/Edge = at nodes`: sum of the lumped areas of the active nodes)", &R::contact_area},
      {"max_pressure", "stress", "largest nodal contact pressure", &R::max_pressure},
      {"edge_penetration", "length", "largest penetration of a node, those at the edge of the contact included", &R::edge_penetration},
      {"energy", "force x length", "the minimum of Pi; if back stresses recover, there is none, and this is the elastic energy plus the plastic work of the step, less the work of given forces", &R::energy}};
    return columns;
  }



  const Columns<SolveResult> &
  history_columns()
  {
    using R = SolveResult;
    static const Columns<R> columns = {
      {"step", "1", "load step", &R::step},
      {"time", "time", "the value of t at the end of the step", &R::time},
      {"depth", "length", "of the indenter", &R::depth},
      {"force", "force", "of the indenter", &R::force},
      {"contact_area", "area", "as in statistics.csv", &R::contact_area},
      {"max_pressure", "stress", "largest nodal contact pressure", &R::max_pressure},
      {"active_nodes", "1", "nodes in contact", &R::active_nodes},
      {"plastic_volume", "volume", "of the quadrature points that have yielded (plane strain: area)", &R::plastic_volume},
      {"max_equivalent_plastic_strain", "1", "its largest value at a quadrature point", &R::max_equivalent_plastic_strain},
      {"cells", "1", "of the last mesh", &R::cells},
      {"dofs", "1", "of the last mesh", &R::dofs},
      {"newton_iterations", "1", "on the last mesh", &R::newton_iterations},
      {"linear_iterations", "1", "on the last mesh", &R::linear_iterations},
      {"estimated_error", "indicator", "of the last mesh, as in statistics.csv", &R::estimated_error},
      {"wall_seconds", "seconds", "on the last mesh", &R::wall_seconds},
      {"elastic_energy", "force x length", "stored in the body elastically; with an initial stress, beyond its energy", &R::elastic_energy},
      {"hardening_energy", "force x length", "stored in the body by hardening", &R::hardening_energy},
      {"plastic_work", "force x length", "since the virgin state", &R::plastic_work},
      {"dissipation", "force x length", "the part of the plastic work that is not stored", &R::dissipation},
      {"external_work", "force x length", "of indenter, supports and tractions since the virgin state, by the trapezoidal rule; a single step counts half of the final forces times displacements", &R::external_work},
      {"contact_radius", "length", "of the circle with the area of the contact, of which the modelled part may be a half or a quarter; in a plane problem half the width", &R::contact_radius},
      {"pile_up", "length", "how far the surface stands above the undeformed one: its largest height within twice the largest contact radius until now, if that is positive (pile-up), else that of the edge of the contact, negative (sink-in)", &R::pile_up},
      {"tangential_force_x", "force", "the horizontal force of the indenter on the body, positive in the direction of x; in an axisymmetric body the sum over the ring of the radial forces", [](const R &r) { return r.tangential_force[0]; }},
      {"tangential_force_y", "force", "the same in the direction of y; 0 in two dimensions", [](const R &r) { return r.tangential_force[1]; }},
      {"stick_area", "area", "the part of contact_area whose nodes stick to the indenter, with friction", &R::stick_area},
      {"frictional_dissipation", "force x length", "work of the friction between indenter and body since the virgin state", &R::frictional_dissipation},
      {"min_scaled_jacobian", "1", "with finite strains the smallest of all corners of the deformed elements: 1 for right angles, 0 where a corner has collapsed, negative where it is turned inside out; always 1 with small strains", &R::min_scaled_jacobian},
      {"mean_depth", "length", "where `mean_force` belongs to", &R::mean_depth},
      {"mean_force", "force", "the work of the force over the change of depth since nodes entered or left the contact the last time, if some have in this step; else `nan`. Smooth where `force` waves from node to node, if several steps lie between", &R::mean_force},
      {"contact_stiffness", "force / length", "with `Evaluation/Continuous stiffness`: the derivative of the force with respect to the depth with which a small unloading would begin; else, and without contact, `nan`", &R::contact_stiffness}};
    return columns;
  }



  namespace
  {
    Columns<SurfaceRow>
    make_surface_profile_columns(const unsigned int dimension)
    {
      using R = SurfaceRow;
      const std::string axes = "xyz";
      Columns<R> columns = {
        {"step", "1", "load step", &R::step},
        {"time", "time", "the value of t at its end", &R::time}};
      for (unsigned int d = 0; d + 1 < dimension; ++d)
        columns.push_back({axes.substr(d, 1), "length", d == 0 ? "of the undeformed surface; in an axisymmetric body r" : "the same; in three dimensions only", [d](const R &r) { return r.position[d]; }});
      columns.push_back({"height", "length", "the vertical coordinate of the undeformed surface", [dimension](const R &r) { return r.position[dimension - 1]; }});
      for (unsigned int d = 0; d < dimension; ++d)
        columns.push_back({"displacement_" + axes.substr(d, 1), "length", d == 0 ? "added to x, it gives where the deformed surface is" : d == 1 ? "the vertical one in two dimensions" : "the vertical one in three dimensions", [d](const R &r) { return r.displacement[d]; }});
      columns.push_back({"gap", "length", "to the indenter in its present position; `nan` where it does not reach", &R::gap});
      columns.push_back({"contact_pressure", "stress", "nodal", &R::contact_pressure});
      for (unsigned int d = 0; d < dimension; ++d)
        columns.push_back({"contact_shear_" + axes.substr(d, 1), "stress", "the shear traction of the indenter on the body, nodal", [d](const R &r) { return r.contact_shear[d]; }});
      columns.push_back({"stick", "1", "1 at a node that sticks to the indenter, with friction", &R::stick});
      if (dimension == 3)
        columns.push_back({"line", "1", "of `Output/Profile lines`, from 1; in three dimensions only", &R::line});
      return columns;
    }
  } // namespace



  const Columns<SurfaceRow> &
  surface_profile_columns(const unsigned int dimension)
  {
    static const Columns<SurfaceRow> in_plane = make_surface_profile_columns(2);
    static const Columns<SurfaceRow> in_space = make_surface_profile_columns(3);
    return dimension == 2 ? in_plane : in_space;
  }



  const Columns<MeshChange> &
  mesh_change_columns()
  {
    using R = MeshChange;
    static const Columns<R> columns = {
      {"step", "1", "load step at whose end the mesh was changed", [](const R &r) { return r.after.step; }},
      {"time", "time", "there", on_new_mesh(&SolveResult::time)},
      {"cells_before", "1", "of the old mesh", [](const R &r) { return r.before.cells; }},
      {"cells", "1", "of the new mesh", [](const R &r) { return r.after.cells; }},
      {"dofs", "1", "of the new mesh", [](const R &r) { return r.after.dofs; }},
      {"force_before", "force", "of the indenter, old mesh", on_old_mesh(&SolveResult::force)},
      {"force", "force", "of the indenter, new mesh", on_new_mesh(&SolveResult::force)},
      {"depth_before", "length", "of the indenter, old mesh", on_old_mesh(&SolveResult::depth)},
      {"depth", "length", "of the indenter, new mesh", on_new_mesh(&SolveResult::depth)},
      {"elastic_energy_before", "force x length", "stored elastically, old mesh", on_old_mesh(&SolveResult::elastic_energy)},
      {"elastic_energy", "force x length", "stored elastically, new mesh", on_new_mesh(&SolveResult::elastic_energy)},
      {"hardening_energy_before", "force x length", "stored by hardening, old mesh", on_old_mesh(&SolveResult::hardening_energy)},
      {"hardening_energy", "force x length", "stored by hardening, new mesh", on_new_mesh(&SolveResult::hardening_energy)},
      {"plastic_volume_before", "volume", "of the quadrature points that have yielded, old mesh", on_old_mesh(&SolveResult::plastic_volume)},
      {"plastic_volume", "volume", "of the quadrature points that have yielded, new mesh", on_new_mesh(&SolveResult::plastic_volume)},
      {"max_equivalent_plastic_strain_before", "1", "its largest value at a quadrature point, old mesh", on_old_mesh(&SolveResult::max_equivalent_plastic_strain)},
      {"max_equivalent_plastic_strain", "1", "its largest value at a quadrature point, new mesh", on_new_mesh(&SolveResult::max_equivalent_plastic_strain)},
      {"plastic_work", "force x length", "on the way from one equilibrium to the other", on_new_mesh(&SolveResult::plastic_work)},
      {"dissipation", "force x length", "on the way from one equilibrium to the other", on_new_mesh(&SolveResult::dissipation)}};
    return columns;
  }



  const Columns<UnloadingResult> &
  indentation_columns()
  {
    using R = UnloadingResult;
    static const Columns<R> columns = {
      {"step", "1", "load step at which the unloading begins: largest force", [](const R &r) { return r.maximum.step; }},
      {"time", "time", "there", [](const R &r) { return r.maximum.time; }},
      {"max_depth", "length", "there, as in history.csv", [](const R &r) { return r.maximum.depth; }},
      {"max_force", "force", "there, as in history.csv", [](const R &r) { return r.maximum.force; }},
      {"contact_area", "area", "there, as in history.csv", [](const R &r) { return r.maximum.contact_area; }},
      {"contact_radius", "length", "there, as in history.csv", [](const R &r) { return r.maximum.contact_radius; }},
      {"pile_up", "length", "there, as in history.csv", [](const R &r) { return r.maximum.pile_up; }},
      {"modelled_part", "1", "of the indenter: 0.25 if two planes of symmetry cut it", &R::modelled_part},
      {"stiffness", "force / length", "initial slope of the unloading, by the fit", &R::stiffness},
      {"exponent", "1", "m of the fitted power law", [](const R &r) { return r.law.exponent; }},
      {"final_depth", "length", "the depth without force of the fitted power law", [](const R &r) { return r.law.final_depth; }},
      {"hardness", "stress", "with contact_area", [](const R &r) { return r.hardness(r.maximum.contact_area); }},
      {"reduced_modulus", "stress", "with contact_area and `Evaluation/Beta`; with its default 1 to be compared with E/(1 - nu^2). With the compliance of the indenter if `Evaluation/Young's modulus of the indenter` is given", [](const R &r) { return r.reduced_modulus(r.maximum.contact_area); }},
      {"contact_depth", "length", "how deep the tip touches, by Oliver and Pharr, with `Evaluation/Epsilon`", &R::contact_depth},
      {"tip_area", "area", "the section of the tip there; if the surface of the body is curved, what tip and undeformed surface overlap there, seen from above. 0, as are the next two, if there is none: on a level surface, a cylinder in three dimensions, a height map", &R::tip_area},
      {"tip_hardness", "stress", "with tip_area: what a laboratory would find", [](const R &r) { return r.hardness(r.tip_area); }},
      {"tip_reduced_modulus", "stress", "the same with tip_area: what a laboratory would find", [](const R &r) { return r.reduced_modulus(r.tip_area); }},
      {"creep_depth", "length", "by how much the depth has grown in a hold of the force that ends in this step, with a rate law. Rows of holds and of jumps of the rate have numbers up to modelled_part, the hardness, and those of the last three columns that are theirs; what they lack, and these three in rows of unloadings, is nan, or an area of 0", &R::creep_depth},
      {"hold_rate_sensitivity", "1", "m = d ln(hardness) / d ln(rate) of this hold, with the rate (dh/dt)/h of the depth h: least squares, but for the first tenth of the hold", &R::hold_rate_sensitivity},
      {"jump_rate_sensitivity", "1", "the same between the ends of two segments of `Loading/History`, of which the second ends in this step, if their rates differ by a fifth at least", &R::jump_rate_sensitivity}};
    return columns;
  }



  const Columns<UnloadingResult> &
  continuous_stiffness_columns()
  {
    using R = UnloadingResult;
    static const Columns<R> columns = {
      {"step", "1", "load step", [](const R &r) { return r.maximum.step; }},
      {"time", "time", "at its end", [](const R &r) { return r.maximum.time; }},
      {"depth", "length", "of the indenter, as in history.csv", [](const R &r) { return r.maximum.depth; }},
      {"whole_force", "force", "of the whole indenter, parts beyond planes of symmetry included, as a laboratory measures it", [](const R &r) { return r.maximum.force / r.modelled_part; }},
      {"whole_stiffness", "force / length", "of a small unloading, of the whole indenter", [](const R &r) { return r.stiffness / r.modelled_part; }},
      {"whole_contact_area", "area", "contact_area of history.csv, of the whole indenter: the true one, pile-up included", [](const R &r) { return r.maximum.contact_area / r.modelled_part; }},
      {"hardness", "stress", "with whole_contact_area", [](const R &r) { return r.hardness(r.maximum.contact_area); }},
      {"reduced_modulus", "stress", "with whole_contact_area, as in indentation.csv", [](const R &r) { return r.reduced_modulus(r.maximum.contact_area); }},
      {"contact_depth", "length", "how deep the tip touches, by Oliver and Pharr, with `Evaluation/Epsilon`", &R::contact_depth},
      {"whole_tip_area", "area", "the section of the whole tip there, as in indentation.csv; 0, as are the next two, if there is none", [](const R &r) { return r.tip_area / r.modelled_part; }},
      {"tip_hardness", "stress", "with whole_tip_area: what a laboratory would find", [](const R &r) { return r.hardness(r.tip_area); }},
      {"tip_reduced_modulus", "stress", "the same with whole_tip_area", [](const R &r) { return r.reduced_modulus(r.tip_area); }}};
    return columns;
  }



  const Columns<LimitLoadRow> &
  limit_load_columns()
  {
    using R = LimitLoadRow;
    static const Columns<R> columns = {
      {"cycle", "1", "number of the mesh, from 0", &R::cycle},
      {"cells", "1", "of the mesh", &R::cells},
      {"triangles", "1", "that the cells are split into; in space, tetrahedra", &R::triangles},
      {"lower_bound", "force", "of the limit load (of the load factor, without unit, if tractions grow): that of stresses in equilibrium which satisfy the yield condition", &R::lower_bound},
      {"upper_bound", "force", "of the same: that of a mechanism of collapse", &R::upper_bound},
      {"relative_difference", "1", "of the bounds, over the lower one", &R::relative_difference},
      {"lower_iterations", "1", "of the interior point method", &R::lower_iterations},
      {"upper_iterations", "1", "of the interior point method", &R::upper_iterations},
      {"stress_error", "1", "the largest violation of equilibrium, tractions or yield condition", &R::stress_error},
      {"velocity_error", "1", "the largest violation of incompressibility, supports or indenter by the mechanism, relative to the velocity of the indenter, or if tractions grow, to the largest one", &R::velocity_error},
      {"wall_seconds", "seconds", "for both bounds", &R::wall_seconds}};
    return columns;
  }



  const Columns<ErrorBoundRow> &
  error_bound_columns()
  {
    using R = ErrorBoundRow;
    static const Columns<R> columns = {
      {"cycle", "1", "number of the mesh, from 0", &R::cycle},
      {"cells", "1", "of the mesh", &R::cells},
      {"dofs", "1", "unknowns of the displacement method", &R::dofs},
      {"triangles", "1", "of the equilibrium method; in space, tetrahedra", &R::triangles},
      {"depth", "length", "of the displacement method", &R::depth},
      {"force", "force", "of the displacement method", &R::force},
      {"equilibrium_depth", "length", "of the equilibrium method", &R::equilibrium_depth},
      {"equilibrium_force", "force", "of the equilibrium method", &R::equilibrium_force},
      {"equilibrium_max_pressure", "stress", "largest contact pressure of the equilibrium method", &R::equilibrium_max_pressure},
      {"equilibrium_contact_area", "area", "contact area of the equilibrium method", &R::equilibrium_contact_area},
      {"energy", "force x length", "Pi under the given load", [](const R &r) { return r.bound() - r.complementary_energy; }},
      {"complementary_energy", "force x length", "J under the given load; the exact energies are opposite numbers, and lie between", &R::complementary_energy},
      {"bound_of_body", "force x length", "the part of Pi + J that comes from the body", &R::bound_of_body},
      {"bound_of_contact", "force x length", "the part of Pi + J that comes from the contact surface", &R::bound_of_contact},
      {"bound", "force x length", "Pi + J", &R::bound},
      {"relative_bound", "1", "the same over the magnitude of J", [](const R &r) { return r.bound() / std::abs(r.complementary_energy); }},
      {"force_lower_bound", "force", "the exact force is not smaller; -inf if no bound has been found", [](const R &r) { return r.force_bounds.lower; }},
      {"force_upper_bound", "force", "nor larger. If a force is given, both are that", [](const R &r) { return r.force_bounds.upper; }},
      {"depth_lower_bound", "length", "the exact depth is not smaller; -inf if no bound has been found", [](const R &r) { return r.depth_bounds.lower; }},
      {"depth_upper_bound", "length", "nor larger. If a depth is given, both are that", [](const R &r) { return r.depth_bounds.upper; }},
      {"iterations", "1", "of the interior point method", &R::iterations},
      {"stress_error", "1", "the largest violation of equilibrium, tractions or yield condition", &R::stress_error},
      {"wall_seconds", "seconds", "of the equilibrium method and the bounds", &R::wall_seconds}};
    return columns;
  }
} // namespace ElastoPlastic
