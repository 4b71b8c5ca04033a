// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Fields stretched about a point, on any number of ranks: linear ones with
// elements of degree 1, and quadratic ones of degree 2, are what they are at
// the places that are asked for, also on meshes with hanging nodes. From
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

#include <cmath>
#include <vector>

#include "mechanics/stretched_field.h"
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
      {
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->center().distance(corner) < 1.5 * cell->diameter())
            cell->set_refine_flag();
        mesh.execute_coarsening_and_refinement();
      }
  }



  /// A polynomial of this degree, at x or where it has been stretched from.
  template <int dim>
  class Polynomial : public Function<dim>
  {
  public:
    Polynomial(const unsigned int degree,
               const double       factor,
               const Point<dim>  &centre)
      : Function<dim>(dim)
      , degree(degree)
      , factor(factor)
      , centre(centre)
    {}

    double
    value(const Point<dim> &x, const unsigned int component) const override
    {
      const Point<dim> origin = centre + (x - centre) / factor;
      const double     other  = origin[(component + 1) % dim];
      return 1. + component - 0.7 * origin[component] +
             0.4 * std::pow(other, degree);
    }

  private:
    const unsigned int degree;
    const double       factor;
    const Point<dim>   centre;
  };



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
      fields.interpolated(Polynomial<dim>(degree, 1., corner));
    for (const double factor : {1.03, 1.4, 5.})
      {
        VectorType error = stretched_field(
          field, factor, corner, fields.dof_handler, fields.constraints);
        error -= fields.interpolated(Polynomial<dim>(degree, factor, corner));
        verify("by " + std::to_string(factor), error.linfty_norm(), 1e-12);
      }

    Point<dim> outside;
    outside[0]               = -10.;
    const VectorType shifted = stretched_field(
      field, 2., outside, fields.dof_handler, fields.constraints);
    verify("from outside of the body",
           shifted.linfty_norm() <= field.linfty_norm() + 1e-12);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(1);
  test<2>(2);
  test<3>(1);
}
