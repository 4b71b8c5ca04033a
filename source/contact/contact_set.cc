// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/throw_together.h"
#include "contact/contact_set.h"

namespace ElastoPlastic
{
  namespace
  {
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// Calls body(cell, face_no) for all faces of @p cells on @p boundaries.
    template <typename CellRange, typename Body>
    void
    for_each_face(const CellRange                    &cells,
                  const std::set<types::boundary_id> &boundaries,
                  const Body                         &body)
    {
      for (const auto &cell : cells)
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              boundaries.count(cell->face(f)->boundary_id()) > 0)
            body(cell, f);
    }



    /// The lumped boundary mass D of the vertical component, condensed: the
    /// integrals of the shape functions.
    template <int dim>
    void
    compute_lumped_areas(const DoFHandler<dim>              &dof_handler,
                         const AffineConstraints<double>    &constraints,
                         const std::set<types::boundary_id> &boundaries,
                         Vector                             &areas)
    {
      const auto                          &fe = dof_handler.get_fe();
      const QGauss<dim - 1>                quadrature(fe.degree + 1);
      FEFaceValues<dim>                    fe_face_values(fe,
                                       quadrature,
                                       update_values | update_JxW_values);
      dealii::Vector<double>               cell_areas(fe.n_dofs_per_cell());
      std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_cell());

