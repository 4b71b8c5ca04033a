// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_stress_integration_h
#define mechanics_stress_integration_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <array>

#include "base/simd.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The evaluation of displacements on a batch of cells.
  template <int dim, int degree, typename Number>
  using DisplacementEvaluation =
    FEEvaluation<dim, degree, degree + 1, dim, Number, Simd<Number>>;



  /// Prepares @p matrix_free for DisplacementEvaluation; cells of the same one
  /// of @p categories, if given, form batches of their own.
  template <int degree, int dim, typename Number>
  void
  reinit_matrix_free(MatrixFree<dim, Number, Simd<Number>> &matrix_free,
                     const DoFHandler<dim>                 &dof_handler,
                     const AffineConstraints<double>       &constraints,
                     const std::vector<unsigned int>       &categories = {})
  {
    typename MatrixFree<dim, Number, Simd<Number>>::AdditionalData settings;
    settings.mapping_update_flags        = update_gradients | update_JxW_values;
    settings.tasks_parallel_scheme       = settings.none;
    settings.cell_vectorization_category = categories;
    matrix_free.reinit(MappingQ1<dim>(),
                       dof_handler,
                       constraints,
                       QGauss<1>(degree + 1),
                       settings);
  }



  /// The volumetric strain at all points of the current cells of @p phi: point
  /// values or, for B-bar, the cell mean. Gradients must have been evaluated.
  template <int dim, int degree, typename Number>
  std::array<Simd<Number>, Utilities::pow(degree + 1, dim)>
  volumetric_strain(const DisplacementEvaluation<dim, degree, Number> &phi,
                    const VolumetricTreatment treatment)
  {
    std::array<Simd<Number>, Utilities::pow(degree + 1, dim)> values;
    for (const unsigned int q : phi.quadrature_point_indices())
      values[q] = phi.get_divergence(q);

    if (treatment == VolumetricTreatment::b_bar)
      {
        Simd<Number> integral = Number(0.), volume = Number(0.);
        for (const unsigned int q : phi.quadrature_point_indices())
          {
            integral += values[q] * phi.JxW(q);
            volume += phi.JxW(q);
          }
        values.fill(integral / volume);
      }
    return values;
  }



  /// The cell kernel: turns the dof values of @p phi into nodal forces.
  /// @p deviatoric_stress(point, strain) is the point law. The weak form is,
  /// with the volumetric strain tr of volumetric_strain(),
  ///   int s(strain(u)) : strain(v) + K tr(u) tr(v) dx.
  /// For B-bar, the mean of tr(v) may be replaced by div v itself, because the
  /// pressure K tr(u) is then constant on the cell.
  template <int dim, int degree, typename Number, typename PointLaw>
  void
  integrate_stress(DisplacementEvaluation<dim, degree, Number> &phi,
                   const Simd<Number>                          &bulk_modulus,
                   const VolumetricTreatment                    treatment,
                   const PointLaw &deviatoric_stress)
  {
    phi.evaluate(EvaluationFlags::gradients);
    const auto volumetric = volumetric_strain<dim, degree>(phi, treatment);
    for (const unsigned int q : phi.quadrature_point_indices())
      {
        auto stress = deviatoric_stress(q, phi.get_symmetric_gradient(q));
        const Simd<Number> pressure = bulk_modulus * volumetric[q];
        for (unsigned int d = 0; d < dim; ++d)
          stress[d][d] += pressure;
        phi.submit_symmetric_gradient(stress, q);
      }
    phi.integrate(EvaluationFlags::gradients);
  }
} // namespace ElastoPlastic

#endif
