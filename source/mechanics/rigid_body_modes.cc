// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "base/compatibility.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/connected_parts.h"

namespace ElastoPlastic
{
  namespace
  {
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// The (unordered) pairs of axes that a body can rotate between.
    template <int dim>
    std::vector<std::pair<unsigned int, unsigned int>>
    rotation_planes()
    {
      if constexpr (dim == 2)
        return {{0, 1}};
      else
        return {{1, 2}, {2, 0}, {0, 1}};
    }



    template <int dim>
    BoundingBox<dim>
    global_bounding_box(const DoFHandler<dim> &dof_handler)
    {
      BoundingBox<dim> box =
        GridTools::compute_bounding_box(dof_handler.get_triangulation());
      const MPI_Comm communicator = communicator_of(dof_handler);
      auto [lower, upper]         = box.get_boundary_points();
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = Utilities::MPI::min(lower[d], communicator);
          upper[d] = Utilities::MPI::max(upper[d], communicator);
        }
      return BoundingBox<dim>({lower, upper});
    }



    /// "translation along x", "rotation about z"
    template <int dim>
    std::string
    name_of_mode(const unsigned int mode)
    {
      const std::string axes = "xyz";
      if (mode < dim)
        return std::string("translation along ") + axes[mode];
      return std::string("rotation about ") +
             (dim == 2 ? 'z' : axes[mode - dim]);
    }


    /// The rigid body motions of the cells that @p moves accepts, zero at the
    /// nodes of no such cell. Rotations are about the midpoint of @p box and
    /// relative to its diagonal.
    template <int dim>
    std::vector<Vector>
    modes_of_cells(
      const DoFHandler<dim>  &dof_handler,
      const BoundingBox<dim> &box,
      const std::function<bool(const typename DoFHandler<dim>::cell_iterator &)>
                   &moves,
      const Vector &layout)
    {
      const Point<dim> centre = box.center();
      const double     size   = box.get_boundary_points().first.distance(
        box.get_boundary_points().second);

      const auto          planes = rotation_planes<dim>();
      std::vector<Vector> modes(dim + planes.size());
      for (Vector &mode : modes)
        mode.reinit(layout);

      const auto          &fe    = dof_handler.get_fe();
      const auto          &owned = dof_handler.locally_owned_dofs();
      const MappingQ1<dim> mapping;
      std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (!cell->is_artificial() && moves(cell))
          {
            cell->get_dof_indices(dof_indices);
            for (unsigned int i = 0; i < dof_indices.size(); ++i)
              if (owned.is_element(dof_indices[i]))
                {
                  const Point<dim> x = mapping.transform_unit_to_real_cell(
                    cell, fe.unit_support_point(i));
                  const unsigned int component =
                    fe.system_to_component_index(i).first;
                  modes[component](dof_indices[i]) = 1.;
                  for (unsigned int r = 0; r < planes.size(); ++r)
                    {
                      const auto [first, second] = planes[r];
                      if (component == first)
                        modes[dim + r](dof_indices[i]) =
                          -(x[second] - centre[second]) / size;
                      else if (component == second)
                        modes[dim + r](dof_indices[i]) =
                          (x[first] - centre[first]) / size;
                    }
                }
          }
      return modes;
    }



    /// What each of @p modes violates the supports by: its entries at the held
    /// unknowns, and its distance to what the constraints make of it.
    std::vector<Vector>
    violations_by(const std::vector<Vector>       &modes,
                  const Vector                    &held,
                  const AffineConstraints<double> &constraints)
    {
      std::vector<Vector> violations = modes;
      for (unsigned int j = 0; j < modes.size(); ++j)
        {
          Vector constrained = modes[j];
          constraints.distribute(constrained);
          violations[j].scale(held);
          violations[j] += modes[j];
          violations[j] -= constrained;
        }
      return violations;
    }



    /// Products of violations are rounding errors below that, relative.
    constexpr double negligible = 1e-10;



