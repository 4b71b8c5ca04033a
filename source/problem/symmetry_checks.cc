// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "mesh/body_size.h"
#include "mesh/boundary_faces.h"
#include "mesh/material_ids.h"
#include "problem/problem_checks.h"

namespace ElastoPlastic
{
  namespace
  {
    using Stress = SymmetricTensor<2, 3>;

    /// Five deviators, of which all others are sums, and the sums of any two of
    /// them: quadratic forms of deviators that agree on these are the same.
    std::vector<Stress>
    sample_deviators()
    {
      std::array<Stress, 5> basis;
      basis[0][0][0] = basis[1][1][1] = 1.;
      basis[0][1][1] = basis[1][2][2] = -1.;
      basis[2][0][1] = basis[3][0][2] = basis[4][1][2] = 1.;
      std::vector<Stress> result;
      for (unsigned int i = 0; i < basis.size(); ++i)
        {
          result.push_back(basis[i]);
          for (unsigned int j = 0; j < i; ++j)
            result.push_back(basis[i] + basis[j]);
        }
      return result;
    }



    /// Whether the equivalent stress is the same for a stress and its mirror
    /// image.
    bool
    is_symmetric_about_plane(const GeneralCriterion &criterion,
                             const Tensor<1, 3>     &normal)
    {
      constexpr double rounding = 1e-8;

      const Tensor<2, 3> mirror = Tensor<2, 3>(unit_symmetric_tensor<3>()) -
                                  2. * outer_product(normal, normal);
      const auto equivalent = [&](const Stress &deviator) {
        return std::visit(
          [&](const auto &of_type) {
            return of_type.equivalent_stress(deviator);
          },
          criterion);
      };
      const std::vector<Stress> stresses = sample_deviators();
      return std::all_of(stresses.begin(),
                         stresses.end(),
                         [&](const Stress &stress) {
                           const Stress image =
                             symmetrize(mirror * Tensor<2, 3>(stress) * mirror);
                           const double value = equivalent(stress);
                           return std::abs(equivalent(image) - value) <=
                                  rounding * value;
                         });
    }



    /// A point of a plane of symmetry.
    struct SymmetryPoint
    {
      Point<3>     place;
      Tensor<1, 3> normal;
      unsigned int material; ///< which of those of the model is there
    };

    /// The middles of the faces of this process on rollers in vertical planes
    /// through the indenter's first position.
    template <int dim>
    std::vector<SymmetryPoint>
    points_of_symmetry(const Model<dim>         &model,
                       const Triangulation<dim> &triangulation)
    {
      constexpr double rounding = 1e-8;

      const auto rollers =
        model.boundary_conditions.ids(BoundaryConditionType::roller);
      const FE_Nothing<dim>      fe;
      FEFaceValues<dim>          values(fe,
                               QMidpoint<dim - 1>(),
                               update_normal_vectors |
                                 update_quadrature_points);
      std::vector<SymmetryPoint> result;
      for (const auto &[cell, f] : owned_faces(triangulation, rollers))
        {
          values.reinit(cell, f);
          const auto           face     = cell->face(f);
          const Tensor<1, dim> normal   = values.normal_vector(0);
          const auto           vertices = face->vertex_indices();
          if (std::abs(normal[dim - 1]) > rounding ||
              !std::all_of(vertices.begin(), vertices.end(), [&](const auto v) {
                double distance = 0;
                for (unsigned int d = 0; d < dim - 1; ++d)
                  distance += normal[d] *
                              (face->vertex(v)[d] - model.indenter.position[d]);
                return std::abs(distance) < rounding * face->diameter();
              }))
            continue;
          SymmetryPoint     &point       = result.emplace_back();
          const unsigned int n_materials = model.materials.size();
          if (n_materials > 1)
            check_material_id(*cell, n_materials);
          point.material = n_materials > 1 ? cell->material_id() : 0;
          for (unsigned int d = 0; d < dim; ++d)
            {
              point.place[d]  = values.quadrature_point(0)[d];
              point.normal[d] = normal[d];
            }
        }
      return result;
    }



    /// One of each plane.
    std::vector<Tensor<1, 3>>
    distinct_normals(const std::vector<SymmetryPoint> &points)
    {
      std::vector<Tensor<1, 3>> normals;
      for (const SymmetryPoint &point : points)
        if (std::none_of(normals.begin(),
                         normals.end(),
                         [&point](const Tensor<1, 3> &normal) {
                           constexpr double rounding = 1e-6;
                           return (normal - point.normal).norm() < rounding;
                         }))
          normals.push_back(point.normal);
      return normals;
    }



    /// The gap at a point, or infinity where an expression has no value, as may
    /// be beyond the body.
    template <int dim>
    double
    gap_if_any(const GapFunction<dim> &gap_function, const Point<dim> &x)
    {
      try
        {
          return gap_function.value(x);
        }
      catch (const InputError &)
        {
          return std::numeric_limits<double>::infinity();
        }
    }