      const auto cells = dof_handler.active_cell_iterators() |
                         IteratorFilters::LocallyOwnedCell();
      for_each_face(cells, boundaries, [&](const auto &cell, const auto f) {
        fe_face_values.reinit(cell, f);
        cell_areas = 0;
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          if (fe.system_to_component_index(i).first == dim - 1)
            for (const unsigned int q :
                 fe_face_values.quadrature_point_indices())
              cell_areas(i) +=
                fe_face_values.shape_value(i, q) * fe_face_values.JxW(q);
        cell->get_dof_indices(dof_indices);
        constraints.distribute_local_to_global(cell_areas, dof_indices, areas);
      });
      areas.compress(VectorOperation::add);
    }
  } // namespace



  template <int dim>
  ContactSet<dim>::ContactSet(
    const std::function<double(const Point<dim> &)> &gap)
    : gap(gap)
    , communicator(MPI_COMM_SELF)
  {}



  template <int dim>
  void
  ContactSet<dim>::reinit(
    const DoFHandler<dim>              &dof_handler,
    const AffineConstraints<double>    &constraints,
    const std::set<types::boundary_id> &contact_boundaries,
    const IndexSet                     &supported_dofs,
    const Vector                       &layout)
  {
    communicator    = layout.get_mpi_communicator();
    first_owned_dof = layout.get_partitioner()->local_range().first;

    Vector areas;
    areas.reinit(layout);
    compute_lumped_areas(dof_handler, constraints, contact_boundaries, areas);
    throw_together(communicator, [&]() {
      find_nodes(
        dof_handler, constraints, contact_boundaries, supported_dofs, areas);
    });
  }



  template <int dim>
  void
  ContactSet<dim>::find_nodes(
    const DoFHandler<dim>              &dof_handler,
    const AffineConstraints<double>    &constraints,
    const std::set<types::boundary_id> &contact_boundaries,
    const IndexSet                     &supported_dofs,
    const Vector                       &areas)
  {
    const auto               &fe = dof_handler.get_fe();
    const Quadrature<dim - 1> nodes(fe.get_unit_face_support_points());
    FEFaceValues<dim> fe_face_values(fe, nodes, update_quadrature_points);
    std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_face());

    std::map<types::global_dof_index, double> gaps; // ordered, and each once
    // A node's owner need not own one of its contact faces: look at ghosts too.
    const auto cells =
      filter_iterators(dof_handler.active_cell_iterators(),
                       [](const auto &cell) { return !cell->is_artificial(); });
    for_each_face(
      cells, contact_boundaries, [&](const auto &cell, const auto f) {
        fe_face_values.reinit(cell, f);
        cell->face(f)->get_dof_indices(dof_indices);
        for (unsigned int i = 0; i < dof_indices.size(); ++i)
          if (fe.face_system_to_component_index(i).first == dim - 1 &&
              dof_handler.locally_owned_dofs().is_element(dof_indices[i]))
            gaps[dof_indices[i]] = gap(fe_face_values.quadrature_point(i));
      });

    candidates.clear();
    hanging_nodes.clear();
    for (const auto &[dof, gap] : gaps)
      if (std::isfinite(gap) && !supported_dofs.is_element(dof))
        {
          const unsigned int index = dof - first_owned_dof;
          const Node node{index, gap, areas.local_element(index), false};
          (constraints.is_constrained(dof) ? hanging_nodes : candidates)
            .push_back(node);
        }
  }



  template <int dim>
  void
  ContactSet<dim>::set_depth(const double new_depth)
  {
    depth = new_depth;
  }



  template <int dim>
  double
  ContactSet<dim>::bound(const Node &node) const
  {
    return node.gap - depth;
  }



  template <int dim>
  template <typename Predicate>
  bool
  ContactSet<dim>::set_active(const Predicate &is_active)
  {
    bool changed = false;
    for (Node &node : candidates)
      {
        const bool active = is_active(node);
        changed           = changed || (active != node.active);
        node.active       = active;
      }
    return Utilities::MPI::logical_or(changed, communicator);
  }



  template <int dim>
  void
  ContactSet<dim>::activate_touching(const Vector &u)
  {
    const double contact_tolerance = 1e-8 * std::abs(depth);
    set_active([&](const Node &node) {
      return u.local_element(node.index) >= bound(node) - contact_tolerance;
    });
  }



  template <int dim>
  bool
  ContactSet<dim>::update(const Vector &u, const Vector &residual)
  {
    return set_active([&](const Node &node) {
      return node.active ? residual.local_element(node.index) > 0 :
                           u.local_element(node.index) > bound(node);
    });
  }



  template <int dim>
  bool
  ContactSet<dim>::update_feasible(const Vector &u, const Vector &residual)
  {
    return set_active([&](const Node &node) {
      return u.local_element(node.index) >= bound(node) &&
             residual.local_element(node.index) > 0;
    });
  }



  template <int dim>
  std::uint64_t
  ContactSet<dim>::fingerprint() const
  {
    std::uint64_t sum = 0;
    for (const Node &node : candidates)
      if (node.active)
        {
          // the splitmix64 finalizer spreads neighbouring indices
          std::uint64_t x = first_owned_dof + node.index + 1;
          x               = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
          x               = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
          sum += x ^ (x >> 31);
        }
    return Utilities::MPI::sum(sum, communicator);
  }



  template <int dim>
  unsigned int
  ContactSet<dim>::n_candidates() const
  {
    return Utilities::MPI::sum(static_cast<unsigned int>(candidates.size()),
                               communicator);
  }



  template <int dim>
  unsigned int
  ContactSet<dim>::n_active() const
  {
    return Utilities::MPI::sum(static_cast<unsigned int>(std::count_if(
                                 candidates.begin(),
                                 candidates.end(),
                                 [](const Node &node) { return node.active; })),
                               communicator);
  }



  template <int dim>
  double
  ContactSet<dim>::min_gap() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Node &node : candidates)
      smallest = std::min(smallest, node.gap);
    return Utilities::MPI::min(smallest, communicator);
  }



  template <int dim>
  void
  ContactSet<dim>::move_active(Vector &u) const
  {
    for (const Node &node : candidates)
      if (node.active)
        u.local_element(node.index) = bound(node);
  }



  template <int dim>
  void
  ContactSet<dim>::project(Vector &u) const
  {
    for (const Node &node : candidates)
      u.local_element(node.index) =
        std::min(u.local_element(node.index), bound(node));
  }



  template <int dim>
  void
  ContactSet<dim>::set_active_entries(Vector &vector, const double value) const
  {
    for (const Node &node : candidates)
      if (node.active)
        vector.local_element(node.index) = value;
  }



  template <int dim>
  void
  ContactSet<dim>::set_candidate_entries(Vector      &vector,
                                         const double value) const
  {
    for (const Node &node : candidates)
      vector.local_element(node.index) = value;
  }



  template <int dim>
  ContactState
  ContactSet<dim>::state(const Vector &u, const Vector &residual) const
  {
    const auto penetration = [&](const Node &node) {
      return std::max(0., u.local_element(node.index) - bound(node));
    };

    double force = 0, area = 0, work = 0, max_penetration = 0;
    double max_hanging_penetration = 0, max_pressure = 0;
    double min_pressure = std::numeric_limits<double>::infinity();
    for (const Node &node : candidates)
      {
        const double nodal_force = residual.local_element(node.index);
        if (node.active)
          {
            force += nodal_force;
            area += node.area;
            max_pressure = std::max(max_pressure, nodal_force / node.area);
            min_pressure = std::min(min_pressure, nodal_force / node.area);
          }
        work +=
          std::abs(nodal_force * (bound(node) - u.local_element(node.index)));
        max_penetration = std::max(max_penetration, penetration(node));
      }
    for (const Node &node : hanging_nodes)
      max_hanging_penetration =
        std::max(max_hanging_penetration, penetration(node));

    ContactState state;
    state.force           = Utilities::MPI::sum(force, communicator);
    state.area            = Utilities::MPI::sum(area, communicator);
    state.n_active        = n_active();
    state.max_pressure    = Utilities::MPI::max(max_pressure, communicator);
    state.max_penetration = Utilities::MPI::max(max_penetration, communicator);
    state.max_hanging_penetration =
      Utilities::MPI::max(max_hanging_penetration, communicator);
    if (state.n_active > 0)
      {
        state.min_pressure = Utilities::MPI::min(min_pressure, communicator);
        state.complementarity_error = Utilities::MPI::sum(work, communicator) /
                                      std::abs(state.force * depth);
      }
    return state;
  }



  template <int dim>
  void
  ContactSet<dim>::surface_fields(Vector       &gap,
                                  Vector       &pressure,
                                  Vector       &active,
                                  const Vector &u,
                                  const Vector &residual) const
  {
    for (const auto *const nodes : {&candidates, &hanging_nodes})
      for (const Node &node : *nodes)
        gap.local_element(node.index) =
          bound(node) - u.local_element(node.index);
    for (const Node &node : candidates)
      if (node.active)
        {
          pressure.local_element(node.index) =
            residual.local_element(node.index) / node.area;
          active.local_element(node.index) = 1;
        }
  }



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
