// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Fields stretched about a point, on any number of ranks: linear ones with
// elements of degree 1, and quadratic ones of degree 2, are what they are at
// the places that are asked for, also on meshes with hanging nodes. In a ball,
// whose cells are no parallelepipeds, they are up to a part of a cell. From
// outside of the body come values of its boundary.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mechanics/stretched_field.h"
#include "refine_where.h"
#include "vector_field.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// The upper side is refined towards its first corner.
  template <int dim>
  void
  make_mesh(parallel::distributed::Triangulation<dim> &mesh,
            const Point<dim>                          &corner)
  {
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = d + 1 < dim ? 0. : -1.;
        upper[d] = d + 1 < dim ? 1.5 : 0.;
      }
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              std::vector<unsigned int>(dim, 4),
                                              lower,
                                              upper);
    for (unsigned int i = 0; i < 3; ++i)
      refine_where(mesh, [&](const auto &cell) {
        return cell->center().distance(corner) < 1.5 * cell->diameter();
      });
  }



  /// A polynomial of this degree, at x or where it has been stretched from.
  template <int dim>
  VectorField<dim>
  polynomial(const unsigned int degree,
             const double       factor,
             const Point<dim>  &centre)
  {
    return VectorField<dim>(
      [=](const Point<dim> &x, const unsigned int component) {
        const Point<dim> origin = centre + (x - centre) / factor;
        const double     other  = origin[(component + 1) % dim];
        return 1. + component - 0.7 * origin[component] +
               0.4 * std::pow(other, degree);
      });
  }



  template <int dim>
  class Fields
  {
  public:
    Fields(const Triangulation<dim> &mesh, const unsigned int degree)
      : fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
    {
      dof_handler.distribute_dofs(fe);
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints.reinit(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      owned.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
    }

    VectorType
    interpolated(const Function<dim> &function) const
    {
      VectorType values = owned;
      VectorTools::interpolate(dof_handler, function, values);
      constraints.distribute(values);
      return values;
    }

    const FESystem<dim>       fe;
    DoFHandler<dim>           dof_handler;
    AffineConstraints<double> constraints;

  private:
    VectorType owned;
  };



  template <int dim>
  void
  test(const unsigned int degree)
  {
    output() << dim << "D, degree " << degree << std::endl;
    const Point<dim>                          corner;
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh, corner);
    const Fields<dim> fields(mesh, degree);
    const VectorType  field =
      fields.interpolated(polynomial<dim>(degree, 1., corner));
    for (const double factor : {1.03, 1.4, 5.})
      {
        VectorType error = stretched_field(
          field, factor, corner, fields.dof_handler, fields.constraints);
        error -= fields.interpolated(polynomial<dim>(degree, factor, corner));
        verify("by " + std::to_string(factor), error.linfty_norm(), 1e-12);
      }
  }



  /// The same of a linear field in a part of a ball around @p corner, up to
  /// this part of its largest value.
  template <int dim>
  void
  test_ball(const double tolerance)
  {
    output() << dim << "D, ball" << std::endl;
    const Point<dim>                          corner;
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::quarter_hyper_ball(mesh, corner, 1.);
    mesh.refine_global(3);
    const Fields<dim> fields(mesh, 1);
    const VectorType  field =
      fields.interpolated(polynomial<dim>(1, 1., corner));
    for (const double factor : {1.05, 2.})
      {
        VectorType error = stretched_field(
          field, factor, corner, fields.dof_handler, fields.constraints);
        error -= fields.interpolated(polynomial<dim>(1, factor, corner));
        verify("by " + std::to_string(factor),
               error.linfty_norm() / field.linfty_norm(),
               tolerance);
      }
  }



  /// The first coordinate of a point that is so many times as far from the
  /// origin, or of the boundary before it.
  template <int dim>
  VectorField<dim>
  first_coordinate(const double multiple)
  {
    return VectorField<dim>(
      [=](const Point<dim> &x, const unsigned int component) {
        return component == 0 ? std::min(1.5, multiple * x[0]) : 0.;
      });
  }



  /// A field that is pulled together about a corner by 2: beyond the middle
  /// of the body it comes from outside, and is that of the boundary.
  template <int dim>
  void
  test_outside()
  {
    const Point<dim>                          corner;
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh, corner);
    const Fields<dim> fields(mesh, 1);
    const VectorType  field    = fields.interpolated(first_coordinate<dim>(1.));
    const VectorType  expected = fields.interpolated(first_coordinate<dim>(2.));
    const VectorType  result   = stretched_field(
      field, 0.5, corner, fields.dof_handler, fields.constraints);
    VectorType error = result;
    error -= expected;
    verify("from outside of the body", error.linfty_norm(), 1e-12);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(1);
  test<2>(2);
  test<3>(1);
  test_ball<2>(0.02);
  test_ball<3>(0.02);
  output() << "outside" << std::endl;
  test_outside<2>();
  test_outside<3>();
}
