// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/cell_id.h>

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
    /// What has crossed so many cells, or ranks, goes in a ring around an edge
    /// of distorted ones, and stays where it is.
    constexpr unsigned int longest_way = 1000;

    using Indices = std::vector<types::global_dof_index>;

    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;


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



    /// Goes from @p cell straight to the cell that has @p point inside, or to
    /// the boundary of the body before it, or to one of two cells each of which
    /// takes it for inside of the other: the affine approximations of cells
    /// that are no parallelepipeds leave gaps. @return whether the way ends in
    /// @p cell; otherwise that is a ghost cell, and only its owner knows where
    /// it leads on.
    template <int dim>
    bool
    walk_to(const Point<dim> &point, Cell<dim> &cell)
    {
      Cell<dim> last = cell;
      for (unsigned int n = 0; n < longest_way; ++n)
        {
          const unsigned int face = face_towards<dim>(
            cell->real_to_unit_cell_affine_approximation(point), cell);
          if (face == numbers::invalid_unsigned_int)
            return true;
          const Cell<dim> next = neighbour<dim>(cell, face, point);
          if (next == last)
            return true;
          if (next->is_artificial())
            return false;
          last = std::exchange(cell, next);
        }
      return true;
    }



    /// The value of a field at @p point, if that is in @p cell, or else at the
    /// next place there; @p values are known on ghost cells, too.
    template <int dim>
    Tensor<1, dim>
    value_at(const VectorType &values,
             const Cell<dim>  &cell,
             const Point<dim> &point)
    {
      const Point<dim> place = GeometryInfo<dim>::project_to_unit_cell(
        cell->real_to_unit_cell_affine_approximation(point));
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



    /// A point on its way through the cells of several ranks.
    template <int dim>
    struct Traveller
    {
      /// Where it comes from: which node of which rank.
      unsigned int rank, node;
      Point<dim>   point;
      /// From where it goes on.
      CellId cell;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &rank &node &point &cell;
      }
    };

    /// By the rank that they go to.
    template <int dim>
    using Travellers = std::map<unsigned int, std::vector<Traveller<dim>>>;



    /// Lets @p travellers go on with the ranks that they have come to, until
    /// each has arrived, and gives @p nodes the values of a field there.
    /// Collective.
    template <int dim>
    void
    set_far_values(VectorType                   &field,
                   const std::vector<Node<dim>> &nodes,
                   Travellers<dim>               travellers,
                   const VectorType             &values,
                   const DoFHandler<dim>        &dof_handler)
    {
      const auto  communicator = communicator_of(dof_handler);
      const auto &mesh         = dof_handler.get_triangulation();

      using Value = std::pair<unsigned int, Tensor<1, dim>>;
      std::map<unsigned int, std::vector<Value>> answers;
      for (unsigned int n = 0; n < longest_way; ++n)
        {
          if (!Utilities::MPI::logical_or(!travellers.empty(), communicator))
            break;
          Travellers<dim> next;
          for (const auto &from :
               Utilities::MPI::some_to_some(communicator, travellers))
            for (Traveller<dim> traveller : from.second)
              {
                const auto on_mesh = mesh.create_cell_iterator(traveller.cell);
                Cell<dim>  cell(&mesh,
                               on_mesh->level(),
                               on_mesh->index(),
                               &dof_handler);
                if (walk_to(traveller.point, cell))
                  answers[traveller.rank].emplace_back(
                    traveller.node, value_at(values, cell, traveller.point));
                else
                  {
                    traveller.cell = cell->id();
                    next[cell->subdomain_id()].push_back(traveller);
                  }
              }
          travellers = std::move(next);
        }
      for (const auto &of_rank :
           Utilities::MPI::some_to_some(communicator, answers))
        for (const auto &[node, value] : of_rank.second)
          set_values(field, nodes[node], value);
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
    std::vector<Node<dim>> nodes  = own_nodes(dof_handler);
    Travellers<dim>        travellers;
    const unsigned int     rank =
      Utilities::MPI::this_mpi_process(communicator_of(dof_handler));
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const Point<dim> point = centre + (nodes[i].point - centre) / factor;
        Cell<dim>       &cell  = nodes[i].cell;
        if (walk_to(point, cell))
          set_values(result, nodes[i], value_at(values, cell, point));
        else
          travellers[cell->subdomain_id()].push_back(
            {rank, i, point, cell->id()});
      }
    set_far_values(result, nodes, std::move(travellers), values, dof_handler);
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
