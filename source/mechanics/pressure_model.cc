// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cmath>

#include "mechanics/pressure_model.h"
#include "solver/krylov_methods.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The constant in a row of R, over the root mean square of that of D. On
    /// an endless lattice of bilinear squares or trilinear cubes, F is what it
    /// stands for up to a factor between 0.4 and 2.1, at all wave lengths.
    constexpr double drag = 1. / 3.;

    /// Around a node of such a lattice are 2^dim cells. With the shear modulus
    /// G and the mean square d^2 of the entries of a row of B, times the root
    /// of the volume, each adds about 1.3 2^(dim-1) G d^2 to the diagonal of
    /// A_G.
    constexpr double spring = 1.3;

    /// More iterations would hardly save steps of the mixed form. (Only the
    /// pressures that hardly move a node would profit.)
    constexpr double       reduction      = 0.1;
    constexpr unsigned int max_iterations = 30;



    /// a / b, or zero where b is zero.
    Simd<double>
    quotient(const Simd<double> &a, const Simd<double> &b)
    {
      Simd<double> result = a / b;
      for (unsigned int lane = 0; lane < Simd<double>::size(); ++lane)
        if (b[lane] == 0.)
          result[lane] = 0.;
      return result;
    }
  } // namespace



  template <int dim>
  PressureModel<dim>::PressureModel(const SolidKernel<dim>    &kernel,
                                    const PointTangents<dim>  &tangents,
                                    const std::vector<Moduli> &moduli,
                                    const VectorType          &held)
    : kernel(kernel)
  {
    kernel.initialize_pressures(excess);
    inverse_diagonal.reinit(excess);
    rhs.reinit(excess);
    set_diagonals(moduli);
    if (kernel.n_pressures() == 1)
      couple(tangents, moduli, held);
  }



  // (Longitudinal waves of A have the modulus K_A + 4/3 G, and so F is about
  // (K - K_A) / (4/3 G).)
  template <int dim>
  void
  PressureModel<dim>::set_diagonals(const std::vector<Moduli> &moduli)
  {
    double *e       = excess.begin(),
           *inverse = inverse_diagonal.get_vector().begin();
    for (const auto &[bulk, moderate_bulk, shear] : moduli)
      for (unsigned int k = 0; k < kernel.n_pressures();
           ++k, e += Number::size(), inverse += Number::size())
        {
          const Number difference = bulk - moderate_bulk;
          const Number share      = difference / bulk;
          share.store(e);
          quotient(Number(1.), share + difference / ((4. / 3.) * shear))
            .store(inverse);
        }
  }



  // (Where A has all of the bulk modulus, A_G does, too.)
  template <int dim>
  void
  PressureModel<dim>::couple(const PointTangents<dim>  &tangents,
                             const std::vector<Moduli> &moduli,
                             const VectorType          &held)
  {
    const unsigned int n_dofs   = kernel.n_cell_dofs();
    const double       of_shear = spring * Utilities::fixed_power<dim - 1>(2);
    VectorType         stiffness(rhs);
    kernel.volumetric_rows(rows, tangents);
    for (unsigned int batch = 0; batch < moduli.size(); ++batch)
      {
        const auto &[bulk, moderate_bulk, shear] = moduli[batch];
        const unsigned int first                 = batch * n_dofs;
        Number             mean_square           = 0.;
        for (unsigned int i = first; i < first + n_dofs; ++i)
          mean_square += rows[i] * rows[i] * (1. / n_dofs);

        const Number root   = std::sqrt(bulk - moderate_bulk);
        const Number moving = drag * std::sqrt(mean_square);
        for (unsigned int i = first; i < first + n_dofs; ++i)
          rows.set(i, root * (rows[i] + moving));

        Number modulus = of_shear * shear;
        for (unsigned int lane = 0; lane < Number::size(); ++lane)
          if (root[lane] == 0.)
            modulus[lane] += bulk[lane];
        (modulus * mean_square)
          .store(stiffness.begin() + batch * Number::size());
      }

    compliances.reinit(held, true);
    displacements.reinit(held, true);
    kernel.diagonal_of_multiples(compliances, stiffness);
    for (unsigned int i = 0; i < held.locally_owned_size(); ++i)
      {
        double    &value   = compliances.local_element(i);
        const bool is_free = held.local_element(i) == 0. && value > 0.;
        value              = is_free ? 1. / value : 0.;
      }
  }



  template <int dim>
  void
  PressureModel<dim>::multiply(VectorType       &result,
                               const VectorType &pressures) const
  {
    kernel.multiply_transposed_rows(displacements, rows, pressures);
    displacements.scale(compliances);
    kernel.multiply_rows(result, rows, displacements);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) +=
        excess.local_element(i) * pressures.local_element(i);
  }



  template <int dim>
  void
  PressureModel<dim>::vmult(VectorType       &result,
                            const VectorType &pressures) const
  {
    // Krylov methods want a name for the product.
    struct Sum
    {
      const PressureModel &model;

      void
      vmult(VectorType &result, const VectorType &pressures) const
      {
        model.multiply(result, pressures);
      }
    };

    rhs = pressures;
    rhs.scale(excess);
    if (kernel.n_pressures() > 1 || rhs.linfty_norm() == 0.)
      inverse_diagonal.vmult(result, rhs);
    else
      conjugate_gradients(
        Sum{*this}, result, rhs, inverse_diagonal, reduction, max_iterations);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      {
        const double e = excess.local_element(i);
        result.local_element(i) =
          (1. - e) * pressures.local_element(i) + e * result.local_element(i);
      }
  }



  template class PressureModel<2>;
  template class PressureModel<3>;
} // namespace ElastoPlastic
