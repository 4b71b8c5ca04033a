// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "io/columns.h"

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
      {"max_penetration", "length", "largest penetration of a candidate node", &R::max_penetration},
      {"complementarity_error", "1", "sum of force times distance over force times depth", &R::complementarity_error},
      {"estimated_error", "indicator", "the norm of the Kelly indicators, which steers the mesh and is no bound of any error; with `Analysis = contact with error bound`, the guaranteed bound of the error in the energy norm", &R::estimated_error},
      {"wall_seconds", "seconds", "of the solve", &R::wall_seconds},
      {"memory_mb", "MB", "peak memory of all ranks together", &R::memory_mb},
      {"max_hanging_penetration", "length", "largest penetration of a hanging node", &R::max_hanging_penetration},
      {"min_pressure", "stress", "smallest pressure of an active node; negative would be tension", &R::min_pressure},
      {"contact_area", "area", "sum of the lumped areas of the active nodes", &R::contact_area},
      {"max_pressure", "stress", "largest nodal contact pressure", &R::max_pressure},
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
      {"contact_area", "area", "sum of the lumped areas of the active nodes", &R::contact_area},
      {"max_pressure", "stress", "largest nodal contact pressure", &R::max_pressure},
      {"active_nodes", "1", "nodes in contact", &R::active_nodes},
      {"plastic_volume", "volume", "of the quadrature points that have yielded (plane strain: area)", &R::plastic_volume},
      {"max_equivalent_plastic_strain", "1", "its largest value at a quadrature point", &R::max_equivalent_plastic_strain},
      {"cells", "1", "of the last mesh", &R::cells},
      {"dofs", "1", "of the last mesh", &R::dofs},
      {"newton_iterations", "1", "on the last mesh", &R::newton_iterations},
      {"linear_iterations", "1", "on the last mesh", &R::linear_iterations},
      {"estimated_error", "indicator", "of the last mesh", &R::estimated_error},
      {"wall_seconds", "seconds", "on the last mesh", &R::wall_seconds},
      {"elastic_energy", "force x length", "stored in the body elastically", &R::elastic_energy},
      {"hardening_energy", "force x length", "stored in the body by hardening", &R::hardening_energy},
      {"plastic_work", "force x length", "since the virgin state", &R::plastic_work},
      {"dissipation", "force x length", "the part of the plastic work that is not stored", &R::dissipation},
      {"external_work", "force x length", "of indenter, supports and tractions since the virgin state, by the trapezoidal rule", &R::external_work}};
    return columns;
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
      {"modelled_part", "1", "of the indenter: 0.25 if two planes of symmetry cut it", &R::modelled_part},
      {"stiffness", "force / length", "initial slope of the unloading, by the fit", &R::stiffness},
      {"exponent", "1", "m of the fitted power law", [](const R &r) { return r.law.exponent; }},
      {"final_depth", "length", "the depth without force of the fitted power law", [](const R &r) { return r.law.final_depth; }},
      {"hardness", "stress", "with contact_area", [](const R &r) { return r.hardness(r.maximum.contact_area); }},
      {"reduced_modulus", "stress", "with contact_area; to be compared with E/(1 - nu^2)", [](const R &r) { return r.reduced_modulus(r.maximum.contact_area); }},
      {"contact_depth", "length", "how deep the tip touches, by Oliver and Pharr", &R::contact_depth},
      {"tip_area", "area", "the section of the tip there; 0, as are the next two, if it has none: a cylinder in three dimensions, a height map", &R::tip_area},
      {"tip_hardness", "stress", "with tip_area: what a laboratory would find", [](const R &r) { return r.hardness(r.tip_area); }},
      {"tip_reduced_modulus", "stress", "with tip_area: what a laboratory would find", [](const R &r) { return r.reduced_modulus(r.tip_area); }}};
    return columns;
  }
} // namespace ElastoPlastic
