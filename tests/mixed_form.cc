// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Multigrid for nearly incompressible bodies on meshes with hanging nodes: the
// mixed form has the solution of the tangent itself, also if unknowns are
// coupled, after a number of iterations that depends neither on the mesh nor on
// Poisson's ratio.

#include "sample_block.h"

namespace
{
  /// The mixed form where there are no bounds of the iterations: with a
  /// pressure at each quadrature point, and with finite strains.
  template <int dim>
  void
  check_mixed_form(const unsigned int degree, const StrainModel &strain_model)
  {
    describe<dim>(degree, strain_model);
    Block<dim>(degree, strain_model, true, 1, 0.49).check_mixed_form();
  }



  template <int dim>
  void
  check_nearly_incompressible(const unsigned int degree,
                              const StrainModel &strain_model)
  {
    describe<dim>(degree, strain_model);
    for (const double poisson_ratio : {0.48, 0.499, 0.4999})
      {
        output() << " Poisson's ratio " << poisson_ratio << std::endl;
        const unsigned int n_refinements = (dim == 2 ? 5 - degree : 2);
        const Block<dim>   coarse(
          degree, strain_model, true, n_refinements - 1, poisson_ratio);
        coarse.check_mixed_form();
        const Block<dim> fine(
          degree, strain_model, true, n_refinements, poisson_ratio);
        verify("  in at most 30 iterations",
               coarse.n_iterations() <= 30 && fine.n_iterations() <= 30);
        const unsigned int n_alone = coarse.n_pressure_iterations();
        verify("  the pressures alone in at most 10",
               n_alone > 0 && n_alone <= 10);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_nearly_incompressible<2>(1, VolumetricTreatment::b_bar);
  check_nearly_incompressible<2>(2, VolumetricTreatment::b_bar);
  check_nearly_incompressible<2>(1,
                                 {VolumetricTreatment::b_bar,
                                  Kinematics::axisymmetric});
  check_nearly_incompressible<3>(1, VolumetricTreatment::b_bar);
  check_mixed_form<2>(2, VolumetricTreatment::standard);
  check_mixed_form<3>(2, VolumetricTreatment::standard);
  check_mixed_form<2>(1,
                      {VolumetricTreatment::b_bar,
                       Kinematics::axisymmetric,
                       Strain::logarithmic});
}
