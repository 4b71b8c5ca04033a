// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>

#include <boost/serialization/utility.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "base/ghost_values.h"
#include "mechanics/stretched_field.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A point so near to a cell, in units of its size, is inside.
    constexpr double rounding = 1e-9;
    /// Who has crossed so many cells goes in a ring around an edge of distorted
    /// ones, and stays where he is.
    constexpr unsigned int longest_way = 1000;

    using Indices = std::vector<types::global_dof_index>;

    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    template <int dim>
    using IndexedPoint = std::pair<unsigned int, Point<dim>>;

    /// The face between @p cell and a neighbour beyond which this @p place of
    /// the unit cell is farthest, or an invalid number if there is none.
    template <int dim>
    unsigned int
    face_towards(const Point<dim> &place, const Cell<dim> &cell)
    {
      unsigned int result   = numbers::invalid_unsigned_int;
      double       farthest = rounding;
      for (const unsigned int face : cell->face_indices())
        if (const double coordinate = place[face / 2],
            distance = face % 2 == 0 ? -coordinate : coordinate - 1.;
            distance > farthest && !cell->at_boundary(face))
          {
            farthest = distance;
            result   = face;
          }
      return result;
    }



    /// The active cell behind this @p face of @p cell that is nearest to
    /// @p point.
    template <int dim>
    Cell<dim>
    neighbour(const Cell<dim>   &cell,
              const unsigned int face,
              const Point<dim>  &point)
    {
      if (!cell->neighbor(face)->has_children())
        return cell->neighbor(face);
      Cell<dim> nearest = cell->neighbor_child_on_subface(face, 0);
      for (unsigned int n = 1; n < cell->face(face)->n_children(); ++n)
        if (const auto child = cell->neighbor_child_on_subface(face, n);
            child->center().distance(point) < nearest->center().distance(point))
          nearest = child;
      return nearest;
    }



    /// Goes from @p cell straight to the cell that has @p point inside. @return
    /// where it is on the unit cell, or the next place there, if the way ends
    /// at the boundary of the body, or of what this rank knows of it (at an
    /// artificial cell), or between two cells each of which takes it for inside
    /// of the other: the affine approximations of cells that are no
    /// parallelepipeds leave gaps.
    template <int dim>
    Point<dim>
    walk_to(const Point<dim> &point, Cell<dim> &cell)
    {
      Point<dim> place;
      Cell<dim>  last = cell;
      for (unsigned int n = 0; n < longest_way && !cell->is_artificial(); ++n)
        {
          place = cell->real_to_unit_cell_affine_approximation(point);
          const unsigned int face = face_towards<dim>(place, cell);
          if (face == numbers::invalid_unsigned_int)
            break;
          const Cell<dim> next = neighbour<dim>(cell, face, point);
          if (next == last)
            break;
          last = std::exchange(cell, next);
        }
      return GeometryInfo<dim>::project_to_unit_cell(place);
    }



    /// The value of a field at this place of the unit cell; @p values are
    /// known on ghost cells, too.
    template <int dim>
    Tensor<1, dim>
    value_at(const VectorType &values,
             const Cell<dim>  &cell,
             const Point<dim> &place)
    {
      const auto &fe = cell->get_fe();
      Indices     indices(fe.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      Tensor<1, dim> value;
      for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
        {
          const double shape = fe.base_element(0).shape_value(i, place);
          for (unsigned int d = 0; d < dim; ++d)
            value[d] +=
              shape * values(indices[fe.component_to_system_index(d, i)]);
        }
      return value;
    }



    /// A node of this rank: its unknowns, where it is, and a cell around it.
    template <int dim>
    struct Node
    {
      std::array<types::global_dof_index, dim> unknowns;
      Point<dim>                               point;
      Cell<dim>                                cell;
    };



    template <int dim>
    std::vector<Node<dim>>
    own_nodes(const DoFHandler<dim> &dof_handler)
    {
      const MappingQ1<dim>   mapping;
      const auto            &fe    = dof_handler.get_fe();
      const IndexSet        &owned = dof_handler.locally_owned_dofs();
      std::vector<bool>      is_known(owned.n_elements());
      Indices                indices(fe.n_dofs_per_cell());
      std::vector<Node<dim>> nodes;
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell();
               ++i)
            {
              Node<dim> node;
              for (unsigned int d = 0; d < dim; ++d)
                node.unknowns[d] = indices[fe.component_to_system_index(d, i)];
              if (!owned.is_element(node.unknowns[0]))
                continue;
              const auto index = owned.index_within_set(node.unknowns[0]);
              if (is_known[index])
                continue;
              is_known[index] = true;
              node.cell       = cell;
              node.point      = mapping.transform_unit_to_real_cell(
                cell, fe.base_element(0).unit_support_point(i));
              nodes.push_back(node);
            }
        }
      return nodes;
    }



    template <int dim>
    void
    set_values(VectorType           &field,
               const Node<dim>      &node,
               const Tensor<1, dim> &value)
    {
      for (unsigned int d = 0; d < dim; ++d)
        field(node.unknowns[d]) = value[d];
    }



    /// A box around the cells of this rank.
    template <int dim>
    BoundingBox<dim>
    box_of_own_cells(const DoFHandler<dim> &dof_handler)
    {
      std::vector<Point<dim>> corners;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int vertex : cell->vertex_indices())
            corners.push_back(cell->vertex(vertex));
      return corners.empty() ? BoundingBox<dim>() : BoundingBox<dim>(corners);
    }



    /// The @p points with their indices, for each rank in whose box they are.
    /// Collective.
    template <int dim>
    std::map<unsigned int, std::vector<IndexedPoint<dim>>>
    points_for_ranks(const std::vector<Node<dim>> &nodes,
                     const DoFHandler<dim>        &dof_handler)
    {
      const auto boxes =
        Utilities::MPI::all_gather(communicator_of(dof_handler),
                                   box_of_own_cells(dof_handler));
      std::map<unsigned int, std::vector<IndexedPoint<dim>>> points;
      for (unsigned int rank = 0; rank < boxes.size(); ++rank)
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (boxes[rank].point_inside(nodes[i].point, rounding))
            points[rank].emplace_back(i, nodes[i].point);
      return points;
    }



    /// Gives @p nodes the values of a field at their points, which are in cells
    /// of other ranks: each rank is asked for those near to its cells. What is
    /// in no cell keeps its value. Collective.
    template <int dim>
    void
    set_far_values(VectorType                   &field,
                   const std::vector<Node<dim>> &nodes,
                   const VectorType             &values,
                   const DoFHandler<dim>        &dof_handler)
    {
      const auto                  communicator = communicator_of(dof_handler);
      const auto                 &mesh = dof_handler.get_triangulation();
      const MappingQ1<dim>        mapping;
      const GridTools::Cache<dim> cache(mesh, mapping);

      using Value = std::pair<unsigned int, Tensor<1, dim>>;
      std::map<unsigned int, std::vector<Value>> answers;
      for (const auto &[rank, points] :
           Utilities::MPI::some_to_some(communicator,
                                        points_for_ranks(nodes, dof_handler)))
        for (const auto &[i, point] : points)
          {
            const auto [cell, place] =
              GridTools::find_active_cell_around_point(cache, point);
            if (cell.state() == IteratorState::valid && !cell->is_artificial())
              answers[rank].emplace_back(i,
                                         value_at<dim>(values,
                                                       {&mesh,
                                                        cell->level(),
                                                        cell->index(),
                                                        &dof_handler},
                                                       place));
          }
      for (const auto &of_rank :
           Utilities::MPI::some_to_some(communicator, answers))
        for (const auto &[i, value] : of_rank.second)
          set_values(field, nodes[i], value);
    }
  } // namespace



  template <int dim>
  VectorType
  stretched_field(const VectorType                &field,
                  const double                     factor,
                  const Point<dim>                &centre,
                  const DoFHandler<dim>           &dof_handler,
                  const AffineConstraints<double> &constraints)
  {
    const VectorType       values = ghosted_copy(field, dof_handler);
    VectorType             result = field;
    std::vector<Node<dim>> far_nodes;
    for (Node<dim> &node : own_nodes(dof_handler))
      {
        node.point             = centre + (node.point - centre) / factor;
        const Point<dim> place = walk_to<dim>(node.point, node.cell);
        if (node.cell->is_artificial())
          far_nodes.push_back(node);
        else
          set_values(result, node, value_at(values, node.cell, place));
      }
    if (Utilities::MPI::logical_or(!far_nodes.empty(),
                                   communicator_of(dof_handler)))
      set_far_values(result, far_nodes, values, dof_handler);
    constraints.distribute(result);
    return result;
  }



  template VectorType
  stretched_field(const VectorType &,
                  const double,
                  const Point<2> &,
                  const DoFHandler<2> &,
                  const AffineConstraints<double> &);
  template VectorType
  stretched_field(const VectorType &,
                  const double,
                  const Point<3> &,
                  const DoFHandler<3> &,
                  const AffineConstraints<double> &);
} // namespace ElastoPlastic
