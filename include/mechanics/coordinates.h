// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_coordinates_h
#define mechanics_coordinates_h

#include <deal.II/matrix_free/fe_evaluation.h>

#include "base/kinematics.h"
#include "base/simd.h"
#include "base/tensors.h"
#include "mechanics/displacement_gradient.h"

namespace ElastoPlastic
{
  /// The numbers that an FEEvaluation treats at a time.
  template <typename Evaluation>
  using NumberOf = decltype(std::declval<Evaluation>().JxW(0));



  /// What the coordinates of the mesh mean for the derivatives of fields: those
  /// of a body in space or in plane strain. At a quadrature point of a batch of
  /// cells, where what flags() says has been evaluated. Those below have the
  /// same members; StrainMeasures stand on them.
  ///
  /// A field whose only component is @p component has the slopes g: its
  /// derivatives, and in an axisymmetric body its quotient by r.
  template <int dimension>
  struct CartesianCoordinates
  {
    static constexpr int          dim      = dimension;
    static constexpr unsigned int n_slopes = dim;
    /// Those with the same gradients: a sheet has none of its own.
    using OfGradients = CartesianCoordinates;
    /// Whether the body is a sheet, without stress out of plane. The material
    /// then says what the strain out of plane is, and that of strain_at() is
    /// zero.
    static constexpr bool is_sheet = false;

    static EvaluationFlags::EvaluationFlags
    flags()
    {
      return EvaluationFlags::gradients;
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    strain_at(const Evaluation &phi, const unsigned int point)
    {
      using Number = NumberOf<Evaluation>;
      return in_space<dim>(phi.get_symmetric_gradient(point), Number(0.));
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    gradient_at(const Evaluation &phi, const unsigned int point)
    {
      GradientEntries<dim, NumberOf<Evaluation>> entries;
      const auto gradient = phi.get_gradient(point);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          entries[dim * c + d] = gradient[c][d];
      return entries;
    }

    /// What the point stands for: a volume, in plane strain an area.
    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    volume_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.JxW(point);
    }

    /// Hands in a stress, to be integrated against the strains of the shape
    /// functions.
    template <typename Evaluation, typename Stress>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit_stress(Evaluation        &phi,
                  const Stress      &stress,
                  const unsigned int point)
    {
      phi.submit_symmetric_gradient(in_plane<dim>(stress), point);
    }

    /// Hands in a nominal stress, to be integrated against the gradients of the
    /// shape functions.
    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit_nominal_stress(Evaluation                         &phi,
                          const GradientEntries<dim, Number> &stress,
                          const unsigned int                  point)
    {
      phi.submit_gradient(in_mesh(stress, Number(1.)), point);
    }

    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static Tensor<1, n_slopes, Number>
    slopes_at(const Evaluation &,
              const unsigned int,
              const Number &,
              const Tensor<1, dim, Number> &gradient)
    {
      return gradient;
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    strain_of_slopes(const Tensor<1, n_slopes, Number> &slopes,
                     const unsigned int                 component)
    {
      SymmetricTensor<2, 3, Number> strain;
      for (unsigned int d = 0; d < dim; ++d)
        strain[d][component] = 0.5 * slopes[d];
      strain[component][component] = slopes[component];
      return strain;
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static GradientEntries<dim, Number>
    gradient_of_slopes(const Tensor<1, n_slopes, Number> &slopes,
                       const unsigned int                 component)
    {
      GradientEntries<dim, Number> gradient;
      for (unsigned int d = 0; d < dim; ++d)
        gradient[dim * component + d] = slopes[d];
      return gradient;
    }

  protected:
    /// The entries in the space of the mesh, times a @p factor.
    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static Tensor<1, dim, Tensor<1, dim, Number>>
    in_mesh(const GradientEntries<dim, Number> &entries, const Number &factor)
    {
      Tensor<1, dim, Tensor<1, dim, Number>> result;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          result[c][d] = factor * entries[dim * c + d];
      return result;
    }
  };



  /// Those of a thin sheet.
  struct SheetCoordinates : CartesianCoordinates<2>
  {
    static constexpr bool is_sheet = true;
  };



  /// Those of an axisymmetric body, whose strain out of plane is u_r / r.
  struct AxisymmetricCoordinates : CartesianCoordinates<2>
  {
    static constexpr unsigned int n_slopes = 3;
    using OfGradients                      = AxisymmetricCoordinates;

    static EvaluationFlags::EvaluationFlags
    flags()
    {
      return EvaluationFlags::values | EvaluationFlags::gradients;
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    strain_at(const Evaluation &phi, const unsigned int point)
    {
      return in_space<2>(phi.get_symmetric_gradient(point),
                         hoop_strain(phi, point));
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    gradient_at(const Evaluation &phi, const unsigned int point)
    {
      auto entries = CartesianCoordinates<2>::gradient_at(phi, point);
      entries[4]   = hoop_strain(phi, point);
      return entries;
    }

    /// The volume of a ring.
    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    volume_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.JxW(point) * ring(phi, point);
    }

    template <typename Evaluation, typename Stress>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit_stress(Evaluation        &phi,
                  const Stress      &stress,
                  const unsigned int point)
    {
      submit_hoop_stress(phi, stress[2][2], point);
      phi.submit_symmetric_gradient(ring(phi, point) * in_plane<2>(stress),
                                    point);
    }

    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit_nominal_stress(Evaluation                       &phi,
                          const GradientEntries<2, Number> &stress,
                          const unsigned int                point)
    {
      submit_hoop_stress(phi, stress[4], point);
      phi.submit_gradient(in_mesh(stress, ring(phi, point)), point);
    }

    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static Tensor<1, n_slopes, Number>
    slopes_at(const Evaluation           &phi,
              const unsigned int          point,
              const Number               &value,
              const Tensor<1, 2, Number> &gradient)
    {
      Tensor<1, n_slopes, Number> slopes;
      slopes[0] = gradient[0];
      slopes[1] = gradient[1];
      slopes[2] = value / phi.quadrature_point(point)[0];
      return slopes;
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    strain_of_slopes(const Tensor<1, n_slopes, Number> &slopes,
                     const unsigned int                 component)
    {
      SymmetricTensor<2, 3, Number> strain;
      strain[0][1]                 = 0.5 * slopes[1 - component];
      strain[component][component] = slopes[component];
      if (component == 0)
        strain[2][2] = slopes[2];
      return strain;
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static GradientEntries<2, Number>
    gradient_of_slopes(const Tensor<1, n_slopes, Number> &slopes,
                       const unsigned int                 component)
    {
      GradientEntries<2, Number> gradient;
      gradient[2 * component]     = slopes[0];
      gradient[2 * component + 1] = slopes[1];
      if (component == 0)
        gradient[4] = slopes[2];
      return gradient;
    }

  private:
    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    hoop_strain(const Evaluation &phi, const unsigned int point)
    {
      return phi.get_value(point)[0] / phi.quadrature_point(point)[0];
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    ring(const Evaluation &phi, const unsigned int point)
    {
      return out_of_plane_length(phi.quadrature_point(point),
                                 Kinematics::axisymmetric);
    }

    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit_hoop_stress(Evaluation        &phi,
                       const Number      &stress,
                       const unsigned int point)
    {
      Tensor<1, 2, Number> radial;
      radial[0] = 2. * numbers::PI * stress; // ring / radius
      phi.submit_value(radial, point);
    }
  };
} // namespace ElastoPlastic

#endif
