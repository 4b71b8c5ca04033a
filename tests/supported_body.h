// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_supported_body_h
#define tests_supported_body_h

// Bodies of a few cells on supports, for tests of what these hold.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools.h>

#include <sstream>

#include "loads/supports.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/ready_meshes.h"
#include "sample_mesh.h"
#include "sample_model.h"

namespace SupportedBodies
{
  using namespace ElastoPlastic;

  using Vector = LinearAlgebra::distributed::Vector<double>;

  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  /// Makes a mesh. @return the names of its boundaries.
  template <int dim>
  using MeshMaker = std::function<BoundaryNames(Mesh<dim> &)>;



  template <int dim>
  BoundaryNames
  block(Mesh<dim> &mesh)
  {
    GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
    refine_corner(mesh);
    if (dim == 2)
      return {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}};
    return {{"left", 0},
            {"right", 1},
            {"front", 2},
            {"back", 3},
            {"bottom", 4},
            {"top", 5}};
  }



  /// A quadrilateral that stands on a slope of 63 degrees, normal (2, -1).
  inline BoundaryNames
  wedge(Mesh<2> &mesh)
  {
    const std::vector<Point<2>> vertices = {{0, 0}, {1, 2}, {0, 3}, {1, 3}};
    std::vector<CellData<2>>    cells(1);
    cells[0].vertices = {0, 1, 2, 3};
    mesh.create_triangulation(vertices, cells, SubCellData());
    const auto cell = mesh.begin_active();
    for (const unsigned int f : cell->face_indices())
      cell->face(f)->set_boundary_id(f);
    mesh.refine_global(1);
    return {{"left", 0}, {"right", 1}, {"slope", 2}, {"top", 3}};
  }



  template <int dim>
  MeshMaker<dim>
  part_of_ball(const HalfBallPart part)
  {
    return [=](Mesh<dim> &mesh) {
      HalfBallParameters parameters;
      parameters.part           = part;
      const BoundaryNames names = make_half_ball<dim>(parameters, mesh);
      mesh.refine_global(1);
      return names;
    };
  }



  template <int dim>
  class SupportedBody
  {
  public:
    SupportedBody(const MeshMaker<dim> &make_mesh,
                  const unsigned int    degree,
                  const std::string    &conditions)
      : mesh(MPI_COMM_WORLD)
      , names(make_mesh(mesh))
      , model(sample_model(read_conditions(conditions)))
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , supports(model)
    {
      dof_handler.distribute_dofs(fe);
      supports.reinit(dof_handler, /* time = */ 0.5);

      u.reinit(dof_handler.locally_owned_dofs(),
               supports.constraints().get_local_lines(),
               MPI_COMM_WORLD);
      VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), u);
      supports.move_fixed(u);
      supports.constraints().distribute(u);
      u.update_ghost_values();
    }

    /// The largest |violation(x, u(x))| at the nodes of a boundary.
    double
    largest(
      const std::string &boundary,
      const std::function<double(const Point<dim> &, const Tensor<1, dim> &)>
        &violation) const
    {
      const Quadrature<dim - 1>   nodes(fe.get_unit_face_support_points());
      FEFaceValues<dim>           values(fe,
                               nodes,
                               update_values | update_quadrature_points);
      std::vector<Tensor<1, dim>> displacements(nodes.size());
      double                      result = 0;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == names.at(boundary))
              {
                values.reinit(cell, f);
                values[FEValuesExtractors::Vector(0)].get_function_values(
                  u, displacements);
                for (const unsigned int q : values.quadrature_point_indices())
                  result =
                    std::max(result,
                             std::abs(violation(values.quadrature_point(q),
                                                displacements[q])));
              }
      return Utilities::MPI::max(result, MPI_COMM_WORLD);
    }

    /// The largest displacement along @p normal at the nodes of a boundary.
    double
    largest_along(const std::string    &boundary,
                  const Tensor<1, dim> &normal) const
    {
      return largest(boundary,
                     [&](const auto &, const auto &u) { return u * normal; });
    }

    /// The number of fixed unknowns on all ranks.
    double
    n_fixed() const
    {
      Vector marks(u.locally_owned_elements(), MPI_COMM_WORLD);
      supports.set_fixed_entries(marks, 1.);
      return marks.l1_norm();
    }

    /// Whether all ranks state the same conditions for the nodes that they
    /// know.
    bool
    ranks_agree() const
    {
      return supports.constraints().is_consistent_in_parallel(
        Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                   dof_handler.locally_owned_dofs()),
        supports.constraints().get_local_lines(),
        MPI_COMM_WORLD);
    }

    double
    norm() const
    {
      return u.l2_norm();
    }

    /// The first of the free_motions(): the name, and where the part is.
    std::string
    free_motion() const
    {
      Vector held(u.locally_owned_elements(),
                  supports.constraints().get_local_lines(),
                  MPI_COMM_WORLD);
      supports.set_fixed_entries(held, 1.);
      const auto motions =
        free_motions(dof_handler, held, supports.constraints());
      if (motions.empty())
        return "none";
      const FreeMotion<dim> &motion = motions.front();
      std::ostringstream     text;
      text << motion.name;
      if (!motion.whole_body)
        text << " of the part around (" << motion.part.center() << ')';
      return text.str();
    }

  private:
    BoundaryConditions<dim>
    read_conditions(const std::string &conditions) const
    {
      ParameterHandler            prm;
      BoundaryConditionParameters parameters;
      parameters.add_parameters(prm);
      prm.parse_input_from_string("subsection Boundary conditions\n" +
                                  conditions + "\nend");
      return BoundaryConditions<dim>(parameters, names);
    }

    Mesh<dim>           mesh;
    const BoundaryNames names;
    const Model<dim>    model;
    const FESystem<dim> fe;
    DoFHandler<dim>     dof_handler;
    Supports<dim>       supports;
    Vector              u;
  };
} // namespace SupportedBodies

#endif
