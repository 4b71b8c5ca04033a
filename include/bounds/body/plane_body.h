// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_plane_body_h
#define bounds_body_plane_body_h

#include <functional>
#include <vector>

#include "base/kinematics.h"
#include "bounds/body/loads.h"
#include "bounds/mesh/split_mesh.h"
#include "contact/contact_geometry.h"
#include "contact/footprint.h"
#include "indenter/surface_finish.h"
#include "loads/boundary_conditions.h"
#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What holds for one component of displacement and traction on a side.
  enum class SideConditionType
  {
    continuous,   ///< between two triangles
    traction,     ///< the traction is given, maybe zero
    displacement, ///< the displacement is given, maybe zero; as it is across
                  ///< the direction in which a rough indenter presses
    contact       ///< the indenter presses, if it touches, in this direction
  };



  /// The condition of a side: for each of two directions at right angles.
  struct SideCondition
  {
    /// A given traction or displacement as a function of the position.
    using Value = std::function<double(const Point<2> &)>;

    struct Component
    {
      Tensor<1, 2>      direction;
      SideConditionType type;
      Value             value;
      /// What a load factor adds to a traction.
      Value growth = [](const Point<2> &) {
        return 0.;
      };
    };

    std::array<Component, 2> components;

    /// Whether the indenter can touch any point of the side. If it can touch
    /// some only, it presses on none: the stresses stay admissible. But no
    /// point of the side may penetrate, nor slide along a rough indenter, so
    /// that motions are admissible, too.
    bool is_reached = false;
  };



  /// The problem of a plane section in plane strain, of a sheet, or of the
  /// half section x = r >= 0 of a body of revolution, as the equilibrium method
  /// needs it: the mesh, the materials, what acts on the sides, and the units
  /// in which it computes.
  struct PlaneBody
  {
    SplitMesh                     mesh;
    std::vector<SideCondition>    conditions; ///< by sides
    std::vector<Material<double>> materials;  ///< by triangles
    Kinematics                    kinematics;
    SurfaceFinish                 indenter_surface = SurfaceFinish::smooth;
    /// The gap between indenter and body, where the indenter can touch.
    std::function<double(const Point<2> &)> gap;
    /// Of the indenter, in a mechanism of collapse: down, or zero if it is
    /// other loads that grow.
    Tensor<1, 2> indenter_velocity = Tensor<1, 2>({0., -1.});

    /// What acts on the volume, and what a load factor adds to it.
    Tensor<1, 2> body_force;
    Tensor<1, 2> body_force_growth;

    /// A typical stress: the smallest yield stress, or a modulus of elasticity.
    double stress_unit;
    /// A typical strain: this stress by Young's modulus.
    double strain_unit;
    double length_unit;
    /// A typical load factor, with which tractions or body forces are as large
    /// as stresses are; 0 if no load grows.
    double load_factor_unit = 0;

    bool
    is_axisymmetric() const;

    /// Of a body of revolution, with rounding errors.
    bool
    is_on_axis(const Point<2> &x) const;

    /// What stresses are multiplied by to be in equilibrium like those of a
    /// plane section: the distance r from the axis of a body of revolution, or
    /// 1.
    double
    weight(const Point<2> &x) const;

    /// A typical value of it.
    double
    weight_unit() const;

    /// What weighted stresses, integrated over the mesh, are multiplied by to
    /// be those of the body: 2 pi, or 1.
    double
    angle() const;

    /// Of the ring whose section is a triangle, or of the triangle by unit of
    /// thickness.
    double
    volume(const unsigned int triangle) const;

    /// The body force f is that of a pressure f . (x - x_0) in the body, which
    /// is taken out of all stresses: so they have no divergence. The load that
    /// then acts on a side with this outward @p normal, and what a load factor
    /// adds to it, in the direction of a @p component of its condition.
    double
    load(const SideCondition::Component &component,
         const Tensor<1, 2>             &normal,
         const Point<2>                 &x) const;
    double
    growth(const SideCondition::Component &component,
           const Tensor<1, 2>             &normal,
           const Point<2>                 &x) const;

    /// That pressure.
    double
    pressure_of_body_force(const Point<2> &x, const double load_factor) const;
  };



  /// Puts a PlaneBody together. Prescribed displacements are those at the time
  /// at which the loads begin. The indenter can touch a side of the contact
  /// boundary where @p gap is finite in all of it, which it is in the
  /// @p footprint if that is known. It presses downwards, or
  /// with the @p geometry normal across the side, or automatic across the sides
  /// that it fits. If there is one material only, all cells are of it. @throws
  /// InputError for a body force that depends on the position.
  PlaneBody
  make_plane_body(SplitMesh                                      mesh,
                  const BoundaryConditions<2>                   &conditions,
                  const std::vector<Material<double>>           &materials,
                  const Kinematics                               kinematics,
                  const std::function<double(const Point<2> &)> &gap,
                  const Loads<2>                                &loads,
                  const SurfaceFinish   surface   = SurfaceFinish::smooth,
                  const ContactGeometry geometry  = ContactGeometry::vertical,
                  const Footprint<1>   &footprint = {});
} // namespace ElastoPlastic

#endif
