// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/lac/householder.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "mesh/curved_boundaries.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Face = typename Triangulation<dim>::face_iterator;

    template <int dim>
    using Points = std::vector<Point<dim>>;



    template <int dim>
    struct Sphere
    {
      Point<dim> centre;
      double     radius;
    };



    /// The sphere that all @p points lie on. Its equation is linear in the
    /// centre c and in |c|^2 - R^2: |x|^2 = 2 c.x - (|c|^2 - R^2).
    template <int dim>
    std::optional<Sphere<dim>>
    sphere_through(const Points<dim> &points)
    {
      if (points.size() < dim + 1)
        return {};
      const Point<dim> origin = points.front();
      double           size   = 0;
      for (const Point<dim> &x : points)
        size = std::max(size, x.distance(origin));

      FullMatrix<double> matrix(points.size(), dim + 1);
      Vector<double>     squares(points.size()), solution(dim + 1);
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          const Tensor<1, dim> x = (points[i] - origin) / size;
          for (unsigned int d = 0; d < dim; ++d)
            matrix(i, d) = 2. * x[d];
          matrix(i, dim) = 1.;
          squares[i]     = x.norm_square();
        }
      Householder<double>(matrix).least_squares(solution, squares);

      Sphere<dim> sphere;
      for (unsigned int d = 0; d < dim; ++d)
        sphere.centre[d] = origin[d] + size * solution[d];
      sphere.radius = origin.distance(sphere.centre);
      for (const Point<dim> &x : points)
        if (!(std::abs(x.distance(sphere.centre) - sphere.radius) <
              1e-6 * sphere.radius))
          return {};
      return sphere;
    }



    /// A unit normal, of either sign.
    template <int dim>
    Tensor<1, dim>
    normal_of(const Face<dim> &face)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(face->vertex(1) - face->vertex(0));
      else
        normal = cross_product_3d(face->vertex(3) - face->vertex(0),
                                  face->vertex(2) - face->vertex(1));
      return normal / normal.norm();
    }



    template <int dim>
    bool
    is_flat(const BoundarySurface<dim> &surface)
    {
      const Tensor<1, dim> normal = normal_of<dim>(surface.faces.front());
      for (const auto &face : surface.faces)
        if (std::abs(normal_of<dim>(face) * normal) < 1 - 1e-10)
          return false;
      return true;
    }



    /// Some projection of the vertices, face by face.
    template <int dim, int projected_dim>
    std::vector<Points<projected_dim>>
    project(
      const BoundarySurface<dim>                                    &surface,
      const std::function<Point<projected_dim>(const Point<dim> &)> &projection)
    {
      std::vector<Points<projected_dim>> result;
      for (const auto &face : surface.faces)
        {
          result.emplace_back();
          for (const unsigned int v : face->vertex_indices())
            result.back().push_back(projection(face->vertex(v)));
        }
      return result;
    }



    /// The sphere through the vertices of all faces, if no face is longer than
    /// @p max_length radii.
    template <int dim>
    std::optional<Sphere<dim>>
    sphere_through_faces(const std::vector<Points<dim>> &faces,
                         const double                    max_length)
    {
      Points<dim> points;
      double      length = 0;
      for (const auto &face : faces)
        for (const Point<dim> &x : face)
          {
            points.push_back(x);
            length = std::max(length, x.distance(face.front()));
          }
      const auto sphere = sphere_through(points);
      return sphere && length < max_length * sphere->radius ? sphere :
                                                              std::nullopt;
    }



    /// The normals of a cylinder are normal to its axis.
    std::unique_ptr<Manifold<3>>
    recognise_cylinder(const BoundarySurface<3> &surface)
    {
      SymmetricTensor<2, 3> normals;
      for (const auto &face : surface.faces)
        normals +=
          symmetrize(outer_product(normal_of<3>(face), normal_of<3>(face)));
      const auto         axes   = eigenvectors(normals); // largest value first
      const Tensor<1, 3> axis   = axes[2].second;
      const auto         circle = sphere_through_faces<2>(
        project<3, 2>(surface,
                      [&](const Point<3> &x) {
                        return Point<2>(x * axes[0].second, x * axes[1].second);
                      }),
        1.05);
      if (axes[2].first > 1e-6 * axes[0].first || !circle)
        return nullptr;
      return std::make_unique<CylindricalManifold<3>>(
        axis,
        Point<3>(circle->centre[0] * axes[0].second +
                 circle->centre[1] * axes[1].second));
    }



    template <int dim>
    std::unique_ptr<Manifold<dim>>
    recognise_sphere(const BoundarySurface<dim> &surface)
    {
      const auto sphere = sphere_through_faces<dim>(
        project<dim, dim>(surface, [](const Point<dim> &x) { return x; }),
        dim == 2 ? 1.05 : 1.5);
      if (!sphere)
        return nullptr;
      return std::make_unique<SphericalManifold<dim>>(sphere->centre);
    }



    /// Whether neighbouring faces enclose an angle that is neither 0 nor that
    /// of an edge.
    template <int dim>
    bool
    bends_smoothly(const BoundarySurface<dim> &surface)
    {
      std::map<unsigned int, std::vector<Tensor<1, dim>>> normals;
      for (const auto &face : surface.faces)
        if constexpr (dim == 2)
          for (const unsigned int v : face->vertex_indices())
            normals[face->vertex_index(v)].push_back(normal_of<dim>(face));
        else
          for (unsigned int l = 0; l < face->n_lines(); ++l)
            normals[face->line_index(l)].push_back(normal_of<dim>(face));
      for (const auto &[joint, at_joint] : normals)
        if (at_joint.size() == 2)
          {
            const double angle =
              std::acos(std::min(1., std::abs(at_joint[0] * at_joint[1])));
            if (angle > 0.01 && angle < 0.8)
              return true;
          }
      return false;
    }



    std::string
    quoted_names(const BoundaryNames                &names,
                 const std::set<types::boundary_id> &ids)
    {
      std::string result;
      for (const auto &[name, id] : names)
        if (ids.count(id) > 0)
          result += (result.empty() ? "'" : ", '") + name + "'";
      return result;
    }



    /// Cells beside a curve that are thinner than the curve is high would turn
    /// over where refinement follows it.
    template <int dim>
    bool
    can_be_refined(const Triangulation<dim> &mesh)
    {
      Triangulation<dim> refined;
      refined.copy_triangulation(mesh);
      refined.refine_global(1);
      constexpr unsigned int n = GeometryInfo<dim>::vertices_per_cell;
      for (const auto &cell : refined.active_cell_iterators())
        {
          Point<dim>     corners[n];
          Tensor<0, dim> volumes[n];
          for (const unsigned int v : cell->vertex_indices())
            corners[v] = cell->vertex(v);
          GeometryInfo<dim>::alternating_form_at_vertices(corners, volumes);
          for (const auto &volume : volumes)
            if (!(volume > 0))
              return false;
        }
      return true;
    }



    /// Where a sphere meets a cylinder, the edge belongs to the cylinder, on
    /// which the points between two of a circle lie on the circle.
    /// @return the boundaries with a surface that bends smoothly and has not
    /// been recognised.
    template <int dim>
    std::set<types::boundary_id>
    attach_manifolds(const std::vector<BoundarySurface<dim>> &surfaces,
                     Triangulation<dim>                      &mesh)
    {
      std::set<types::boundary_id> not_recognised;
      types::manifold_id           next_id = 1;
      const auto attach = [&](const BoundarySurface<dim> &surface,
                              const Manifold<dim>        &manifold) {
        mesh.set_manifold(next_id, manifold);
        for (const auto &face : surface.faces)
          face->set_all_manifold_ids(next_id);
        ++next_id;
      };

      std::vector<
        std::pair<const BoundarySurface<dim> *, std::unique_ptr<Manifold<dim>>>>
        cylinders;
      for (const auto &surface : surfaces)
        {
          if (is_flat(surface))
            continue;
          if constexpr (dim == 3)
            if (auto cylinder = recognise_cylinder(surface))
              {
                cylinders.emplace_back(&surface, std::move(cylinder));
                continue;
              }
          if (const auto sphere = recognise_sphere(surface))
            attach(surface, *sphere);
          else if (bends_smoothly(surface))
            not_recognised.insert(surface.boundary);
        }
      for (const auto &[surface, manifold] : cylinders)
        attach(*surface, *manifold);
      return not_recognised;
    }
  } // namespace



  template <int dim>
  void
  follow_curved_boundaries(const std::vector<BoundarySurface<dim>> &surfaces,
                           const BoundaryNames                     &names,
                           const std::function<void(const std::string &)> &warn,
                           Triangulation<dim>                             &mesh)
  {
    const std::string remedy =
      " keep their straight edges when cells are divided. If that is meant, set "
      "'Geometry/Curves = straight'; else use a finer mesh there.";
    const auto not_recognised = attach_manifolds(surfaces, mesh);
    if (!not_recognised.empty())
      warn("These boundaries of the mesh file are curved, but not like " +
           std::string(dim == 2 ? "a circle" : "a sphere or a cylinder") +
           ", and" + remedy +
           " Boundaries: " + quoted_names(names, not_recognised) + '.');
    if (!can_be_refined(mesh))
      {
        mesh.reset_all_manifolds();
        mesh.set_all_manifold_ids(numbers::flat_manifold_id);
        warn(
          "Some cells beside the curved boundaries of the mesh file are so "
          "thin that they would turn over if refinement followed the curves. "
          "All boundaries" +
          remedy);
      }
  }



  template <int dim>
  bool
  has_curved_boundary(const Triangulation<dim> &mesh)
  {
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() &&
            face->manifold_id() != numbers::flat_manifold_id)
          return true;
    return false;
  }



  template bool
  has_curved_boundary(const Triangulation<2> &);
  template bool
  has_curved_boundary(const Triangulation<3> &);
  template void
  follow_curved_boundaries(const std::vector<BoundarySurface<2>> &,
                           const BoundaryNames &,
                           const std::function<void(const std::string &)> &,
                           Triangulation<2> &);
  template void
  follow_curved_boundaries(const std::vector<BoundarySurface<3>> &,
                           const BoundaryNames &,
                           const std::function<void(const std::string &)> &,
                           Triangulation<3> &);
} // namespace ElastoPlastic
