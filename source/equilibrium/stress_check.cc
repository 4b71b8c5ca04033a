// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "equilibrium/hencky_material.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/stress_check.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace JohnsonMercier;

    constexpr double largest_stress_error = 1e-8;

    /// The tractions of a triangle at the ends of a side, in the direction of
    /// the side, on a plane with the normal of the side.
    std::array<Tensor<1, 2>, 2>
    tractions(const PlaneBody   &body,
              const StressField &field,
              const unsigned int t,
              const unsigned int k)
    {
      const auto                 &triangle = body.mesh.triangles[t];
      const auto                 &side     = body.mesh.sides[triangle.sides[k]];
      const Tensor<1, 2>          normal   = body.mesh.normal(side);
      std::array<Tensor<1, 2>, 2> result   = {
          {stress_at(field.in_plane[t], k, 0) * normal,
           stress_at(field.in_plane[t], k, 1) * normal}};
      if (side.vertices[0] != triangle.vertices[k])
        std::swap(result[0], result[1]);
      return result;
    }



    void
    check_inside(StressErrors      &errors,
                 const PlaneBody   &body,
                 const StressField &field,
                 const unsigned int t)
    {
      const auto  corners = body.mesh.corners(body.mesh.triangles[t]);
      const auto &values  = field.in_plane[t];

      Vector<double> divergence(6);
      divergence_matrix(corners).vmult(divergence, values);
      errors.divergence =
        std::max(errors.divergence,
                 divergence.linfty_norm() * std::sqrt(area(corners)));

      for (unsigned int k = 0; k < 3; ++k)
        {
          const Tensor<1, 2> line = subtriangle_of(corners, k)[2] - corners[k];
          const Tensor<1, 2> normal = cross_product_2d(line) / line.norm();
          const unsigned int before = (k + 2) % 3;
          for (const auto &[here, there] :
               {std::make_pair(0u, 1u), std::make_pair(2u, 2u)})
            errors.traction_jump =
              std::max(errors.traction_jump,
                       ((stress_at(values, k, here) -
                         stress_at(values, before, there)) *
                        normal)
                         .norm());
        }

      if (HenckyMaterial::hardens(body.materials[t]))
        return;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < 3; ++i)
          errors.yield_excess = std::max(errors.yield_excess,
                                         deviator(field.at(t, k, i)).norm() -
                                           body.materials[t].yield_radius);
    }



    /// Of a side at the boundary. @return the force of the indenter.
    double
    check_boundary(StressErrors                      &errors,
                   const PlaneBody                   &body,
                   const unsigned int                 s,
                   const std::array<Tensor<1, 2>, 2> &tractions)
    {
      double       force  = 0;
      const auto  &side   = body.mesh.sides[s];
      const double length = body.mesh.length(side);
      for (unsigned int end = 0; end < 2; ++end)
        for (const auto &component : body.conditions[s].components)
          {
            const double traction = tractions[end] * component.direction;
            if (component.type == SideConditionType::traction)
              errors.boundary_force =
                std::max(errors.boundary_force,
                         std::abs(traction -
                                  component.value(
                                    body.mesh.vertices[side.vertices[end]])));
            if (component.type == SideConditionType::contact)
              {
                errors.tension = std::max(errors.tension, traction);
                force -= 0.5 * length * traction;
              }
          }
      return force;
    }
  } // namespace



  double
  StressErrors::largest() const
  {
    return std::max({divergence,
                     traction_jump,
                     boundary_force,
                     tension,
                     yield_excess,
                     force_difference});
  }



  StressErrors
  check_stress(const PlaneBody &body, const StressField &field)
  {
    StressErrors                             errors;
    double                                   force = 0;
    std::vector<std::array<Tensor<1, 2>, 2>> first(body.mesh.sides.size());
    std::vector<bool> seen(body.mesh.sides.size(), false);
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      {
        check_inside(errors, body, field, t);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const unsigned int s    = body.mesh.triangles[t].sides[k];
            const auto         here = tractions(body, field, t, k);
            if (body.mesh.sides[s].boundary_id !=
                numbers::internal_face_boundary_id)
              force += check_boundary(errors, body, s, here);
            else if (!seen[s])
              first[s] = here;
            else
              for (unsigned int end = 0; end < 2; ++end)
                errors.traction_jump =
                  std::max(errors.traction_jump,
                           (here[end] - first[s][end]).norm());
            seen[s] = true;
          }
      }

    errors.divergence /= body.stress_unit;
    errors.traction_jump /= body.stress_unit;
    errors.boundary_force /= body.stress_unit;
    errors.tension /= body.stress_unit;
    errors.yield_excess /= body.stress_unit;
    errors.force_difference =
      std::abs(force - field.force) / std::max(std::abs(force), 1e-300);
    return errors;
  }



  double
  require_admissible(const PlaneBody &body, const StressField &field)
  {
    const double error = check_stress(body, field).largest();
    if (error > largest_stress_error)
      throw ConvergenceError(
        "The stresses of the equilibrium method violate equilibrium or yield "
        "condition by " +
        std::to_string(error) + " of the yield stress.");
    return error;
  }
} // namespace ElastoPlastic
