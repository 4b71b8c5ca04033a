// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/largest_error.h"
#include "bounds/body/hencky_material.h"
#include "bounds/stress/space_stress.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the stress on a part with these @p corners, by differences between
    /// the values at them.
    Tensor<1, 3>
    divergence_of_part(const Tetrahedron      &corners,
                       const SpaceStressField &field,
                       const unsigned int      t,
                       const unsigned int      part)
    {
      Tensor<2, 3> ways;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int d = 0; d < 3; ++d)
          ways[i][d] = corners[i + 1][d] - corners[0][d];
      const Tensor<2, 3> inverse = invert(ways);
      Tensor<1, 3>       result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const auto change = field.at(t, part, i + 1) - field.at(t, part, 0);
          for (unsigned int d = 0; d < 3; ++d)
            result += inverse[d][i] * (change * Point<3>::unit_vector(d));
        }
      return result;
    }



    /// That the tractions are continuous between the parts k and l of a
    /// tetrahedron.
    void
    check_between_parts(SpaceStressErrors      &errors,
                        const Tetrahedron      &corners,
                        const SpaceStressField &field,
                        const unsigned int      t,
                        const unsigned int      k,
                        const unsigned int      l)
    {
      const Point<3> center = TetrahedronStress::part_of(corners, k)[k];
      TriangleFace   face   = {{center}};
      for (unsigned int i = 0, n = 1; i < 4; ++i)
        if (i != k && i != l)
          {
            face[n++] = corners[i];
            enlarge(errors.traction_jump,
                    ((field.at(t, k, i) - field.at(t, l, i)) *
                     normal({{center, corners[i], corners[6 - i - k - l]}}))
                      .norm());
          }
      enlarge(errors.traction_jump,
              ((field.at(t, k, k) - field.at(t, l, l)) * normal(face)).norm());
    }



    void
    check_tetrahedron(SpaceStressErrors      &errors,
                      const SpaceBody        &body,
                      const SpaceStressField &field,
                      const unsigned int      t)
    {
      const Tetrahedron corners = body.mesh.corners(body.mesh.tetrahedra[t]);
      const double      size    = std::cbrt(volume(corners));
      for (unsigned int k = 0; k < 4; ++k)
        {
          enlarge(errors.divergence,
                  size * divergence_of_part(
                           TetrahedronStress::part_of(corners, k), field, t, k)
                           .norm());
          for (unsigned int i = 0; i < 4; ++i)
            if (!HenckyMaterial::hardens(body.materials[t]))
              enlarge(errors.yield_excess,
                      deviator(field.at(t, k, i)).norm() -
                        body.materials[t].yield_radius);
          for (unsigned int l = k + 1; l < 4; ++l)
            check_between_parts(errors, corners, field, t, k, l);
        }
    }



    /// Outward, at a corner of a face, of one of its neighbours.
    Tensor<1, 3>
    outward_traction(const SpaceBody        &body,
                     const SpaceStressField &field,
                     const unsigned int      f,
                     const unsigned int      neighbor,
                     const unsigned int      corner)
    {
      const unsigned int t           = body.mesh.faces[f].neighbors[neighbor];
      const auto        &tetrahedron = body.mesh.tetrahedra[t];
      unsigned int       k = 0, i = 0;
      while (tetrahedron.faces[k] != f)
        ++k;
      while (tetrahedron.vertices[i] != body.mesh.faces[f].vertices[corner])
        ++i;
      return field.at(t, k, i) *
             outward_normal(body.mesh.corners(tetrahedron), k);
    }



    /// Of a face at the boundary, where the pressure of body forces counts.
    /// @return the force of the indenter.
    double
    check_boundary_face(SpaceStressErrors      &errors,
                        const SpaceBody        &body,
                        const SpaceStressField &field,
                        const unsigned int      f)
    {
      const double area_of_face = area(body.mesh.corners(body.mesh.faces[f]));
      double       force        = 0;
      for (unsigned int i = 0; i < 3; ++i)
        for (const auto &component : body.conditions[f].components)
          {
            const Point<3> corner =
              body.mesh.vertices[body.mesh.faces[f].vertices[i]];
            const Tensor<1, 3> pressure =
              body.pressure_of_body_force(corner, field.load_factor) *
              body.outward_normal(f);
            const double traction =
              (outward_traction(body, field, f, 0, i) - pressure) *
              component.direction;
            if (component.type == SideConditionType::traction)
              enlarge(errors.boundary_force,
                      std::abs(traction - component.values[i] -
                               field.load_factor * component.growths[i]));
            if (component.type == SideConditionType::contact)
              {
                enlarge(errors.tension, traction);
                force -= area_of_face / 3. * traction;
              }
          }
      return force;
    }
  } // namespace



  double
  SpaceStressErrors::largest() const
  {
    return std::max({divergence,
                     traction_jump,
                     boundary_force,
                     tension,
                     yield_excess,
                     force_difference});
  }



  SpaceStressErrors
  check_stress(const SpaceBody &body, const SpaceStressField &field)
  {
    SpaceStressErrors errors;
    double            force = 0;
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      check_tetrahedron(errors, body, field, t);
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (!body.mesh.faces[f].is_inside())
        force += check_boundary_face(errors, body, field, f);
      else
        for (unsigned int i = 0; i < 3; ++i)
          enlarge(errors.traction_jump,
                  (outward_traction(body, field, f, 0, i) +
                   outward_traction(body, field, f, 1, i))
                    .norm());

    for (double *error : {&errors.divergence,
                          &errors.traction_jump,
                          &errors.boundary_force,
                          &errors.tension,
                          &errors.yield_excess})
      *error /= body.stress_unit;
    errors.force_difference =
      std::abs(force - field.force) /
      std::max(std::abs(force),
               body.stress_unit * body.length_unit * body.length_unit);
    return errors;
  }

} // namespace ElastoPlastic
