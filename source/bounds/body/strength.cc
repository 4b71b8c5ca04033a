// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "bounds/body/hencky_material.h"
#include "bounds/body/split_body.h"

// What the materials of a SplitBody bear.

namespace ElastoPlastic
{
  namespace
  {
    /// The largest load that does not grow, as a stress.
    template <int dim>
    double
    largest_constant_load(const SplitBody<dim> &body)
    {
      double largest = body.body_force.norm() * body.length_unit;
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        for (const auto &component : body.conditions[f].components)
          if (component.type == ConditionType::traction)
            for (unsigned int i = 0; i < dim; ++i)
              keep_largest(largest,
                           std::abs(component.value(
                             corner_point<dim>(body.corners_of_face(f), i))));
      return largest;
    }
  } // namespace



  template <int dim>
  bool
  SplitBody<dim>::has_friction() const
  {
    return !friction_slopes.empty();
  }



  template <int dim>
  bool
  SplitBody<dim>::can_slide() const
  {
    return kinematics != Kinematics::plane_stress && !has_friction();
  }



  // See bounds/conic/yield_conditions.h. In plane strain, s_33 is the mean of
  // the others.
  template <int dim>
  double
  SplitBody<dim>::yield_radius(const unsigned int           simplex,
                               const SymmetricTensor<2, 3> &stress) const
  {
    const double without_pressure = materials[simplex].yield_radius;
    if (!has_friction())
      return without_pressure;
    const double mean = dim == 3 || is_axisymmetric() ?
                          trace(stress) / 3. :
                          (stress[0][0] + stress[1][1]) / 2.;
    return without_pressure - std::sqrt(2.) * friction_slopes[simplex] * mean;
  }



  template <int dim>
  double
  SplitBody<dim>::shear_strength(const unsigned int face) const
  {
    double radius = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < mesh.faces[face].n_neighbors(); ++i)
      radius =
        std::min(radius, materials[mesh.faces[face].neighbors[i]].yield_radius);
    return std::sqrt(0.5) * radius;
  }



  // A strength that comes from the pressure of constant loads may be much
  // larger than the cohesion.
  template <int dim>
  void
  set_friction(SplitBody<dim> &body, const std::vector<double> &slopes)
  {
    const double largest_slope =
      *std::max_element(slopes.begin(), slopes.end());
    if (largest_slope == 0.)
      return;
    for (const auto &simplex : body.mesh.simplices)
      body.friction_slopes.push_back(
        slopes.size() == 1 ? slopes.front() :
                             slopes[body.mesh.cells[simplex.cell].material_id]);
    const double factor =
      std::max(1.,
               largest_slope * largest_constant_load(body) / body.stress_unit);
    body.stress_unit *= factor;
    body.strain_unit *= factor;
    body.load_factor_unit *= factor;
  }



  template <int dim>
  void
  set_initial_stress(SplitBody<dim> &body, const InitialStress<dim> &stress)
  {
    if (!stress.is_present())
      return;
    double     largest = 0, largest_distance = 0; // from what is linear
    Point<dim> worst_point;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        const auto                                 corners = body.corners_of(t);
        const auto                                 centre  = centre_of(corners);
        std::array<SymmetricTensor<2, 3>, dim + 1> at_corners;
        for (unsigned int i = 0; i <= dim; ++i)
          {
            at_corners[i] = stress.value(from_inside(corners[i], centre));
            keep_largest(largest, at_corners[i].norm());
          }
        for (const auto &[position, weight] : simplex_quadrature<dim>())
          {
            const Point<dim> x = interpolate(position, corners);
            const double     distance =
              (stress.value(x) - interpolate(position, at_corners)).norm();
            if (distance > largest_distance)
              worst_point = x;
            keep_largest(largest_distance, distance);
          }
        auto &strains = body.initial_strains.emplace_back();
        for (unsigned int i = 0; i <= dim; ++i)
          strains[i] =
            HenckyMaterial::compliance(body.materials[t], at_corners[i]);
      }
    if (!(largest_distance <= Tolerance::expression * largest))
      throw InputError(
        "The 'Initial stress' is not linear on the cells of the mesh, near the "
        "point (" +
        Patterns::Tools::to_string(worst_point) +
        "). An error bound is for stresses at the beginning that are linear "
        "functions of the position, or such with kinks at vertices of the "
        "mesh. Give such, or choose 'Analysis = contact'.");
  }



  template bool
  SplitBody<2>::has_friction() const;
  template bool
  SplitBody<3>::has_friction() const;
  template bool
  SplitBody<2>::can_slide() const;
  template bool
  SplitBody<3>::can_slide() const;
  template double
  SplitBody<2>::yield_radius(const unsigned int,
                             const SymmetricTensor<2, 3> &) const;
  template double
  SplitBody<3>::yield_radius(const unsigned int,
                             const SymmetricTensor<2, 3> &) const;
  template double
  SplitBody<2>::shear_strength(const unsigned int) const;
  template double
  SplitBody<3>::shear_strength(const unsigned int) const;
  template void
  set_friction(SplitBody<2> &, const std::vector<double> &);
  template void
  set_friction(SplitBody<3> &, const std::vector<double> &);
  template void
  set_initial_stress(SplitBody<2> &, const InitialStress<2> &);
  template void
  set_initial_stress(SplitBody<3> &, const InitialStress<3> &);
} // namespace ElastoPlastic
