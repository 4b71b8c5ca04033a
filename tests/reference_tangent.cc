// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Products of a level of multigrid in space whose cells are no boxes, with
// reference tangents, against quadrature: the same in parallelepipeds. On other
// cells, they are symmetric and positive, know translations, and are close.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "base/compatibility.h"
#include "mechanics/cell_kernel.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int dim = 3;
  using LevelVector          = LinearAlgebra::distributed::Vector<float>;
  using Transformation       = Point<dim> (*)(const Point<dim> &);

  Point<dim>
  sheared(const Point<dim> &p)
  {
    return {2. * p[0] + 0.3 * p[1], p[1] - 0.4 * p[2], 0.7 * p[2] + 0.2 * p[0]};
  }

  /// (Those below z = 1/2 remain boxes, which fill batches of their own.)
  Point<dim>
  bent(const Point<dim> &p)
  {
    const double z = std::max(p[2] - 0.5, 0.);
    return {p[0] + 0.4 * z * p[1], p[1] + 0.3 * z * p[0], p[2] - 0.4 * z};
  }



  /// A body of 128 cells with some positive definite tangents.
  class Level
  {
  public:
    Level(const unsigned int   degree,
          const StrainModel   &strain_model,
          const Transformation transformation)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , kernel(make_level_kernel<dim>(degree, strain_model))
      , tangents(strain_model.has_nominal_tangents())
      , without_reference(strain_model.has_nominal_tangents())
    {
      GridGenerator::subdivided_hyper_rectangle(mesh,
                                                {4, 4, 8},
                                                Point<dim>(),
                                                Point<dim>(1., 1., 1.));
      GridTools::transform(transformation, mesh);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      constraints.close();
      kernel->reinit(dof_handler, constraints);
      for (CellTangents<dim> *const all : {&tangents, &without_reference})
        set(*all, strain_model.has_nominal_tangents());
      kernel->prepare_products(tangents);
    }

    LevelVector
    waves(const float length) const
    {
      LevelVector u;
      kernel->initialize_vector(u);
      for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
        u.local_element(i) = std::sin(length * i);
      return u;
    }

    LevelVector
    forces(const LevelVector &u, const bool by_quadrature) const
    {
      LevelVector result;
      kernel->initialize_vector(result);
      kernel->vmult(result, u, by_quadrature ? without_reference : tangents);
      return result;
    }

  private:
    /// Bulk modulus and stiffness, or shear modulus, dominate; noise makes them
    /// others in each cell.
    void
    set(CellTangents<dim> &all, const bool are_nominal) const
    {
      all.reinit(kernel->n_batches());
      for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
        for (unsigned int i = 0; i < all.n_values(are_nominal); ++i)
          for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
            all.value(batch, i)[lane] =
              (are_nominal ? nominal_value(i) : small_value(i)) +
              0.05 * std::sin(1. + 5 * batch + 3 * i + lane);
    }

    static double
    small_value(const unsigned int i)
    {
      return i < 2 ? 2. : 0.2 * std::sin(i < 8 ? i : i - 6);
    }

    static double
    nominal_value(const unsigned int i)
    {
      NominalTangent<dim, double> unit;
      unit.stiffness =
        NominalStiffness<dim, double>(Tensor<2, n_gradient_entries<dim>>(
          unit_symmetric_tensor<n_gradient_entries<dim>>()));
      for (unsigned int d = 0; d < dim; ++d)
        unit.volumetric_slope[(dim + 1) * d] = 1.;
      return i == 0 ? 2. : unit.value(i - 1);
    }

    parallel::distributed::Triangulation<dim>                 mesh;
    const FESystem<dim>                                       fe;
    DoFHandler<dim>                                           dof_handler;
    AffineConstraints<double>                                 constraints;
    const std::unique_ptr<CellKernel<dim, CellTangents<dim>>> kernel;
    CellTangents<dim> tangents, without_reference;
  };



  void
  check(const unsigned int degree, const StrainModel &strain_model)
  {
    const std::string name =
      "degree " + std::to_string(degree) + ", " +
      (strain_model.is_finite() ? "finite" : "small") + " strains, " +
      (strain_model.treatment == VolumetricTreatment::b_bar ? "B-bar" :
                                                              "standard");
    {
      const Level       level(degree, strain_model, sheared);
      const LevelVector u       = level.waves(3.);
      LevelVector       forces  = level.forces(u, false);
      const double      largest = forces.linfty_norm();
      forces -= level.forces(u, true);
      verify(name + ", parallelepipeds", forces.linfty_norm() / largest, 1e-5);
    }
    const Level       level(degree, strain_model, bent);
    const LevelVector u = level.waves(3.), v = level.waves(0.5);
    const LevelVector forces = level.forces(u, false);
    const double      energy = u * forces;
    verify(name + ", energy", energy > 0.);
    verify(name + ", symmetry",
           std::abs(v * forces - u * level.forces(v, false)) / energy,
           1e-5);
    LevelVector translation = u;
    translation             = 1.f;
    verify(name + ", translation",
           level.forces(translation, false).linfty_norm() /
             forces.linfty_norm(),
           1e-5);
    LevelVector difference = forces;
    difference -= level.forces(u, true);
    const double relative = difference.l2_norm() / forces.l2_norm();
    verify(name + ", forces of other cells", relative > 1e-3 && relative < 0.1);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const Strain strain : {Strain::small, Strain::logarithmic})
      for (const auto treatment :
           {VolumetricTreatment::standard, VolumetricTreatment::b_bar})
        check(degree, StrainModel(treatment, Kinematics::cartesian, strain));
}
