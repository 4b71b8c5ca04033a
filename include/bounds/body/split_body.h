// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_split_body_h
#define bounds_body_split_body_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/utilities.h>

#include <functional>
#include <vector>

#include "base/kinematics.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/loads.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mesh/integration.h"
#include "bounds/mesh/split_mesh.h"
#include "contact/contact_geometry.h"
#include "contact/footprint.h"
#include "indenter/indenter_parameters.h"
#include "loads/boundary_conditions.h"
#include "material/material.h"
#include "mechanics/initial_stress.h"

namespace ElastoPlastic
{
  /// What the condition of a face at the boundary demands of a mechanism.
  template <int dim>
  struct FaceSupport
  {
    /// Nothing moves through the face.
    bool is_closed = false;
    /// To slide along the face, or along the indenter, takes plastic work.
    bool resists_slip = false;
    /// Of what the body slides along, see SplitBody::indenter_velocity.
    Tensor<1, dim> velocity;
  };



  /// The problem of a body in space, of a plane section in plane strain, of a
  /// sheet, or of the half section x = r >= 0 of a body of revolution, as the
  /// equilibrium method needs it: the mesh, the materials, what acts on the
  /// faces, and the units in which it computes.
  template <int dim>
  struct SplitBody
  {
    SplitMesh<dim>                  mesh;
    std::vector<FaceCondition<dim>> conditions; ///< by faces
    std::vector<Material<double>>   materials;  ///< by simplices
    Kinematics                      kinematics       = Kinematics::cartesian;
    SurfaceFinish                   indenter_surface = SurfaceFinish::smooth;
    /// The gap between indenter and body, where the indenter can touch.
    std::function<double(const Point<dim> &)> gap;
    Footprint<dim - 1>                        footprint;
    /// Of the indenter, in a mechanism of collapse: down, or zero if it is
    /// other loads that grow.
    Tensor<1, dim> indenter_velocity = -Point<dim>::unit_vector(dim - 1);

    /// What acts on the volume, and what a load factor adds to it.
    Tensor<1, dim> body_force;
    Tensor<1, dim> live_body_force;
    /// Where the pressure of body forces is zero, x_0: a vertex of the mesh, at
    /// first, which circumscribe() may move.
    Point<dim> place_without_pressure;

    /// By simplices, not in plane stress: how the strength grows with the
    /// pressure, see bounds/conic/yield_conditions.h; none if no strength does.
    std::vector<double> friction_slopes;

    /// By simplices, at their corners: the elastic strain of the initial
    /// stress, linear between them; none if there is no such stress.
    std::vector<std::array<SymmetricTensor<2, 3>, dim + 1>> initial_strains;

    /// A typical stress: the smallest yield stress, or a modulus of elasticity;
    /// with friction, the strength that comes from constant loads if that is
    /// more.
    double stress_unit;
    /// A typical strain: this stress by Young's modulus.
    double strain_unit;
    double length_unit = 0; ///< of the size of the body
    /// A typical load factor, with which tractions or body forces are as large
    /// as stresses are; 0 if no load grows.
    double load_factor_unit = 0;

    /// Lets the strength depend on the pressure: @p slopes by material id, or
    /// one for all; nothing changes if all are zero.
    void
    set_friction(const std::vector<double> &slopes);

    /// Lets the body bear a stress before it is loaded (doc/theory, "Initial
    /// stress"). @throws InputError if it is not linear on each simplex.
    void
    set_initial_stress(const InitialStress<dim> &stress);

    Corners<dim>
    corners_of(const unsigned int simplex) const
    {
      return mesh.corners(mesh.simplices[simplex]);
    }

    FaceCorners<dim>
    corners_of_face(const unsigned int face) const
    {
      return mesh.corners(mesh.faces[face]);
    }

    bool
    is_axisymmetric() const
    {
      return kinematics == Kinematics::axisymmetric;
    }

    bool
    has_friction() const
    {
      return !friction_slopes.empty();
    }

    /// Whether velocities may slide along faces: not where such a slip is no
    /// pure shear, in plane stress and with friction.
    bool
    can_slide() const
    {
      return kinematics != Kinematics::plane_stress && !has_friction();
    }

    /// Of a body of revolution, with rounding errors.
    bool
    is_on_axis(const Point<dim> &x) const
    {
      return is_axisymmetric() && x[0] <= Tolerance::on_axis * length_unit;
    }

    /// What stresses are multiplied by to be in equilibrium like those of a
    /// plane section: the distance r from the axis of a body of revolution, or
    /// 1.
    double
    weight(const Point<dim> &x) const
    {
      return is_axisymmetric() ? x[0] : 1.;
    }

    /// The same at several corners.
    template <std::size_t n>
    std::array<double, n>
    weights(const std::array<Point<dim>, n> &corners) const
    {
      std::array<double, n> result;
      for (unsigned int i = 0; i < n; ++i)
        result[i] = weight(corners[i]);
      return result;
    }

