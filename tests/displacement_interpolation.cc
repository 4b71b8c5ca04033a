// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Displacements of bilinear elements, also beside hanging nodes, become the
// same quadratic ones on the triangles of the split mesh.

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>

#include "bounds/mechanism/quadratic_field.h"
#include "sample_mesh.h"
#include "vector_field.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Bilinear on each cell of a block whose sides are parallel to the axes.
  const VectorField<2> bilinear([](const Point<2>    &x,
                                   const unsigned int component) {
    return component == 0 ? 0.3 * x[0] - x[1] + 0.5 * x[0] * x[1] :
                            0.1 + x[0] * (2. - x[1]);
  });



  void
  test_interpolation(const Triangulation<2> &triangulation)
  {
    const FESystem<2> fe(FE_Q<2>(1), 2);
    DoFHandler<2>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    VectorType values(dof_handler.locally_owned_dofs(),
                      relevant,
                      MPI_COMM_WORLD);
    VectorTools::interpolate(dof_handler, bilinear, values);

    const SplitMesh<2>      mesh = make_split_mesh(triangulation);
    const QuadraticField<2> field =
      QuadraticField<2>::interpolate_displacement(mesh, dof_handler, values);
    double value_error = 0, strain_error = 0;
    for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
      {
        const auto     corners = mesh.corners(mesh.simplices[t]);
        const auto     strain  = field.strains(mesh, t);
        const Point<2> center =
          corners[0] +
          ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.;
        for (unsigned int d = 0; d < 2; ++d)
          value_error =
            std::max(value_error,
                     std::abs(field.value(mesh.simplices[t],
                                          {{1. / 3., 1. / 3., 1. / 3.}})[d] -
                              bilinear.value(center, d)));
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Point<2>       &x = corners[i];
            SymmetricTensor<2, 2> exact;
            exact[0][0]  = 0.3 + 0.5 * x[1];
            exact[1][1]  = -x[0];
            exact[0][1]  = 0.5 * (-1. + 0.5 * x[0] + 2. - x[1]);
            strain_error = std::max(strain_error, (strain[i] - exact).norm());
          }
      }
    output() << "Interpolation" << std::endl;
    verify("values", value_error, 1e-13);
    verify("strains", strain_error, 1e-12);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize        mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_half_space_mesh(triangulation);
  test_interpolation(triangulation);
}
