// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_space_body_h
#define bounds_body_space_body_h

#include <functional>
#include <optional>
#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/mesh/tetrahedral_mesh.h"
#include "contact/footprint.h"
#include "indenter/surface_finish.h"
#include "loads/boundary_conditions.h"
#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Cosine and sine below which directions are at right angles or parallel.
  constexpr double small_angle = 1e-10;



  /// The condition of a face: for each of three directions at right angles.
  /// What SideCondition is in two dimensions.
  struct FaceCondition
  {
    struct Component
    {
      Tensor<1, 3>      direction;
      SideConditionType type;
      /// A given traction or displacement at the corners of the face, between
      /// which it is linear, and what a load factor adds to a traction.
      std::array<double, 3> values  = {};
      std::array<double, 3> growths = {};
    };

    std::array<Component, 3> components;

    /// See SideCondition::is_reached.
    bool is_reached = false;
  };



  /// What the condition of a face at the boundary demands of a mechanism.
  struct FaceSupport
  {
    /// Nothing moves through the face.
    bool is_closed = false;
    /// To slide along the face, or along the indenter, takes plastic work.
    bool resists_slip = false;
  };



  /// A body in space as the equilibrium method needs it: the mesh, the
  /// materials, what acts on the faces, and the units in which it computes.
  struct SpaceBody
  {
    TetrahedralMesh               mesh;
    std::vector<FaceCondition>    conditions; ///< by faces
    std::vector<Material<double>> materials;  ///< by tetrahedra
    SurfaceFinish                 indenter_surface = SurfaceFinish::smooth;
    /// The gap between indenter and body, where the indenter can touch.
    std::function<double(const Point<3> &)> gap;
    Footprint<2>                            footprint;

    /// See PlaneBody.
    Tensor<1, 3> indenter_velocity = Tensor<1, 3>({0., 0., -1.});
    Tensor<1, 3> body_force;
    Tensor<1, 3> body_force_growth;

    double stress_unit;     ///< see HenckyMaterial::Units
    double strain_unit;     ///< likewise
    double length_unit = 0; ///< of the size of the body
    /// See PlaneBody; 0 if no load grows.
    double load_factor_unit = 0;

    /// The load in the direction of a @p component at a @p corner of a face, if
    /// the pressure of body forces is taken out of all stresses, and what a
    /// load factor adds to it: see PlaneBody::load().
    double
    load(const unsigned int face,
         const unsigned int component,
         const unsigned int corner) const;
    double
    growth(const unsigned int face,
           const unsigned int component,
           const unsigned int corner) const;

    double
    pressure_of_body_force(const Point<3> &x, const double load_factor) const;

    /// If a face is held in a direction oblique to it, it is taken to be
    /// closed, and rough if it is held in any direction along it: such a
    /// mechanism is admissible as well.
    FaceSupport
    support_of(const unsigned int face) const;

    /// Of a face at the boundary.
    Tensor<1, 3>
    outward_normal(const unsigned int face) const;

    /// What turns a traction at a corner of a face, in units of the body, into
    /// a force: a third of the area.
    double
    area_of_corner(const unsigned int face) const;

    /// The yield stress in shear of the weaker of the tetrahedra at a face.
    double
    shear_strength(const unsigned int face) const;

    /// The number of a @p corner of a @p face among those of all faces.
    static constexpr unsigned int
    index(const unsigned int face, const unsigned int corner)
    {
      return 3 * face + corner;
    }
  };



  /// How close the bounds come to the best ones of their mesh, relative.
  constexpr double usual_space_tolerance = 1e-5;



  /// Puts a SpaceBody together. The indenter can touch a face of the contact
  /// boundary where @p gap is finite in all of it, which it is in the
  /// @p footprint if that is known. If there is one material only, all cells
  /// are of it.
  /// @throws InputError for cells that cannot be cut into tetrahedra, and for
  /// tractions or displacements that are not linear on the faces.
  SpaceBody
  make_space_body(TetrahedralMesh                                mesh,
                  const BoundaryConditions<3>                   &conditions,
                  const std::vector<Material<double>>           &materials,
                  const std::function<double(const Point<3> &)> &gap,
                  const Loads<3>                                &loads,
                  const SurfaceFinish indenter_surface = SurfaceFinish::smooth,
                  const Footprint<2> &footprint        = {});
} // namespace ElastoPlastic

#endif