    /// A typical value of it.
    double
    weight_unit() const
    {
      return is_axisymmetric() ? length_unit : 1.;
    }

    /// What weighted stresses, integrated over the mesh, are multiplied by to
    /// be those of the body: 2 pi, or 1.
    double
    angle() const
    {
      return is_axisymmetric() ? 2. * numbers::PI : 1.;
    }

    /// The size of a simplex and of a face in units of the body.
    double
    relative_volume(const unsigned int simplex) const
    {
      return ElastoPlastic::volume(corners_of(simplex)) /
             Utilities::fixed_power<dim>(length_unit);
    }
    double
    relative_area(const unsigned int face) const
    {
      return area(corners_of_face(face)) /
             Utilities::fixed_power<dim - 1>(length_unit);
    }

    /// Of the indenter, and of other forces, on the whole body of revolution.
    double
    force_unit() const
    {
      return stress_unit * Utilities::fixed_power<dim - 1>(length_unit) *
             weight_unit() * angle();
    }

    /// Of the ring whose section is a triangle, or of the triangle by unit of
    /// thickness, or of a tetrahedron.
    double
    volume(const unsigned int simplex) const;

    /// The body force f is that of a pressure f . (x - x_0) in the body, which
    /// is taken out of all stresses: so they have no divergence. The load that
    /// then acts at a point of a face, and what a load factor adds to it, in
    /// the direction of a component of its condition.
    TwoLoads
    loads(const unsigned int    face,
          const unsigned int    component,
          const FacePoint<dim> &point) const;

    /// That pressure.
    double
    pressure_of_body_force(const Point<dim> &x, const double load_factor) const
    {
      return (body_force + load_factor * live_body_force) *
             (x - place_without_pressure);
    }

    /// If a face is held in a direction oblique to it, it is taken to be
    /// closed, and rough if it is held in any direction along it: such a
    /// mechanism is admissible as well.
    FaceSupport<dim>
    support_of(const unsigned int face) const;

    /// Out of the first neighbour of a face.
    Tensor<1, dim>
    outward_normal(const unsigned int face) const;

    /// The largest norm that the deviator of this stress may have, in the
    /// material of a simplex that does not harden.
    double
    yield_radius(const unsigned int           simplex,
                 const SymmetricTensor<2, 3> &stress) const;

    /// The yield stress in shear of the weaker of the simplices at a face.
    double
    shear_strength(const unsigned int face) const;
  };



  /// How an indenter touches a body: the gap between them, and what is known of
  /// the points that it can touch; how it presses, and whether it is rough.
  template <int dim>
  struct IndenterOnBody
  {
    std::function<double(const Point<dim> &)> gap;
    SurfaceFinish                             surface = SurfaceFinish::smooth;
    ContactGeometry    geometry  = ContactGeometry::vertical;
    Footprint<dim - 1> footprint = {};
  };

  /// Puts a SplitBody together. Prescribed displacements are those at the time
  /// at which the loads begin. The indenter can touch a face of the contact
  /// boundary where the gap is finite in all of it, which it is in the
  /// footprint if that is known. It presses downwards, or with the geometry
  /// normal across the face, or automatic across the faces that it fits. If
  /// there is one material only, all cells are of it. @throws InputError for a
  /// body force that depends on the position; in space for cells that cannot be
  /// cut into tetrahedra, and for tractions or displacements that are not
  /// linear on the faces.
  template <int dim>
  SplitBody<dim>
  make_split_body(SplitMesh<dim>                       mesh,
                  const BoundaryConditions<dim>       &conditions,
                  const std::vector<Material<double>> &materials,
                  const IndenterOnBody<dim>           &indenter,
                  const Loads<dim>                    &loads,
                  const Kinematics kinematics = Kinematics::cartesian);

  /// The same body with another mesh, for mechanisms: the faces that the
  /// indenter reaches cover a polygon around its disc, not only one inside.
  ///
  /// The whole faces on a disc cover an inscribed polygon, if vertices of the
  /// mesh lie on the circle. These are moved outwards, so far that the edges
  /// between them leave the circle: the faces beside them are then no longer
  /// reached. Nothing else changes, so that stresses and velocities know the
  /// same pressure of body forces.
  ///
  /// The result is @p body itself if there is no disc; if no vertices are on
  /// the circle; and if moving them would change the boundary of the body or
  /// its conditions, or the material of a point, or turn over a tetrahedron.
  /// Mechanisms on either mesh give an upper bound.
  SplitBody<3>
  circumscribe(const SplitBody<3> &body);

  /// In the plane, sides end where the indenter does.
  inline SplitBody<2>
  circumscribe(const SplitBody<2> &body)
  {
    return body;
  }
} // namespace ElastoPlastic

#endif
