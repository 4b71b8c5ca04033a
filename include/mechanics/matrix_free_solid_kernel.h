// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_solid_kernel_h
#define mechanics_matrix_free_solid_kernel_h

#include <algorithm>
#include <cmath>

#include "base/ghost_values.h"
#include "mechanics/matrix_free_mixed_kernel.h"

namespace ElastoPlastic
{
  /// The SolidKernel on deal.II's MatrixFree.
  template <int degree, typename StrainMeasure>
  class MatrixFreeSolidKernel
    : public MatrixFreeMixedKernel<degree, typename StrainMeasure::OfIncrements>
  {
  public:
    using Base =
      MatrixFreeMixedKernel<degree, typename StrainMeasure::OfIncrements>;
    using Base::dim;
    using typename Base::Law;
    using typename Base::Number;
    using typename Base::Strains;
    using typename Base::Stresses;
    using typename Base::Vector;

    using Base::Base;

    void
    for_each_batch(const std::vector<const Vector *> &fields,
                   const std::function<void(const std::vector<Strains> &)>
                     &receive) const override;

    void
    integrate(Vector &forces, const Vector &u, const Law &law) const override;

    double
    work(const Vector &u, const Vector &w, const Law &law) const override;

    void
    linearize(PointTangents<dim> &tangents,
              const Vector       &u,
              const Law          &law) const override;

    void
    for_each_true_stress(
      const Vector                                                 &u,
      const Law                                                    &law,
      const std::function<void(const Strains &, const Stresses &)> &receive)
      const override;

  private:
    using Base::matrix_free;
    using Base::n_points;
    using typename Base::AtPoints;
    using typename Base::Evaluation;
    using typename Base::OfBatch;
    using Deformations =
      std::array<typename StrainMeasure::template Deformation<Number>,
                 n_points>;

    /// Whether the dof values of @p phi are zero.
    static bool
    is_zero(const Evaluation &phi);

    /// Those of the dof values of @p phi, and the strains that belong to them.
    Deformations
    deformations(Strains &strains, Evaluation &phi) const;

    /// The same, with the stresses of @p law.
    Deformations
    evaluate(Evaluation &phi,
             Strains    &strains,
             Stresses   &stresses,
             const Law  &law) const;

    /// Calls @p receive for all cell batches with the deformations of @p u, the
    /// strains and the stresses of @p law.
    template <typename Receive>
    void
    for_each_deformation(const Vector  &u,
                         const Law     &law,
                         const Receive &receive) const;
  };



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeSolidKernel<degree, StrainMeasure>::for_each_batch(
    const std::vector<const Vector *>                       &fields,
    const std::function<void(const std::vector<Strains> &)> &receive) const
  {
    Evaluation           phi(matrix_free);
    std::vector<Strains> strains(fields.size());
    for (const Vector *field : fields)
      field->update_ghost_values();
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        for (unsigned int f = 0; f < fields.size(); ++f)
          {
            this->read(phi, batch, *fields[f]);
            deformations(strains[f], phi);
          }
        receive(strains);
      }
    for (const Vector *field : fields)
      field->zero_out_ghost_values();
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeSolidKernel<degree, StrainMeasure>::integrate(Vector       &forces,
                                                          const Vector &u,
                                                          const Law &law) const
  {
    Strains  strains;
    Stresses stresses;
    this->integrate_cells(forces, u, [&](Evaluation &phi) {
      const auto deformation = evaluate(phi, strains, stresses, law);
      for (unsigned int q = 0; q < n_points; ++q)
        StrainMeasure::submit(
          phi, StrainMeasure::conjugate(deformation[q], stresses[q]), q);
      phi.integrate(StrainMeasure::flags());
    });
  }



  template <int degree, typename StrainMeasure>
  bool
  MatrixFreeSolidKernel<degree, StrainMeasure>::is_zero(const Evaluation &phi)
  {
    Number largest = 0.;
    for (unsigned int i = 0; i < Base::n_dofs; ++i)
      largest = std::max(largest, std::abs(phi.begin_dof_values()[i]));
    return std::all_of(largest.begin(), largest.end(), [](const double value) {
      return value == 0.;
    });
  }



