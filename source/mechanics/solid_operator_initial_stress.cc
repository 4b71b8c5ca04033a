// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The stress that the body bears before it is deformed.

#include <cmath>
#include <sstream>
#include <variant>

#include "base/exceptions.h"
#include "base/tensors.h"
#include "base/text.h"
#include "mechanics/quadrature_points.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  namespace
  {
    template <typename Number>
    SymmetricTensor<2, 3, Number>
    elastic_strain(const Material<Number>              &material,
                   const SymmetricTensor<2, 3, Number> &stress)
    {
      SymmetricTensor<2, 3, Number> strain =
        strain_deviator(stress) / (2. * material.shear_modulus);
      for (unsigned int d = 0; d < 3; ++d)
        strain[d][d] += trace(stress) / (9. * material.bulk_modulus);
      return strain;
    }



    template <typename Number>
    SymmetricTensor<2, 3, Number>
    elastic_stress(const Material<Number>              &material,
                   const SymmetricTensor<2, 3, Number> &strain)
    {
      SymmetricTensor<2, 3, Number> stress =
        2. * material.shear_modulus * strain_deviator(strain);
      for (unsigned int d = 0; d < 3; ++d)
        stress[d][d] += material.bulk_modulus * trace(strain);
      return stress;
    }



    /// What the yield criterion compares with the yield stress.
    double
    equivalent_stress(const Material<double>      &material,
                      const SymmetricTensor<2, 3> &stress)
    {
      if (!has_general_criterion(material))
        return std::sqrt(1.5) * deviator(stress).norm();
      return std::visit(
        [&](const auto &criterion) {
          return criterion.equivalent_stress(deviator(stress));
        },
        *material.criteria[0]);
    }



    /// @throws InputError if the stress of @p initial_strains exceeds the yield
    /// stress: it says where it does most, and calls the stress @p completed.
    template <int dim>
    void
    check_stress(const InitialStrains                      &initial_strains,
                 const BatchMaterials                      &materials,
                 const CellKernel<dim, PointTangents<dim>> &kernel,
                 const unsigned int                         n_points,
                 const std::string                         &completed)
    {
      constexpr double rounding      = 1e-9;
      double           largest_ratio = 1., equivalent = 0., yield_stress = 0.;
      Point<dim>       place;
      for_each_quadrature_point<dim>(
        kernel,
        n_points,
        [&](const unsigned int batch,
            const unsigned int lane,
            const unsigned int q,
            const Point<dim>  &point) {
          const Material<double> material =
            lane_of(materials.at(batch, q), lane);
          const double value = equivalent_stress(
            material,
            elastic_stress(material,
                           lane_of(initial_strains.at(batch, q), lane)));
          const double limit = std::sqrt(1.5) * material.yield_radius;
          if (!is_rate_dependent(material) &&
              value > (1. + rounding) * largest_ratio * limit)
            {
              largest_ratio = value / limit;
              place         = point;
              equivalent    = value;
              yield_stress  = limit;
            }
        });
      if (largest_ratio == 1.)
        return;
      std::ostringstream where;
      where << place;
      throw InputError(
        "The 'Initial stress'" + completed +
        " is beyond the yield stress: at (" + where.str() +
        ") the equivalent stress is " + to_text(equivalent) +
        ", and 'Material/Yield stress' is " + to_text(yield_stress) +
        ". No body could bear it. Make it smaller, or raise the yield "
        "stress to that of the hardened material.");
    }
  } // namespace



  template <int dim>
  void
  SolidOperator<dim>::set_initial_stress(const InitialStress<dim> &stress)
  {
    VectorType layout;
    initialize_vector(layout);
    initial_strains.reinit(kernel->n_batches(), n_points);
    const auto set = [&]() {
      for_each_quadrature_point<dim>(
        *kernel,
        n_points,
        [&](const unsigned int batch,
            const unsigned int lane,
            const unsigned int q,
            const Point<dim>  &point) {
          const auto strain =
            elastic_strain(lane_of(materials.at(batch, q), lane),
                           stress.value(point));
          for (unsigned int i = 0; i < 6; ++i)
            initial_strains.at(batch, q).access_raw_entry(i)[lane] =
              strain.access_raw_entry(i);
        });
      check_stress<dim>(initial_strains, materials, *kernel, n_points, "");
    };
    rethrow_collectively(layout.get_mpi_communicator(), set);
  }



  // (In a sheet, without stress across.)
  template <int dim>
  void
  SolidOperator<dim>::add_to_initial_stress(const VectorType &displacement)
  {
    const auto add = [&](const std::vector<Strains> &of_displacement) {
      const Strains          &strains  = of_displacement[0];
      const Material<Number> &material = materials[strains.batch];
      for (unsigned int q = 0; q < n_points; ++q)
        {
          Strain strain     = strains.strain[q];
          Number volumetric = strains.volumetric[q];
          if (is_sheet)
            {
              const Number bulk  = material.bulk_modulus,
                           shear = material.shear_modulus;
              strain[2][2]       = -(3. * bulk - 2. * shear) /
                             (3. * bulk + 4. * shear) *
                             (strain[0][0] + strain[1][1]);
              volumetric = trace(strain);
            }
          Strain &sum = initial_strains.at(strains.batch, q);
          sum += strain_deviator(strain);
          for (unsigned int d = 0; d < 3; ++d)
            sum[d][d] += volumetric * (1. / 3.);
        }
    };
    kernel->for_each_batch({&displacement}, add);

    const auto check = [&]() {
      check_stress<dim>(
        initial_strains,
        materials,
        *kernel,
        n_points,
        ", completed by what supports and loads at t = 0 ask for,");
    };
    rethrow_collectively(displacement.get_mpi_communicator(), check);
  }



  template <int dim>
  InitialStressSize
  SolidOperator<dim>::initial_stress_size() const
  {
    VectorType rest;
    initialize_vector(rest);
    InitialStressSize size;
    kernel->for_each_batch({&rest}, [&](const std::vector<Strains> &at_rest) {
      const Strains     &strains = at_rest[0];
      const unsigned int batch   = strains.batch;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Strain &strain = initial_strains.at(batch, q);
          const Strain  stress = elastic_stress(materials[batch], strain);
          const Number  energy = 0.5 * (stress * strain) * strains.volume[q];
          const Number  norm   = stress.norm() * strains.volume[q];
          for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
            {
              size.energy += energy[lane];
              size.norm += norm[lane];
            }
        }
    });
    const MPI_Comm communicator = rest.get_mpi_communicator();
    size.energy = Utilities::MPI::sum(size.energy, communicator);
    size.norm   = Utilities::MPI::sum(size.norm, communicator);
    return size;
  }



  // The pressure of the initial stress is integrated against the volumetric
  // strain itself, other than that of the body, which with B-bar is that of the
  // mean.
  template <int dim>
  Simd<double>
  SolidOperator<dim>::initial_energy_at(const Strains     &strains,
                                        const unsigned int point) const
  {
    const Material<Number> &material = materials[strains.batch];
    const Strain           &strain   = initial_strains.at(strains.batch, point);
    Number energy = 0.5 * (elastic_stress(material, strain) * strain);
    if (!is_sheet)
      energy -= material.bulk_modulus * trace(strain) *
                (trace(strains.strain[point]) - strains.volumetric[point]);
    return energy;
  }
} // namespace ElastoPlastic
