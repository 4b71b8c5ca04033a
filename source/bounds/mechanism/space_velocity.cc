// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/largest_error.h"
#include "bounds/body/evaluated_bounds.h"
#include "bounds/mechanism/space_velocity.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of a neighbour of a face, at the corners of the face.
    std::array<Tensor<1, 3>, 3>
    velocities_on_face(const SpaceBody                     &body,
                       const std::vector<CornerVelocities> &velocity,
                       const unsigned int                   f,
                       const unsigned int                   neighbor)
    {
      const unsigned int          t = body.mesh.faces[f].neighbors[neighbor];
      const auto                 &vertices = body.mesh.tetrahedra[t].vertices;
      std::array<Tensor<1, 3>, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const auto found = std::find(vertices.begin(),
                                       vertices.end(),
                                       body.mesh.faces[f].vertices[i]);
          result[i]        = velocity[t][found - vertices.begin()];
        }
      return result;
    }

  } // namespace



  SymmetricTensor<2, 3>
  strain_rate(const Tetrahedron &corners, const CornerVelocities &velocity)
  {
    const auto   gradient = gradients(corners);
    Tensor<2, 3> sum;
    for (unsigned int v = 0; v < 4; ++v)
      sum += outer_product(velocity[v], gradient[v]);
    return symmetrize(sum);
  }



  std::array<Tensor<1, 3>, 3>
  velocity_jumps(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity,
                 const unsigned int                   f)
  {
    auto jumps = velocities_on_face(body, velocity, f, 0);
    std::array<Tensor<1, 3>, 3> beside;
    if (body.mesh.faces[f].is_inside())
      beside = velocities_on_face(body, velocity, f, 1);
    else if (body.conditions[f].is_reached)
      beside.fill(body.indenter_velocity);
    for (unsigned int i = 0; i < 3; ++i)
      jumps[i] -= beside[i];
    return jumps;
  }



  bool
  slip_takes_work(const SpaceBody &body, const unsigned int f)
  {
    return body.mesh.faces[f].is_inside() || body.support_of(f).resists_slip;
  }



  double
  SpaceVelocityErrors::largest() const
  {
    return std::max({divergence, separation, penetration});
  }



  SpaceVelocityErrors
  check_velocity(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity)
  {
    SpaceVelocityErrors errors;
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        const Tetrahedron corners = body.mesh.corners(body.mesh.tetrahedra[t]);
        enlarge(errors.divergence,
                std::cbrt(volume(corners)) *
                  std::abs(trace(strain_rate(corners, velocity[t]))));
      }
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      {
        const auto        &face = body.mesh.faces[f];
        const Tensor<1, 3> n    = normal(body.mesh.corners(face));
        for (const auto &jump : velocity_jumps(body, velocity, f))
          {
            if (face.is_inside() || body.support_of(f).is_closed)
              enlarge(errors.separation, std::abs(jump * n));
            if (body.conditions[f].is_reached)
              enlarge(errors.penetration, jump[2]);
          }
      }
    return errors;
  }



  double
  lowest_depth(const SpaceBody                     &body,
               const std::vector<CornerVelocities> &velocity)
  {
    double depth = std::numeric_limits<double>::infinity();
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_reached)
        for (const auto &v : velocities_on_face(body, velocity, f, 0))
          depth = std::min(depth, -v[2]);
    return depth;
  }



  // The norm of a linear function is convex: its mean over a face is not more
  // than that of the values at the corners.
  std::vector<double>
  plastic_work(const SpaceBody                     &body,
               const std::vector<CornerVelocities> &velocity)
  {
    std::vector<double> work;
    for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
      {
        const Tetrahedron corners = body.mesh.corners(body.mesh.tetrahedra[t]);
        work.push_back(volume(corners) * body.materials[t].yield_radius *
                       strain_rate(corners, velocity[t]).norm());
      }
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (slip_takes_work(body, f))
        {
          const auto        &face    = body.mesh.faces[f];
          const auto         corners = body.mesh.corners(face);
          const Tensor<1, 3> n       = normal(corners);
          double             slip    = 0;
          for (const auto &jump : velocity_jumps(body, velocity, f))
            slip += area(corners) / 3. * (jump - (jump * n) * n).norm();
          for (const unsigned int t : face.neighbors)
            if (t != numbers::invalid_unsigned_int)
              work[t] +=
                body.shear_strength(f) * slip / (face.is_inside() ? 2. : 1.);
        }
    return work;
  }



  LoadPower
  power_of_loads(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity)
  {
    LoadPower power;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (!body.mesh.faces[f].is_inside())
        {
          const auto   v = velocities_on_face(body, velocity, f, 0);
          const double weight =
            area(body.mesh.corners(body.mesh.faces[f])) / 12.;
          for (const auto &component : body.conditions[f].components)
            if (component.type == SideConditionType::traction)
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  {
                    const double along = weight * (i == j ? 2. : 1.) *
                                         (v[i] * component.direction);
                    power.constant += along * component.values[j];
                    power.growing += along * component.growths[j];
                  }
        }
    for (unsigned int t = 0; t < velocity.size(); ++t)
      for (const Tensor<1, 3> &v : velocity[t])
        {
          const Tensor<1, 3> integral =
            volume(body.mesh.corners(body.mesh.tetrahedra[t])) / 4. * v;
          power.constant += body.body_force * integral;
          power.growing += body.body_force_growth * integral;
        }
    return power;
  }



  double
  largest_velocity(const SpaceBody &,
                   const std::vector<CornerVelocities> &velocity)
  {
    double largest = 0;
    for (const CornerVelocities &at_corners : velocity)
      for (const Tensor<1, 3> &v : at_corners)
        largest = std::max(largest, v.norm());
    return largest;
  }



  SpaceVelocityField
  minimize_plastic_work(const SpaceBody &body, const double tolerance)
  {
    SpaceVelocityField field;
    try
      {
        field = find_motion_in_space(body, tolerance);
      }
    catch (const UnboundedError &)
      {
        throw ConvergenceError(
          body.load_factor_unit > 0 ?
            "No velocity lets the loads that grow do work: the supports "
            "enclose the body." :
            "No velocity moves the whole indenter down: it reaches a point "
            "that is held, or the supports enclose the body. Let "
            "'Indenter/Reach' end before what is held.");
      }
    evaluate_mechanism(body, field);
    return field;
  }
} // namespace ElastoPlastic
