// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The gap is looked at on a lattice with so many intervals along each side
    /// of a face.
    constexpr unsigned int n_intervals = 8;

    template <int dim>
    std::vector<Barycentric<dim - 1>>
    lattice_points()
    {
      std::vector<Barycentric<dim - 1>> points;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        for (unsigned int j = 0; j <= (dim == 3 ? n_intervals - i : 0); ++j)
          {
            Barycentric<dim - 1> point = {};
            point[0]                   = 1. - (i + j) / double(n_intervals);
            point[1]                   = i / double(n_intervals);
            point[dim - 1] += dim == 3 ? j / double(n_intervals) : 0.;
            points.push_back(point);
          }
      return points;
    }



    /// The same condition in the directions of all axes.
    template <int dim>
    FaceCondition<dim>
    along_axes(const ConditionType type)
    {
      FaceCondition<dim> condition;
      for (unsigned int d = 0; d < dim; ++d)
        condition.components[d] = {Point<dim>::unit_vector(d), type};
      return condition;
    }



    /// Gives the components the directions along the face, and across it the
    /// component number @p across.
    template <int dim>
    void
    turn(FaceCondition<dim>     &condition,
         const FaceCorners<dim> &corners,
         const unsigned int      across)
    {
      const auto   along = tangents(corners);
      unsigned int i     = 0;
      for (unsigned int d = 0; d < dim; ++d)
        condition.components[d].direction =
          d == across ? normal(corners) : along[i++];
    }



    template <int dim>
    FaceCondition<dim>
    on_roller(const FaceCorners<dim> &corners)
    {
      auto condition               = along_axes<dim>(ConditionType::traction);
      condition.components[0].type = ConditionType::displacement;
      turn<dim>(condition, corners, 0);
      return condition;
    }



    /// A function of the position as it is on a face: at its ends what it is
    /// inside.
    FaceValue<2>
    value_on_face(const FaceCorners<2>                          &corners,
                  const std::function<double(const Point<2> &)> &function)
    {
      return {
        [function, centre = centre_of(corners)](const FacePoint<2> &point) {
          return function(from_inside(point.x, centre));
        }};
    }



    /// Whether @p function is the linear one with these values at the corners,
    /// at points that are neither those of a regular mesh nor of a finer one.
    bool
    is_linear(const FaceCorners<3>                          &corners,
              const std::array<double, 3>                   &at_corners,
              const std::function<double(const Point<3> &)> &function)
    {
      double largest = 0;
      for (const double at_corner : at_corners)
        keep_largest(largest, std::abs(at_corner));
      for (const auto &[position, weight] : points_over_face<3>())
        {
          const double exact = function(point_on_face<3>(corners, position).x);
          if (!(std::abs(exact - interpolate(position, at_corners)) <=
                Tolerance::expression * std::max(largest, std::abs(exact))))
            return false;
        }
      return true;
    }



    /// The same in space; from inside where the function jumps at a corner.
    FaceValue<3>
    value_on_face(const FaceCorners<3>                          &corners,
                  const std::function<double(const Point<3> &)> &function)
    {
      const Point<3> centre = centre_of(corners);
      for (const bool is_inside : {false, true})
        {
          std::array<double, 3> at_corners;
          for (unsigned int i = 0; i < 3; ++i)
            at_corners[i] = function(
              is_inside ? from_inside(corners[i], centre) : corners[i]);
          if (is_linear(corners, at_corners, function))
            return at_corners == std::array<double, 3>() ?
                     FaceValue<3>() :
                     FaceValue<3>{[at_corners](const FacePoint<3> &point) {
                       return interpolate(point.position, at_corners);
                     }};
        }
      throw InputError(
        "A traction or displacement of 'Boundary conditions' is not linear on "
        "the faces of the mesh, near the point (" +
        Patterns::Tools::to_string(centre) +
        "). In space, the equilibrium method is for such that are linear "
        "functions of x, y and z on each face. Put jumps and kinks on edges of "
        "the mesh.");
    }



    /// Tells the conditions of faces from those of the boundaries. The
    /// arguments must live as long as this object.
    template <int dim>
    class FaceConditions
    {
    public:
      FaceConditions(const BoundaryConditions<dim> &conditions,
                     const IndenterOnBody<dim>     &indenter,
                     const Loads<dim>              &loads)
        : contact(conditions.ids(BoundaryConditionType::contact))
        , fixed(conditions.ids(BoundaryConditionType::fixed))
        , rollers(conditions.ids(BoundaryConditionType::roller))
        , displacements(conditions.prescribed_displacements())
        , tractions(conditions.tractions())
        , indenter(indenter)
        , loads(loads)
      {}

      /// Of a face with these corners. @throws InputError
      FaceCondition<dim>
      of_face(const FaceCorners<dim>  &corners,
              const types::boundary_id id) const
      {
        if (id == numbers::internal_face_boundary_id)
          return along_axes<dim>(ConditionType::continuous);
        if (fixed.count(id) > 0)
          return along_axes<dim>(ConditionType::displacement);
        auto condition = rollers.count(id) > 0 ?
                           on_roller<dim>(corners) :
                           along_axes<dim>(ConditionType::traction);
        if (contact.count(id) > 0)
          add_contact(condition, corners);
        prescribe(
          condition, ConditionType::displacement, displacements, id, corners);
        prescribe(condition, ConditionType::traction, tractions, id, corners);
        return condition;
      }

    private:
      using Values = std::map<types::boundary_id,
                              typename BoundaryConditions<dim>::Components>;

      /// How much of a face the indenter can touch.
      enum class Reach
      {
        none,
        part,
        whole
      };

      /// Lets the indenter press where it can.
      void
      add_contact(FaceCondition<dim>     &condition,
                  const FaceCorners<dim> &corners) const
      {
        const Reach reach         = reach_of(corners);
        condition.is_reached      = reach != Reach::none;
        const bool     is_rough   = indenter.surface == SurfaceFinish::rough;
        Tensor<1, dim> horizontal = normal(corners);
        horizontal[dim - 1]       = 0.;
        if (condition.is_reached && is_rough &&
            horizontal.norm() > Tolerance::small_angle)
          throw InputError("Indenter/Surface",
                           "rough",
                           "the bounds of a rough indenter are for contact "
                           "boundaries that are level where it can touch. "
                           "Choose 'smooth', or reduce 'Indenter/Reach'.");
        if (condition.is_reached && presses_across(corners))
          turn<dim>(condition, corners, dim - 1);
        if (reach != Reach::whole)
          return;
        condition.components[dim - 1].type = ConditionType::contact;
        if (is_rough)
          for (unsigned int d = 0; d + 1 < dim; ++d)
            condition.components[d].type = ConditionType::displacement;
      }

      void
      prescribe(FaceCondition<dim>      &condition,
                const ConditionType      type,
                const Values            &values,
                const types::boundary_id id,
                const FaceCorners<dim>  &corners) const
      {
        const auto found = values.find(id);
        if (found == values.end())
          return;
        for (unsigned int d = 0; d < dim; ++d)
          if (found->second[d])
            {
              const auto at = [expression = found->second[d]](const auto &x) {
                return [expression, x](const double time) {
                  return expression->value(x, time);
                };
              };
              auto &component = condition.components[d];
              component       = {Point<dim>::unit_vector(d), type};
              component.value =
                value_on_face(corners,
                              [at, loads = loads](const Point<dim> &x) {
                                return loads.constant_part(at(x));
                              });
              if (type == ConditionType::traction)
                component.live_load =
                  value_on_face(corners,
                                [at, loads = loads](const Point<dim> &x) {
                                  return loads.growing_part(at(x));
                                });
            }
      }

      /// At the points of a lattice, but where the indenter does not reach.
      std::vector<double>
      gaps_of(const FaceCorners<dim> &corners) const
      {
        const Point<dim>    centre = centre_of(corners);
        std::vector<double> gaps;
        static const auto   points = lattice_points<dim>();
        for (const auto &lattice_point : points)
          {
            const Point<dim> x = point_on_face<dim>(corners, lattice_point).x;
            if (const double value = indenter.gap(
                  Point<dim>(x + Tolerance::inset_of_gap * (centre - x)));
                std::isfinite(value))
              gaps.push_back(value);
          }
        return gaps;
      }

      // Points of the face must do where nothing else is known than the gap at
      // points.
      Reach
      reach_of(const FaceCorners<dim> &corners) const
      {
        const auto &footprint = indenter.footprint;
        if (footprint.is_known())
          return contains(footprint, corners) ? Reach::whole :
                 overlaps(footprint, corners) ? Reach::part :
                                                Reach::none;
        const auto n_finite = gaps_of(corners).size();
        return n_finite == 0                           ? Reach::none :
               n_finite < lattice_points<dim>().size() ? Reach::part :
                                                         Reach::whole;
      }

      /// Whether the indenter presses across a face that it reaches. It fits
      /// the face if the gap is the same everywhere.
      bool
      presses_across(const FaceCorners<dim> &corners) const
      {
        if (indenter.geometry != ContactGeometry::automatic)
          return indenter.geometry == ContactGeometry::normal;
        const auto gaps = gaps_of(corners);
        return !gaps.empty() &&
               std::abs(gaps.front() - gaps.back()) <=
                 Tolerance::fit_of_indenter * corners[0].distance(corners[1]);
      }

      const std::set<types::boundary_id> contact;
      const std::set<types::boundary_id> fixed;
      const std::set<types::boundary_id> rollers;
      const Values                      &displacements;
      const Values                      &tractions;
      const IndenterOnBody<dim>         &indenter;
      const Loads<dim>                  &loads;
    };
  } // namespace



  template <int dim>
  std::vector<FaceCondition<dim>>
  conditions_of_faces(const SplitMesh<dim>          &mesh,
                      const BoundaryConditions<dim> &conditions,
                      const IndenterOnBody<dim>     &indenter,
                      const Loads<dim>              &loads)
  {
    const FaceConditions<dim>       of(conditions, indenter, loads);
    std::vector<FaceCondition<dim>> result;
    for (const auto &face : mesh.faces)
      result.push_back(of.of_face(mesh.corners(face), face.boundary_id));
    return result;
  }



  template std::vector<FaceCondition<2>>
  conditions_of_faces(const SplitMesh<2> &,
                      const BoundaryConditions<2> &,
                      const IndenterOnBody<2> &,
                      const Loads<2> &);
  template std::vector<FaceCondition<3>>
  conditions_of_faces(const SplitMesh<3> &,
                      const BoundaryConditions<3> &,
                      const IndenterOnBody<3> &,
                      const Loads<3> &);
} // namespace ElastoPlastic
