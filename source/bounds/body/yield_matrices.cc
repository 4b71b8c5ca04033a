// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>
#include <vector>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/yield_conditions.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double factor_of_square = 2. / 3.; // of q^2



    /// The deviators whose scalar products with a stress are the rows of
    /// deviator_matrix(), in which shear components count once.
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    basis_of_deviators()
    {
      const FullMatrix<double>           rows = deviator_matrix<dim>();
      std::vector<SymmetricTensor<2, 3>> basis;
      for (unsigned int d = 0; d < rows.m(); ++d)
        {
          auto &b = basis.emplace_back(stress_from<dim>(&rows(d, 0)));
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = i + 1; j < 3; ++j)
              b[i][j] *= 0.5;
        }
      return basis;
    }



    /// M: from the last row upwards, what the rows below leave of (2/3) q^2.
    template <int dim>
    FullMatrix<double>
    stress_factor(const Material<double> &material)
    {
      static const auto  basis = basis_of_deviators<dim>();
      const unsigned int n     = basis.size();
      if (!has_general_criterion(material))
        return FullMatrix<double>(IdentityMatrix(n));

      const auto square = [&](const SymmetricTensor<2, 3> &deviator) {
        const double q = std::get<HillCriterion>(*material.criteria[0])
                           .equivalent_stress(deviator);
        return factor_of_square * q * q;
      };
      FullMatrix<double> form(n, n), factor(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          form(i, j) =
            0.25 * (square(basis[i] + basis[j]) - square(basis[i] - basis[j]));
      for (unsigned int i = n; i-- > 0;)
        {
          for (unsigned int j = 0; j <= i; ++j)
            factor(i, j) = form(i, j) / std::sqrt(form(i, i));
          for (unsigned int j = 0; j < i; ++j)
            for (unsigned int k = 0; k < i; ++k)
              form(j, k) -= factor(i, j) * factor(i, k);
        }
      return factor;
    }



    /// M^-T
    template <int dim>
    FullMatrix<double>
    rate_factor(const Material<double> &material)
    {
      FullMatrix<double> factor = stress_factor<dim>(material);
      factor.gauss_jordan();
      FullMatrix<double> result(factor.n(), factor.m());
      result.copy_transposed(factor);
      return result;
    }



    /// A factor of coordinates as one of components.
    template <int dim, typename Factor>
    FullMatrix<double>
    factor_of_components(const Material<double> &material,
                         const Factor           &factor_of)
    {
      static const FullMatrix<double> deviator = deviator_matrix<dim>();
      if (!has_general_criterion(material))
        return deviator;
      FullMatrix<double> result(deviator.m(), deviator.n());
      factor_of(material).mmult(result, deviator);
      return result;
    }



    /// The rates sym(n x t) of the @p tangents t of a face.
    template <int dim>
    std::vector<SymmetricTensor<2, dim>>
    rates_of_slips(const FaceCorners<dim> &corners)
    {
      const Tensor<1, dim>                 n = normal(corners);
      std::vector<SymmetricTensor<2, dim>> rates;
      for (const Tensor<1, dim> &tangent : tangents(corners))
        rates.push_back(symmetrize(outer_product(n, tangent)));
      return rates;
    }



    /// sqrt(2) M^-T e of these rates, as columns.
    template <int dim>
    FullMatrix<double>
    work_of_rates(const Material<double>                     &material,
                  const std::vector<SymmetricTensor<2, dim>> &rates)
    {
      const FullMatrix<double> matrix = rate_matrix<dim>(material);
      FullMatrix<double>       components(matrix.n(), rates.size()),
        result(matrix.m(), rates.size());
      for (unsigned int j = 0; j < rates.size(); ++j)
        for (unsigned int c = 0; c < rates[j].n_independent_components; ++c)
          components(c, j) = std::sqrt(2.) * rates[j].access_raw_entry(c);
      matrix.mmult(result, components);
      return result;
    }
  } // namespace



  template <int dim>
  FullMatrix<double>
  stress_matrix(const Material<double> &material)
  {
    return factor_of_components<dim>(material, stress_factor<dim>);
  }



  template <int dim>
  FullMatrix<double>
  rate_matrix(const Material<double> &material)
  {
    return factor_of_components<dim>(material, rate_factor<dim>);
  }



  // They make the last row of M d zero.
  std::array<double, 3>
  weights_out_of_plane(const Material<double> &material)
  {
    if (!has_general_criterion(material))
      return {{0.5, 0.5, 0.}};
    const FullMatrix<double> matrix = stress_matrix<2>(material);
    std::array<double, 3>    weights;
    for (unsigned int c = 0; c < 3; ++c)
      weights[c] = -matrix(2, c) / matrix(2, 3);
    return weights;
  }



  // In space, the factor of the form that the work is in the two components.
  template <int dim>
  FullMatrix<double>
  slip_factor(const SplitBody<dim> &body,
              const unsigned int    face,
              const unsigned int    simplex)
  {
    const Material<double> &material = body.materials[simplex];
    FullMatrix<double>      factor{IdentityMatrix(dim - 1)};
    if (!has_general_criterion(material))
      return factor;
    const auto work =
      work_of_rates<dim>(material,
                         rates_of_slips<dim>(body.corners_of_face(face)));
    FullMatrix<double> form(dim - 1, dim - 1);
    work.Tmmult(form, work);
    factor(0, 0) = std::sqrt(form(0, 0));
    if (dim == 3)
      {
        factor(0, 1) = form(0, 1) / factor(0, 0);
        factor(1, 1) = std::sqrt(form(1, 1) - factor(0, 1) * factor(0, 1));
      }
    return factor;
  }



  template <int dim>
  FullMatrix<double>
  slip_factor(const SplitBody<dim> &body, const unsigned int face)
  {
    FullMatrix<double> least;
    double             least_norm = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < body.mesh.faces[face].n_neighbors(); ++i)
      {
        const unsigned int t      = body.mesh.faces[face].neighbors[i];
        FullMatrix<double> factor = slip_factor(body, face, t);
        factor *= std::sqrt(0.5) * body.materials[t].yield_radius /
                  body.shear_strength(face);
        if (const double norm = factor.frobenius_norm(); norm < least_norm)
          {
            least_norm = norm;
            least      = factor;
          }
      }
    return least;
  }



  template FullMatrix<double>
  stress_matrix<2>(const Material<double> &);
  template FullMatrix<double>
  stress_matrix<3>(const Material<double> &);
  template FullMatrix<double>
  rate_matrix<2>(const Material<double> &);
  template FullMatrix<double>
  rate_matrix<3>(const Material<double> &);
  template FullMatrix<double>
  slip_factor(const SplitBody<2> &, const unsigned int, const unsigned int);
  template FullMatrix<double>
  slip_factor(const SplitBody<3> &, const unsigned int, const unsigned int);
  template FullMatrix<double>
  slip_factor(const SplitBody<2> &, const unsigned int);
  template FullMatrix<double>
  slip_factor(const SplitBody<3> &, const unsigned int);
} // namespace ElastoPlastic