    /// The vectors that a positive semidefinite @p matrix, beside the @p scale
    /// of its entries, maps to zero.
    FullMatrix<double>
    null_space(LAPACKFullMatrix<double> matrix, const double scale)
    {
      FullMatrix<double> vectors;
      if (matrix.m() == 0)
        return vectors;
      dealii::Vector<double> eigenvalues;
      matrix.compute_eigenvalues_symmetric(
        -scale, negligible * scale, 0., eigenvalues, vectors);
      if (eigenvalues.size() == 0)
        vectors.reinit(0, 0);
      return vectors;
    }



    /// The products of some @p violations with each other.
    LAPACKFullMatrix<double>
    gram_matrix(const std::vector<Vector>       &violations,
                const std::vector<unsigned int> &some)
    {
      const unsigned int       n = some.size();
      LAPACKFullMatrix<double> gram(n, n);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          gram(i, j) = violations[some[i]] * violations[some[j]];
      return gram;
    }



    /// A basis of the factors c of the motions sum_j c_j m_j of the modes m_j
    /// that nothing prevents, because sum_j c_j v_j = 0 for their violations
    /// v_j of the supports: first the modes that are free alone, which the
    /// other ones are without.
    std::vector<std::vector<double>>
    free_combinations(const std::vector<Vector> &violations)
    {
      const unsigned int        n = violations.size();
      std::vector<unsigned int> all(n), others;
      std::iota(all.begin(), all.end(), 0);
      const auto   gram  = gram_matrix(violations, all);
      const double scale = gram.frobenius_norm();

      std::vector<std::vector<double>> result;
      for (unsigned int mode = 0; mode < n; ++mode)
        if (gram(mode, mode) <= negligible * scale)
          {
            result.emplace_back(n, 0.);
            result.back()[mode] = 1.;
          }
        else
          others.push_back(mode);

      const auto vectors = null_space(gram_matrix(violations, others), scale);
      for (unsigned int k = 0; k < vectors.n(); ++k)
        {
          result.emplace_back(n, 0.);
          for (unsigned int i = 0; i < others.size(); ++i)
            result.back()[others[i]] = vectors(i, k);
        }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<Vector>
  rigid_body_modes(const DoFHandler<dim> &dof_handler, const Vector &layout)
  {
    return modes_of_cells<dim>(
      dof_handler,
      global_bounding_box(dof_handler),
      [](const auto &) { return true; },
      layout);
  }



  template <int dim>
  std::vector<FreeMotion<dim>>
  free_motions(const DoFHandler<dim>           &dof_handler,
               const Vector                    &held,
               const AffineConstraints<double> &constraints)
  {
    const auto magnitude = [](const double a, const double b) {
      return std::abs(a) < std::abs(b);
    };
    std::vector<FreeMotion<dim>> result;
    const ConnectedParts<dim>    parts(dof_handler.get_triangulation());
    for (unsigned int part = 0; part < parts.size(); ++part)
      {
        const auto modes = modes_of_cells<dim>(
          dof_handler,
          parts.box(part),
          [&](const auto &cell) { return parts.part_of(cell) == part; },
          held);
        for (const std::vector<double> &factors :
             free_combinations(violations_by(modes, held, constraints)))
          {
            const auto largest =
              std::max_element(factors.begin(), factors.end(), magnitude);
            Vector displacement;
            displacement.reinit(held);
            for (unsigned int mode = 0; mode < modes.size(); ++mode)
              displacement.add(factors[mode], modes[mode]);
            result.push_back({name_of_mode<dim>(largest - factors.begin()),
                              parts.box(part),
                              parts.size() == 1,
                              displacement});
          }
      }
    return result;
  }



  template std::vector<Vector>
  rigid_body_modes(const DoFHandler<2> &, const Vector &);
  template std::vector<Vector>
  rigid_body_modes(const DoFHandler<3> &, const Vector &);
  template std::vector<FreeMotion<2>>
  free_motions(const DoFHandler<2> &,
               const Vector &,
               const AffineConstraints<double> &);
  template std::vector<FreeMotion<3>>
  free_motions(const DoFHandler<3> &,
               const Vector &,
               const AffineConstraints<double> &);
} // namespace ElastoPlastic
