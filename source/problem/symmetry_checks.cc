// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
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



    /// Whether the indenter is as high above most points around its tip as
    /// above their mirror images: those that are made of triangles or pixels
    /// may differ in some. @p size is that of the body.
    template <int dim>
    bool
    is_symmetric_about_plane(const GapFunction<dim> &gap_function,
                             const Tensor<1, 3>     &normal,
                             const double            size)
    {
      constexpr unsigned int n_radii = 32, n_directions = 12;
      constexpr double       ratio = 0.7, like = 0.01, rounding = 1e-6;

      Point<dim>     tip;
      Tensor<1, dim> across;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          tip[d]    = gap_function.position()[d];
          across[d] = normal[d];
        }
      const double lowest = gap_function.value(tip);
      int          n_like = 0, n_unlike = 0;
      double       radius = size;
      for (unsigned int i = 0; i < n_radii; ++i, radius *= ratio)
        for (unsigned int k = 0; k < n_directions; ++k)
          {
            const double   angle = i + 2. * numbers::PI * k / n_directions;
            Tensor<1, dim> offset;
            offset[0] = radius * std::cos(angle);
            if (dim == 3)
              offset[1] = radius * std::sin(angle);
            const double gap      = gap_function.value(tip + offset);
            const double of_image = gap_function.value(
              tip + offset - 2. * (offset * across) * across);
            if (std::isinf(gap) && std::isinf(of_image))
              continue;
            const bool is_like =
              std::isfinite(gap) && std::isfinite(of_image) &&
              std::abs(gap - of_image) <=
                like * (std::max(gap, of_image) - lowest) + rounding * radius;
            ++(is_like ? n_like : n_unlike);
          }
      return n_unlike <= n_like;
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
        "('Indenter/Rotation') so that the plane is one of its own, choose "
        "another part of the body (half of it, or 'Geometry/Sector angle'), or "
        "model the whole body.");
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
