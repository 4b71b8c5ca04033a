// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef adaptivity_kelly_estimator_h
#define adaptivity_kelly_estimator_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The error estimator of @cite kelly_1983 for a
  /// displacement u_h: for each cell K with the diameter h_K,
  ///
  ///   eta_K^2 = h_K / 24 sum_F int_F |[du_h/dn]|^2 ds,
  ///
  /// over the faces F that K shares with other cells, with the jump of the
  /// normal derivative in brackets. Not made for plasticity or contact, but
  /// finds the edge of the contact zone and of the plastic zone.
  ///
  /// These are the numbers of deal.II's KellyErrorEstimator, which takes three
  /// to four times as long: here, the shape functions' derivatives at the
  /// points of all faces, in all orientations, are those of the reference cell,
  /// tabulated once.
  template <int dim>
  class KellyEstimator
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// For @p fe = FE_Q^dim.
    explicit KellyEstimator(const FiniteElement<dim> &fe);

    /// The estimates for all active cells, zero for those of other ranks.
    /// @p u needs no ghost values. Collective.
    dealii::Vector<float>
    estimate(const DoFHandler<dim> &dof_handler, const Vector &u) const;

  private:
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /// A face as one of its cells sees it, or that part of it which is the face
    /// of a finer cell.
    struct Side
    {
      Cell         cell;
      unsigned int face;
      int          subface = whole_face;
    };
    static constexpr int whole_face = -1;

    /// What one side of a face needs: its cell's vertices, and whether the
    /// Jacobian of the mapping is the same everywhere; the values of u_h, all
    /// and node by node; at the quadrature points of the face, du_h/dn for the
    /// cell's own outer normal, and what the point stands for in integrals.
    struct SideField
    {
      Cell                                                         cell;
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell> vertices;
      bool                        is_parallelepiped;
      dealii::Vector<double>      dof_values;
      std::vector<Tensor<1, dim>> values;
      std::vector<Tensor<1, dim>> normal_derivatives;
      std::vector<double>         areas;
    };

    /// Calls @p use for both sides of each face between two cells, or part of
    /// one, of which this rank owns at least one: the first side is the whole
    /// face of its cell.
    template <typename Use>
    void
    for_each_face(const DoFHandler<dim> &dof_handler, const Use &use) const;

    /// Takes another cell.
    void
    read(const Cell &cell, const Vector &ghosted_u, SideField &field) const;

    void
    evaluate(const Side &side, const Vector &ghosted_u, SideField &field) const;

    /// The first of the tabulated points that belong to @p side.
    unsigned int
    first_point(const Side &side) const;

    const QGauss<dim - 1> quadrature;

    /// For each shape function: its node and its component.
    std::vector<std::pair<unsigned int, unsigned int>> shape_functions;

    /// At the points that QProjector makes of the quadrature, for all faces and
    /// then for all parts of faces: the gradients of the nodes' functions and
    /// of those of the vertices, which map the reference cell.
    unsigned int                             first_subface_point;
    std::vector<std::vector<Tensor<1, dim>>> node_gradients, vertex_gradients;
  };
} // namespace ElastoPlastic

#endif
