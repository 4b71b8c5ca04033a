// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <utility>

#include "mechanics/rigid_body_modes.h"

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
      const MPI_Comm communicator = dof_handler.get_communicator();
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
  } // namespace



  template <int dim>
  std::vector<Vector>
  rigid_body_modes(const DoFHandler<dim> &dof_handler, const Vector &layout)
  {
    const BoundingBox<dim> box    = global_bounding_box(dof_handler);
    const Point<dim>       centre = box.center();
    const double           size   = box.get_boundary_points().first.distance(
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
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dof_indices);
          for (unsigned int i = 0; i < dof_indices.size(); ++i)
            if (owned.is_element(dof_indices[i]))
              {
                const Point<dim> x =
                  mapping.transform_unit_to_real_cell(cell,
                                                      fe.unit_support_point(i));
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



  // A combination c of the modes is free if sum_j c_j v_j = 0, where v_j is
  // what mode j violates the supports by: its entries at the held unknowns, and
  // its distance to what the constraints make of it.
  template <int dim>
  std::string
  find_free_motion(const std::vector<Vector>       &modes,
                   const Vector                    &held,
                   const AffineConstraints<double> &constraints)
  {
    const unsigned int  n          = modes.size();
    std::vector<Vector> violations = modes;
    Vector              constrained;
    for (unsigned int j = 0; j < n; ++j)
      {
        constrained = modes[j];
        constraints.distribute(constrained);
        violations[j].scale(held);
        violations[j] += modes[j];
        violations[j] -= constrained;
      }

    LAPACKFullMatrix<double> gram(n, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        gram(i, j) = violations[i] * violations[j];

    const double           scale = std::max(gram.frobenius_norm(), 1e-300);
    dealii::Vector<double> eigenvalues;
    FullMatrix<double>     eigenvectors;
    gram.compute_eigenvalues_symmetric(
      -scale, 1e-10 * scale, 0., eigenvalues, eigenvectors);
    if (eigenvalues.size() == 0)
      return "";

    unsigned int largest = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (std::abs(eigenvectors(i, 0)) > std::abs(eigenvectors(largest, 0)))
        largest = i;
    return name_of_mode<dim>(largest);
  }



  template std::vector<Vector>
  rigid_body_modes(const DoFHandler<2> &, const Vector &);
  template std::vector<Vector>
  rigid_body_modes(const DoFHandler<3> &, const Vector &);
  template std::string
  find_free_motion<2>(const std::vector<Vector> &,
                      const Vector &,
                      const AffineConstraints<double> &);
  template std::string
  find_free_motion<3>(const std::vector<Vector> &,
                      const Vector &,
                      const AffineConstraints<double> &);
} // namespace ElastoPlastic