    /// The gaps on a circle of this @p radius around the tip and at the mirror
    /// images, where there are any; in two dimensions at points within.
    template <int dim>
    std::vector<std::array<double, 2>>
    gaps_and_images(const GapFunction<dim> &gap_function,
                    const Point<dim>       &tip,
                    const Tensor<1, dim>   &normal,
                    const double            radius)
    {
      constexpr unsigned int             n_directions = 12;
      std::vector<std::array<double, 2>> result;
      for (unsigned int k = 0; k < n_directions; ++k)
        {
          // (no direction of a usual pyramid)
          const double   angle = 0.1 + 2. * numbers::PI * k / n_directions;
          Tensor<1, dim> offset;
          offset[0] = radius * std::cos(angle);
          if (dim == 3)
            offset[1] = radius * std::sin(angle);
          const Tensor<1, dim> image = offset - 2. * (offset * normal) * normal;
          const std::array<double, 2> gaps = {
            {gap_if_any(gap_function, tip + offset),
             gap_if_any(gap_function, tip + image)}};
          if (std::isfinite(gaps[0]) || std::isfinite(gaps[1]))
            result.push_back(gaps);
        }
      return result;
    }



    /// Whether the indenter is as high above most points around its position as
    /// above their mirror images, on the outermost circles that it reaches:
    /// within, a tip may be rounded, or consist of few triangles or pixels.
    /// @p size is that of the body.
    template <int dim>
    bool
    is_symmetric_about_plane(const GapFunction<dim> &gap_function,
                             const Tensor<1, 3>     &normal_in_space,
                             const double            size)
    {
      constexpr unsigned int n_circles = 8, n_trials = 32;
      constexpr double       ratio = 0.7, like = 0.05, rounding = 1e-6;

      Point<dim>     tip;
      Tensor<1, dim> normal;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          tip[d]    = gap_function.position()[d];
          normal[d] = normal_in_space[d];
        }
      unsigned int n_reached = 0;
      int          balance   = 0; // of like and unlike pairs
      double       radius    = size;
      for (unsigned int i = 0; i < n_trials && n_reached < n_circles;
           ++i, radius *= ratio)
        {
          const auto pairs = gaps_and_images(gap_function, tip, normal, radius);
          std::vector<double> heights = {gap_if_any(gap_function, tip)};
          for (const auto &gaps : pairs)
            heights.insert(heights.end(), gaps.begin(), gaps.end());
          heights.erase(std::remove_if(heights.begin(),
                                       heights.end(),
                                       [](const double gap) {
                                         return std::isinf(gap);
                                       }),
                        heights.end());
          if (pairs.empty())
            continue;
          ++n_reached;
          const auto [lowest, highest] =
            std::minmax_element(heights.begin(), heights.end());
          const double allowed =
            like * (*highest - *lowest) + rounding * radius;
          for (const auto &[gap, of_image] : pairs)
            balance += std::abs(gap - of_image) <= allowed ? 1 : -1;
        }
      return balance >= 0;
    }
  } // namespace



  // (In a body of revolution, the axes of the material turn around the axis.)
  template <int dim>
  void
  check_symmetry_of_materials(
    const Model<dim>                                &model,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    if (!model.strain_model.has_general_criteria ||
        model.strain_model.kinematics == Kinematics::axisymmetric)
      return;
    bool is_unlike = false;
    rethrow_collectively(communicator_of(triangulation), [&]() {
      for (const auto &[place, normal, id] :
           points_of_symmetry(model, triangulation))
        {
          const Material<double> &material = model.materials[id];
          is_unlike =
            is_unlike ||
            !is_symmetric_about_plane(has_varying_criterion(material) ?
                                        material.criterion_at(place) :
                                        *material.criteria[0],
                                      normal);
        }
    });
    if (Utilities::MPI::logical_or(is_unlike, communicator_of(triangulation)))
      throw InputError(
        "The rollers through 'Indenter/Position' make a plane of symmetry of "
        "the body, but its material is not symmetric about that: with these "
        "'Material/Axes' and 'Material/Hill ratios', the mirror image of the "
        "material is another one. Turn the axes so that one of them is "
        "perpendicular to the plane, or model the whole body.");
  }



  // (Turned around the axis, each indenter is symmetric.)
  template <int dim>
  void
  check_symmetry_of_indenter(
    const Model<dim>                                &model,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    if (model.strain_model.kinematics == Kinematics::axisymmetric)
      return;
    const double size      = body_size(triangulation);
    bool         is_unlike = false;
    rethrow_collectively(communicator_of(triangulation), [&]() {
      for (const Tensor<1, 3> &normal :
           distinct_normals(points_of_symmetry(model, triangulation)))
        is_unlike =
          is_unlike || !is_symmetric_about_plane(gap_function, normal, size);
    });
    if (Utilities::MPI::logical_or(is_unlike, communicator_of(triangulation)))
      throw InputError(
        "The rollers through 'Indenter/Position' make a plane of symmetry of "
        "the body, but the indenter is not symmetric about that: half of it "
        "would press as if its mirror image were the other half. Turn it "
        "('Indenter/Rotation') so that the plane is one of its own, type both "
        "sides of an 'Indenter/Expression' (abs(x) for x), choose another part "
        "of the body (half of it, or 'Geometry/Sector angle'), or model the "
        "whole body.");
  }



  template void
  check_symmetry_of_indenter(const Model<2> &,
                             const GapFunction<2> &,
                             const parallel::distributed::Triangulation<2> &);
  template void
  check_symmetry_of_indenter(const Model<3> &,
                             const GapFunction<3> &,
                             const parallel::distributed::Triangulation<3> &);
  template void
  check_symmetry_of_materials(const Model<2> &,
                              const parallel::distributed::Triangulation<2> &);
  template void
  check_symmetry_of_materials(const Model<3> &,
                              const parallel::distributed::Triangulation<3> &);
} // namespace ElastoPlastic
