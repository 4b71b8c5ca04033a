// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Geometric multigrid on meshes with hanging nodes: the operator of the finest
// level is the tangent, its matrix and diagonal are right, the transfer is
// exact for linear functions, and the iterations hardly grow with refinement.

#include "sample_block.h"

namespace
{
  template <int dim>
  void
  check(const unsigned int degree, const StrainModel &strain_model)
  {
    describe<dim>(degree, strain_model);
    Block<dim>(degree, strain_model, true, 1).check_finest_level();
    Block<dim>(degree, strain_model, true, 1).check_transfer();
    const unsigned int n_refinements = (dim == 2 ? 4 : 2);
    const unsigned int coarse =
      Block<dim>(degree, strain_model, true, n_refinements - 1).n_iterations();
    const unsigned int fine =
      Block<dim>(degree, strain_model, true, n_refinements).n_iterations();
    verify("  in at most 15 iterations", coarse <= 15 && fine <= 15);
    verify("  at most 30 % more on a finer mesh", fine <= 1.3 * coarse);
  }



  /// A finite deformation that is the same everywhere, so that one tangent for
  /// each cell is all of it.
  template <int dim>
  void
  check_deformed(const StrainModel &strain_model)
  {
    describe<dim>(1, strain_model);
    Block<dim> block(1, strain_model, false, 1);
    block.deform();
    block.check_finest_level();
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const auto treatment :
         {VolumetricTreatment::standard, VolumetricTreatment::b_bar})
      {
        check<2>(degree, treatment);
        check<2>(degree, {treatment, Kinematics::axisymmetric});
        check<2>(degree, {treatment, Kinematics::plane_stress});
        check<3>(degree, treatment);
      }

  for (const auto treatment :
       {VolumetricTreatment::standard, VolumetricTreatment::b_bar})
    {
      check_deformed<2>(
        {treatment, Kinematics::cartesian, Strain::logarithmic});
      check_deformed<3>(
        {treatment, Kinematics::cartesian, Strain::logarithmic});
    }
}
