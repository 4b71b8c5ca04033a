// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_plane_body_h
#define equilibrium_plane_body_h

#include <functional>
#include <vector>

#include "base/kinematics.h"
#include "contact/surface_finish.h"
#include "equilibrium/split_mesh.h"
#include "material/material.h"
#include "mesh/boundary_conditions.h"

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

    /// A typical stress: the smallest yield stress, or a modulus of elasticity.
    double stress_unit;
    /// A typical strain: this stress by Young's modulus.
    double strain_unit;
    double length_unit;

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
  };



  /// Puts a PlaneBody together. The loads are those at @p time; @p conditions
  /// must live as long as it. The indenter can touch a side of the contact
  /// boundary where @p gap is finite in all of it. If there is one material
  /// only, all cells are of it.
  PlaneBody
  make_plane_body(SplitMesh                                      mesh,
                  const BoundaryConditions<2>                   &conditions,
                  const std::vector<Material<double>>           &materials,
                  const Kinematics                               kinematics,
                  const std::function<double(const Point<2> &)> &gap,
                  const double                                   time,
                  const SurfaceFinish indenter_surface = SurfaceFinish::smooth);
} // namespace ElastoPlastic

#endif
