// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/stress/local_stresses.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The combinations of the columns of @p basis whose product with
    /// @p conditions is zero.
    FullMatrix<double>
    restrict_to_kernel(const FullMatrix<double> &basis,
                       const FullMatrix<double> &conditions)
    {
      FullMatrix<double> product(conditions.m(), basis.n());
      conditions.mmult(product, basis);
      const FullMatrix<double> kernel = LocalAlgebra::kernel(product);
      FullMatrix<double>       restricted(basis.m(), kernel.m());
      basis.mTmult(restricted, kernel);
      return restricted;
    }
  } // namespace



  template <int dim>
  FullMatrix<double>
  LocalStresses<dim>::divergence_component(const unsigned int component) const
  {
    const auto divergence =
      Element::divergence_matrix(body.corners_of(simplex), degree);
    FullMatrix<double> rows(divergence.m() / dim, divergence.n());
    for (unsigned int i = 0; i < rows.m(); ++i)
      for (unsigned int j = 0; j < rows.n(); ++j)
        rows(i, j) = body.length_unit * divergence(dim * i + component, j);
    return rows;
  }



  template <int dim>
  void
  LocalStresses<dim>::add_circumferential_stress(
    FullMatrix<double> &stresses, const FullMatrix<double> &basis) const
  {
    const auto         coefficients = circumferential_matrix();
    const auto         weighting    = weighting_matrix();
    FullMatrix<double> of_parts(coefficients.m(), basis.n()),
      weighted(weighting.m(), basis.n());
    coefficients.mmult(of_parts, basis);
    weighting.mmult(weighted, of_parts);
    for (unsigned int p = 0; p < weighted.m(); ++p)
      for (unsigned int j = 0; j < basis.n(); ++j)
        stresses(n_stress_components<dim> * p + 3, j) = weighted(p, j);
  }



  template <int dim>
  std::vector<double>
  LocalStresses<dim>::weights() const
  {
    if (!body.is_axisymmetric())
      return std::vector<double>(Element::n_points(degree), 1.);
    std::vector<double> result;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const auto corners = Element::part_of(body.corners_of(simplex), k);
        for (const auto &point : Bernstein<dim>::points(degree))
          {
            double weight = 0;
            for (unsigned int i = 0; i <= dim; ++i)
              if (!body.is_on_axis(corners[i]))
                weight +=
                  point[i] * body.weight(corners[i]) / body.weight_unit();
            result.push_back(weight);
          }
      }
    return result;
  }



  template <int dim>
  FullMatrix<double>
  LocalStresses<dim>::basis() const
  {
    const FullMatrix<double> all =
      Element::basis(body.corners_of(simplex), degree);
    const auto of_points = weights();
    if (std::count(of_points.begin(), of_points.end(), 0.) == 0)
      return all;
    FullMatrix<double> on_axis(all.m(), all.m());
    for (unsigned int i = 0; i < all.m(); ++i)
      on_axis(i, i) = of_points[i / Element::n_components] > 0 ? 0. : 1.;
    return restrict_to_kernel(all, on_axis);
  }



  // The stresses, not the weighted ones, are what all simplices have of the
  // same size: the weight is that of the centre of gravity.
  template <int dim>
  FullMatrix<double>
  LocalStresses<dim>::equilibrated_basis() const
  {
    if (!body.is_axisymmetric())
      return Element::equilibrated_basis(body.corners_of(simplex), degree);
    FullMatrix<double> equilibrated =
      restrict_to_kernel(basis(), divergence_component(1));
    equilibrated *= weight_of_centre();
    return equilibrated;
  }



  template <int dim>
  std::vector<double>
  LocalStresses<dim>::pressures(const double load_factor) const
  {
    const auto         of_points = weights();
    const unsigned int n         = Bernstein<dim>::n_functions(degree);
    Vector<double>     at_points(n), coefficients(n);

    std::vector<double> result;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const auto part = Element::part_of(body.corners_of(simplex), k);
        for (unsigned int p = 0; p < n; ++p)
          {
            const Point<dim> x =
              interpolate(Bernstein<dim>::points(degree)[p], part);
            at_points[p] = body.weight(x) / body.weight_unit() *
                           body.pressure_of_body_force(x, load_factor) /
                           body.stress_unit;
          }
        Bernstein<dim>::coefficients(degree).vmult(coefficients, at_points);
        for (unsigned int p = 0; p < n; ++p)
          if (of_points[n * k + p] > 0)
            result.push_back(coefficients[p] / of_points[n * k + p]);
      }
    return result;
  }



  template <int dim>
  FullMatrix<double>
  LocalStresses<dim>::point_stresses(const FullMatrix<double> &basis,
                                     const OutOfPlane          out_of_plane,
                                     const unsigned int        n) const
  {
    constexpr unsigned int n_components = n_stress_components<dim>,
                           n_of_element = Element::n_components;
    const unsigned int n_points         = Element::n_points(degree);

    FullMatrix<double> stresses(n_components * n_points, n);
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int c = 0; c < n_of_element; ++c)
        for (unsigned int j = 0; j < basis.n(); ++j)
          stresses(n_components * p + c, j) = basis(n_of_element * p + c, j);
    if constexpr (dim == 2)
      {
        const auto weights = weights_out_of_plane(body.materials[simplex]);
        for (unsigned int p = 0; p < n_points; ++p)
          if (out_of_plane == OutOfPlane::unknown)
            stresses(n_components * p + 3, basis.n() + p) = 1.;
          else if (out_of_plane == OutOfPlane::mean)
            for (unsigned int c = 0; c < weights.size(); ++c)
              for (unsigned int j = 0; j < basis.n(); ++j)
                stresses(n_components * p + 3, j) +=
                  weights[c] * basis(3 * p + c, j);
        if (out_of_plane == OutOfPlane::circumferential)
          add_circumferential_stress(stresses, basis);
      }
    return stresses;
  }



  // The coefficient a of the product of linear w and f, of degree n - 1, is
  // sum_i a_i / n w_i f_{a - e_i}.
  template <int dim>
  FullMatrix<double>
  LocalStresses<dim>::weighting_matrix() const
  {
    const auto         at_corners = weights_at_corners();
    const auto        &exponents  = Bernstein<dim>::exponents(degree);
    const unsigned int n_lower    = Bernstein<dim>::n_functions(degree - 1);
    FullMatrix<double> matrix(Element::n_points(degree),
                              Element::n_points(degree - 1));
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      for (unsigned int a = 0; a < exponents.size(); ++a)
        for (unsigned int i = 0; i <= dim; ++i)
          if (exponents[a][i] > 0)
            {
              auto lowered = exponents[a];
              --lowered[i];
              matrix(exponents.size() * k + a,
                     n_lower * k + Bernstein<dim>::number_of(lowered)) =
                Bernstein<dim>::points(degree)[a][i] *
                at_corners[(dim + 1) * k + i];
            }
    return matrix;
  }



  template class LocalStresses<2>;
  template class LocalStresses<3>;
} // namespace ElastoPlastic
