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
#include "base/tensors.h"
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
                     const Kinematics                       kinematics,
                     const std::vector<unsigned int>       &categories = {})
  {
    typename MatrixFree<dim, Number, Simd<Number>>::AdditionalData settings;
    settings.mapping_update_flags = update_gradients | update_JxW_values;
    if (kinematics == Kinematics::axisymmetric)
      settings.mapping_update_flags |= update_quadrature_points;
    settings.tasks_parallel_scheme       = settings.none;
    settings.cell_vectorization_category = categories;
    matrix_free.reinit(MappingQ1<dim>(),
                       dof_handler,
                       constraints,
                       QGauss<1>(degree + 1),
                       settings);
  }



  /// What has to be evaluated for strain_at().
  inline EvaluationFlags::EvaluationFlags
  strain_flags(const Kinematics kinematics)
  {
    return kinematics == Kinematics::axisymmetric ?
             EvaluationFlags::values | EvaluationFlags::gradients :
             EvaluationFlags::gradients;
  }



  /// The strain at a quadrature point. Out of plane it is u_r / r for a body of
  /// revolution, and else zero: in plane stress, the material says what it is.
  template <int dim, int degree, typename Number>
  DEAL_II_ALWAYS_INLINE inline SymmetricTensor<2, 3, Simd<Number>>
  strain_at(const DisplacementEvaluation<dim, degree, Number> &phi,
            const unsigned int                                 point,
            [[maybe_unused]] const Kinematics                  kinematics)
  {
    Simd<Number> hoop = Number(0.);
    if constexpr (dim == 2)
      if (kinematics == Kinematics::axisymmetric)
        hoop = phi.get_value(point)[0] / phi.quadrature_point(point)[0];
    return in_space<dim>(phi.get_symmetric_gradient(point), hoop);
  }



  /// The volume that a quadrature point stands for.
  template <int dim, int degree, typename Number>
  DEAL_II_ALWAYS_INLINE inline Simd<Number>
  volume_of(const DisplacementEvaluation<dim, degree, Number> &phi,
            const unsigned int                                 point,
            [[maybe_unused]] const Kinematics                  kinematics)
  {
    if constexpr (dim == 2)
      if (kinematics == Kinematics::axisymmetric)
        return phi.JxW(point) * extent(phi.quadrature_point(point), kinematics);
    return phi.JxW(point);
  }



  /// Hands in a stress, to be integrated against the strains of the shape
  /// functions.
  template <int dim, int degree, typename Number>
  DEAL_II_ALWAYS_INLINE inline void
  submit_stress(DisplacementEvaluation<dim, degree, Number> &phi,
                const SymmetricTensor<2, 3, Simd<Number>>   &stress,
                const unsigned int                           point,
                [[maybe_unused]] const Kinematics            kinematics)
  {
    if constexpr (dim == 2)
      if (kinematics == Kinematics::axisymmetric)
        {
          const auto                   x    = phi.quadrature_point(point);
          const Simd<Number>           ring = extent(x, kinematics);
          Tensor<1, dim, Simd<Number>> radial;
          radial[0] = stress[2][2] * ring / x[0];
          phi.submit_value(radial, point);
          phi.submit_symmetric_gradient(ring * in_plane<dim>(stress), point);
          return;
        }
    phi.submit_symmetric_gradient(in_plane<dim>(stress), point);
  }



  /// The volumetric strain at all points of the current cells of @p phi: point
  /// values or, for B-bar, the cell mean. What strain_flags() says must have
  /// been evaluated.
  template <int dim, int degree, typename Number>
  std::array<Simd<Number>, Utilities::pow(degree + 1, dim)>
  volumetric_strain(const DisplacementEvaluation<dim, degree, Number> &phi,
                    const StrainModel &strain_model)
  {
    const Kinematics kinematics = strain_model.kinematics;
    std::array<Simd<Number>, Utilities::pow(degree + 1, dim)> values;
    for (const unsigned int q : phi.quadrature_point_indices())
      if (kinematics == Kinematics::axisymmetric)
        values[q] = trace(strain_at<dim, degree>(phi, q, kinematics));
      else
        values[q] = phi.get_divergence(q);

    if (strain_model.treatment == VolumetricTreatment::b_bar)
      {
        Simd<Number> integral = Number(0.), volume = Number(0.);
        for (const unsigned int q : phi.quadrature_point_indices())
          {
            const Simd<Number> dx = volume_of<dim, degree>(phi, q, kinematics);
            integral += values[q] * dx;
            volume += dx;
          }
        values.fill(integral / volume);
      }
    return values;
  }



  /// Whether the body is a thin sheet; the compiler knows it of bodies in
  /// space.
  template <int dim>
  constexpr bool
  in_plane_stress(const Kinematics kinematics)
  {
    return dim == 2 && kinematics == Kinematics::plane_stress;
  }



  /// The mean stress: what belongs to the volumetric strain, or in plane
  /// stress, where that is not known, what together with the @p
  /// deviatoric_stress leaves no stress out of plane.
  template <int dim, typename Number>
  DEAL_II_ALWAYS_INLINE inline Number
  mean_stress(const Number                        &volumetric_stress,
              const SymmetricTensor<2, 3, Number> &deviatoric_stress,
              const Kinematics                     kinematics)
  {
    return in_plane_stress<dim>(kinematics) ? -deviatoric_stress[2][2] :
                                              volumetric_stress;
  }



  /// The cell kernel: turns the dof values of @p phi into nodal forces.
  /// @p deviatoric_stress(point, strain) is the point law; in plane stress, it
  /// ignores the out-of-plane component of @p strain. The weak form is,
  /// with the volumetric strain tr of volumetric_strain(),
  ///   int s(strain(u)) : strain(v) + K tr(u) tr(v) dx.
  /// For B-bar, the mean of tr(v) may be replaced by the trace of strain(v)
  /// itself, because the pressure K tr(u) is then constant on the cell.
  template <int dim, int degree, typename Number, typename PointLaw>
  void
  integrate_stress(DisplacementEvaluation<dim, degree, Number> &phi,
                   const Simd<Number>                          &bulk_modulus,
                   const StrainModel                           &strain_model,
                   const PointLaw &deviatoric_stress)
  {
    const Kinematics kinematics = strain_model.kinematics;
    const auto       flags      = strain_flags(kinematics);
    phi.evaluate(flags);
    const auto volumetric = volumetric_strain<dim, degree>(phi, strain_model);
    for (const unsigned int q : phi.quadrature_point_indices())
      {
        auto stress =
          deviatoric_stress(q, strain_at<dim, degree>(phi, q, kinematics));
        const Simd<Number> pressure =
          mean_stress<dim>(bulk_modulus * volumetric[q], stress, kinematics);
        for (unsigned int d = 0; d < 3; ++d)
          stress[d][d] += pressure;
        submit_stress<dim, degree>(phi, stress, q, kinematics);
      }
    phi.integrate(flags);
  }



  /// The same for a linear law. In plane stress, the out-of-plane component of
  /// the strain is replaced by the one for which @p deviatoric_stress and
  /// @p bulk_modulus times the trace leave no stress out of plane.
  template <int dim, int degree, typename Number, typename PointLaw>
  void
  integrate_linear_stress(DisplacementEvaluation<dim, degree, Number> &phi,
                          const Simd<Number> &bulk_modulus,
                          const StrainModel  &strain_model,
                          const PointLaw     &deviatoric_stress)
  {
    using Strain = SymmetricTensor<2, 3, Simd<Number>>;
    if (!in_plane_stress<dim>(strain_model.kinematics))
      return integrate_stress<dim, degree>(phi,
                                           bulk_modulus,
                                           strain_model,
                                           deviatoric_stress);

    Strain across;
    across[2][2] = Simd<Number>(1.);
    integrate_stress<dim, degree>(
      phi,
      bulk_modulus,
      strain_model,
      [&](const unsigned int q, const Strain &strain) {
        const Strain stress    = deviatoric_stress(q, strain);
        const Strain of_across = deviatoric_stress(q, across);
        return stress - ((bulk_modulus * trace(strain) + stress[2][2]) /
                         (bulk_modulus + of_across[2][2])) *
                          of_across;
      });
  }
} // namespace ElastoPlastic

#endif
