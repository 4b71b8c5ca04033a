// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_strain_measures_h
#define mechanics_strain_measures_h

#include <deal.II/matrix_free/fe_evaluation.h>

#include "base/kinematics.h"
#include "base/tensors.h"

namespace ElastoPlastic
{
  /// The numbers that an FEEvaluation treats at a time.
  template <typename Evaluation>
  using NumberOf = decltype(std::declval<Evaluation>().JxW(0));



  /// The strain of a body in space or in plane strain, as the cell kernel wants
  /// to see it: at a quadrature point of a batch of cells, where what flags()
  /// says has been evaluated. The other strains, below, have the same members.
  ///
  /// The strain of a field whose only component, @p component, has the slopes g
  /// (its derivatives, and in an axisymmetric body its quotient by r) is linear
  /// in them: what of_slopes() says.
  template <int dim>
  struct CartesianStrain
  {
    static constexpr unsigned int n_slopes = dim;
    /// Whether the body is a sheet, without stress out of plane. The material
    /// then says what the strain out of plane is, and that of at() is zero.
    static constexpr bool is_sheet = false;

    static EvaluationFlags::EvaluationFlags
    flags()
    {
      return EvaluationFlags::gradients;
    }

    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    at(const Evaluation &phi, const unsigned int point)
    {
      using Number = NumberOf<Evaluation>;
      return in_space<dim>(phi.get_symmetric_gradient(point), Number(0.));
    }

    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    trace_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.get_divergence(point);
    }

    /// What the point stands for: a volume, in plane strain an area.
    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    volume_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.JxW(point);
    }

    /// Hands in a stress, to be integrated against the strains of the shape
    /// functions.
    template <typename Evaluation, typename Stress>
    DEAL_II_ALWAYS_INLINE static void
    submit(Evaluation &phi, const Stress &stress, const unsigned int point)
    {
      phi.submit_symmetric_gradient(in_plane<dim>(stress), point);
    }

    template <typename Evaluation, typename Number>
    DEAL_II_ALWAYS_INLINE static Tensor<1, n_slopes, Number>
    slopes_at(const Evaluation &,
              const unsigned int,
              const Number &,
              const Tensor<1, dim, Number> &gradient)
    {
      return gradient;
    }

    template <typename Number>
    DEAL_II_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    of_slopes(const Tensor<1, n_slopes, Number> &slopes,
              const unsigned int                 component)
    {
      SymmetricTensor<2, 3, Number> strain;
      for (unsigned int d = 0; d < dim; ++d)
        strain[d][component] = 0.5 * slopes[d];
      strain[component][component] = slopes[component];
      return strain;
    }
  };



  /// The strain of a thin sheet.
  struct SheetStrain : CartesianStrain<2>
  {
    static constexpr bool is_sheet = true;
  };



  /// The strain of an axisymmetric body: out of plane it is u_r / r.
  struct AxisymmetricStrain
  {
    static constexpr unsigned int n_slopes = 3;
    static constexpr bool         is_sheet = false;

    static EvaluationFlags::EvaluationFlags
    flags()
    {
      return EvaluationFlags::values | EvaluationFlags::gradients;
    }

    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    at(const Evaluation &phi, const unsigned int point)
    {
      using Number      = NumberOf<Evaluation>;
      const Number hoop = phi.get_value(point)[0] / radius(phi, point);
      return in_space<2>(phi.get_symmetric_gradient(point), hoop);
    }

    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    trace_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.get_divergence(point) +
             phi.get_value(point)[0] / radius(phi, point);
    }

    /// The volume of a ring.
    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    volume_at(const Evaluation &phi, const unsigned int point)
    {
      return phi.JxW(point) *
             extent(phi.quadrature_point(point), Kinematics::axisymmetric);
    }

    template <typename Evaluation, typename Stress>
    DEAL_II_ALWAYS_INLINE static void
    submit(Evaluation &phi, const Stress &stress, const unsigned int point)
    {
      const auto ring =
        extent(phi.quadrature_point(point), Kinematics::axisymmetric);
      Tensor<1, 2, NumberOf<Evaluation>> radial;
      radial[0] = 2. * numbers::PI * stress[2][2]; // ring / radius
      phi.submit_value(radial, point);
      phi.submit_symmetric_gradient(ring * in_plane<2>(stress), point);
    }

    template <typename Evaluation, typename Number>
    DEAL_II_ALWAYS_INLINE static Tensor<1, n_slopes, Number>
    slopes_at(const Evaluation           &phi,
              const unsigned int          point,
              const Number               &value,
              const Tensor<1, 2, Number> &gradient)
    {
      Tensor<1, n_slopes, Number> slopes;
      slopes[0] = gradient[0];
      slopes[1] = gradient[1];
      slopes[2] = value / radius(phi, point);
      return slopes;
    }

    template <typename Number>
    DEAL_II_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    of_slopes(const Tensor<1, n_slopes, Number> &slopes,
              const unsigned int                 component)
    {
      SymmetricTensor<2, 3, Number> strain;
      strain[0][1]                 = 0.5 * slopes[1 - component];
      strain[component][component] = slopes[component];
      if (component == 0)
        strain[2][2] = slopes[2];
      return strain;
    }

  private:
    template <typename Evaluation>
    DEAL_II_ALWAYS_INLINE static auto
    radius(const Evaluation &phi, const unsigned int point)
    {
      return phi.quadrature_point(point)[0];
    }
  };
} // namespace ElastoPlastic

#endif