  // (A motion of the supports moves few cells.)
  template <int degree, typename StrainMeasure>
  double
  MatrixFreeSolidKernel<degree, StrainMeasure>::work(const Vector &u,
                                                     const Vector &w,
                                                     const Law    &law) const
  {
    double     sum = 0;
    Evaluation phi(matrix_free), direction(matrix_free);
    Strains    strains;
    Stresses   stresses;
    u.update_ghost_values();
    w.update_ghost_values();
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        this->read(direction, batch, w);
        if (is_zero(direction))
          continue;
        direction.evaluate(StrainMeasure::flags());
        this->read(phi, batch, u);
        const auto deformation = evaluate(phi, strains, stresses, law);
        Number     of_batch    = 0.;
        for (unsigned int q = 0; q < n_points; ++q)
          of_batch += (StrainMeasure::conjugate(deformation[q], stresses[q]) *
                       StrainMeasure::increment_at(direction, q)) *
                      strains.volume[q];
        for (unsigned int lane = 0; lane < this->n_cells(batch); ++lane)
          sum += of_batch[lane];
      }
    u.zero_out_ghost_values();
    w.zero_out_ghost_values();
    return sum;
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeSolidKernel<degree, StrainMeasure>::linearize(
    PointTangents<dim> &tangents, const Vector &u, const Law &law) const
  {
    for_each_deformation(
      u, law, [&](const auto &deformation, auto &strains, auto &stresses) {
        if constexpr (StrainMeasure::has_nominal_tangents)
          {
            const Number bulk = OfBatch(tangents, strains.batch).bulk_modulus;
            for (unsigned int q = 0; q < n_points; ++q)
              {
                Tensor<2, n_gradient_entries<dim>, Number> derivative;
                GradientEntries<dim, Number>               volumetric_slope;
                StrainMeasure::linearize(derivative,
                                         volumetric_slope,
                                         deformation[q],
                                         stresses[q],
                                         tangents.law(strains.batch, q),
                                         bulk);
                tangents.set_nominal(strains.batch,
                                     q,
                                     derivative,
                                     volumetric_slope);
              }
          }
      });
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeSolidKernel<degree, StrainMeasure>::for_each_true_stress(
    const Vector                                                 &u,
    const Law                                                    &law,
    const std::function<void(const Strains &, const Stresses &)> &receive) const
  {
    for_each_deformation(
      u, law, [&](const auto &deformation, auto &strains, auto &stresses) {
        for (unsigned int q = 0; q < n_points; ++q)
          stresses[q] = StrainMeasure::true_stress(deformation[q], stresses[q]);
        receive(strains, stresses);
      });
  }



  template <int degree, typename StrainMeasure>
  auto
  MatrixFreeSolidKernel<degree, StrainMeasure>::evaluate(Evaluation &phi,
                                                         Strains    &strains,
                                                         Stresses   &stresses,
                                                         const Law  &law) const
    -> Deformations
  {
    const auto result = deformations(strains, phi);
    law(strains, stresses);
    return result;
  }



  template <int degree, typename StrainMeasure>
  template <typename Receive>
  void
  MatrixFreeSolidKernel<degree, StrainMeasure>::for_each_deformation(
    const Vector &u, const Law &law, const Receive &receive) const
  {
    Evaluation        phi(matrix_free);
    Strains           strains;
    Stresses          stresses;
    const GhostValues ghosts(u);
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        this->read(phi, batch, u);
        const auto deformation = evaluate(phi, strains, stresses, law);
        receive(deformation, strains, stresses);
      }
  }



  // (Called from everywhere, and large.)
  template <int degree, typename StrainMeasure>
  [[gnu::noinline]] auto
  MatrixFreeSolidKernel<degree, StrainMeasure>::deformations(
    Strains &strains, Evaluation &phi) const -> Deformations
  {
    phi.evaluate(StrainMeasure::flags());
    strains.batch    = phi.get_current_cell_index();
    strains.n_points = n_points;
    Deformations result;
    AtPoints     volumetric;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        result[q]         = StrainMeasure::deformation_at(phi, q);
        strains.strain[q] = result[q].strain;
        strains.volume[q] = StrainMeasure::volume_at(phi, q);
        volumetric[q]     = result[q].volumetric();
      }
    this->average(volumetric, phi);
    std::copy(volumetric.begin(), volumetric.end(), strains.volumetric.begin());
    return result;
  }
} // namespace ElastoPlastic

#endif
