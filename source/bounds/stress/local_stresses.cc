// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/stress/local_stresses.h"

namespace ElastoPlastic::LocalStresses
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



    /// One @p component of the divergence on the parts, times the unit of
    /// length.
    template <int dim>
    FullMatrix<double>
    divergence_component(const SplitBody<dim> &body,
                         const unsigned int    t,
                         const unsigned int    degree,
                         const unsigned int    component)
    {
      const auto divergence =
        JohnsonMercier<dim>::divergence_matrix(body.corners_of(t), degree);
      FullMatrix<double> rows(divergence.m() / dim, divergence.n());
      for (unsigned int i = 0; i < rows.m(); ++i)
        for (unsigned int j = 0; j < rows.n(); ++j)
          rows(i, j) = body.length_unit * divergence(dim * i + component, j);
      return rows;
    }



    /// Of the @p basis of a body of revolution.
    void
    add_circumferential_stress(FullMatrix<double>       &stresses,
                               const SplitBody<2>       &body,
                               const unsigned int        t,
                               const unsigned int        degree,
                               const FullMatrix<double> &basis)
    {
      const auto         coefficients = circumferential_matrix(body, t, degree);
      const auto         weighting    = weighting_matrix(body, t, degree);
      FullMatrix<double> of_parts(coefficients.m(), basis.n()),
        weighted(weighting.m(), basis.n());
      coefficients.mmult(of_parts, basis);
      weighting.mmult(weighted, of_parts);
      for (unsigned int p = 0; p < weighted.m(); ++p)
        for (unsigned int j = 0; j < basis.n(); ++j)
          stresses(n_stress_components<2> * p + 3, j) = weighted(p, j);
    }
  } // namespace



  template <int dim>
  std::vector<double>
  weights(const SplitBody<dim> &body,
          const unsigned int    t,
          const unsigned int    degree)
  {
    using Element = JohnsonMercier<dim>;
    if (!body.is_axisymmetric())
      return std::vector<double>(Element::n_points(degree), 1.);
    std::vector<double> result;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const auto corners = Element::part_of(body.corners_of(t), k);
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
  double
  weight_of_centre(const SplitBody<dim> &body, const unsigned int t)
  {
    return weights(body, t, /* degree = */ 1)[place_of_centre<dim>(0)];
  }



  template <int dim>
  FullMatrix<double>
  basis(const SplitBody<dim> &body,
        const unsigned int    t,
        const unsigned int    degree)
  {
    const FullMatrix<double> all =
      JohnsonMercier<dim>::basis(body.corners_of(t), degree);
    const auto of_points = weights(body, t, degree);
    if (std::count(of_points.begin(), of_points.end(), 0.) == 0)
      return all;
    FullMatrix<double> on_axis(all.m(), all.m());
    for (unsigned int i = 0; i < all.m(); ++i)
      on_axis(i, i) =
        of_points[i / JohnsonMercier<dim>::n_components] > 0 ? 0. : 1.;
    return restrict_to_kernel(all, on_axis);
  }



  // The stresses, not the weighted ones, are what all simplices have of the
  // same size: the weight is that of the centre of gravity.
  template <int dim>
  FullMatrix<double>
  equilibrated_basis(const SplitBody<dim> &body,
                     const unsigned int    t,
                     const unsigned int    degree)
  {
    if (!body.is_axisymmetric())
      return JohnsonMercier<dim>::equilibrated_basis(body.corners_of(t),
                                                     degree);
    FullMatrix<double> equilibrated =
      restrict_to_kernel(basis(body, t, degree),
                         divergence_component(body, t, degree, 1));
    equilibrated *= weight_of_centre(body, t);
    return equilibrated;
  }



  template <int dim>
  std::vector<double>
  pressures(const SplitBody<dim> &body,
            const unsigned int    t,
            const unsigned int    degree,
            const double          load_factor)
  {
    using Element              = JohnsonMercier<dim>;
    const auto         weights = LocalStresses::weights(body, t, degree);
    const unsigned int n       = Bernstein<dim>::n_functions(degree);
    Vector<double>     at_points(n), coefficients(n);

    std::vector<double> result;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        const auto part = Element::part_of(body.corners_of(t), k);
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
          if (weights[n * k + p] > 0)
            result.push_back(coefficients[p] / weights[n * k + p]);
      }
    return result;
  }



  template <int dim>
  FullMatrix<double>
  point_stresses(const SplitBody<dim>     &body,
                 const unsigned int        t,
                 const unsigned int        degree,
                 const FullMatrix<double> &basis,
                 const OutOfPlane          out_of_plane,
                 const unsigned int        n)
  {
    constexpr unsigned int n_components = n_stress_components<dim>,
                           n_of_element = JohnsonMercier<dim>::n_components;
    const unsigned int n_points         = JohnsonMercier<dim>::n_points(degree);

    FullMatrix<double> stresses(n_components * n_points, n);
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int c = 0; c < n_of_element; ++c)
        for (unsigned int j = 0; j < basis.n(); ++j)
          stresses(n_components * p + c, j) = basis(n_of_element * p + c, j);
    if constexpr (dim == 2)
      {
        const auto weights = weights_out_of_plane(body.materials[t]);
        for (unsigned int p = 0; p < n_points; ++p)
          if (out_of_plane == OutOfPlane::unknown)
            stresses(n_components * p + 3, basis.n() + p) = 1.;
          else if (out_of_plane == OutOfPlane::mean)
            for (unsigned int c = 0; c < weights.size(); ++c)
              for (unsigned int j = 0; j < basis.n(); ++j)
                stresses(n_components * p + 3, j) +=
                  weights[c] * basis(3 * p + c, j);
        if (out_of_plane == OutOfPlane::circumferential)
          add_circumferential_stress(stresses, body, t, degree, basis);
      }
    return stresses;
  }



  FullMatrix<double>
  circumferential_matrix(const SplitBody<2> &body,
                         const unsigned int  t,
                         const unsigned int  degree)
  {
    return divergence_component(body, t, degree, 0);
  }



  // The coefficient a of the product of linear w and f, of degree n - 1, is
  // sum_i a_i / n w_i f_{a - e_i}.
  FullMatrix<double>
  weighting_matrix(const SplitBody<2> &body,
                   const unsigned int  t,
                   const unsigned int  degree)
  {
    using Element                 = JohnsonMercier<2>;
    const auto         at_corners = weights(body, t, /* degree = */ 1);
    const auto        &exponents  = Bernstein<2>::exponents(degree);
    const unsigned int n_lower    = Bernstein<2>::n_functions(degree - 1);
    FullMatrix<double> matrix(Element::n_points(degree),
                              Element::n_points(degree - 1));
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      for (unsigned int a = 0; a < exponents.size(); ++a)
        for (unsigned int i = 0; i < 3; ++i)
          if (exponents[a][i] > 0)
            {
              auto lowered = exponents[a];
              --lowered[i];
              matrix(exponents.size() * k + a,
                     n_lower * k + Bernstein<2>::number_of(lowered)) =
                Bernstein<2>::points(degree)[a][i] * at_corners[3 * k + i];
            }
    return matrix;
  }



  template std::vector<double>
  weights(const SplitBody<2> &, const unsigned int, const unsigned int);
  template std::vector<double>
  weights(const SplitBody<3> &, const unsigned int, const unsigned int);
  template double
  weight_of_centre(const SplitBody<2> &, const unsigned int);
  template double
  weight_of_centre(const SplitBody<3> &, const unsigned int);
  template FullMatrix<double>
  basis(const SplitBody<2> &, const unsigned int, const unsigned int);
  template FullMatrix<double>
  basis(const SplitBody<3> &, const unsigned int, const unsigned int);
  template FullMatrix<double>
  equilibrated_basis(const SplitBody<2> &,
                     const unsigned int,
                     const unsigned int);
  template FullMatrix<double>
  equilibrated_basis(const SplitBody<3> &,
                     const unsigned int,
                     const unsigned int);
  template std::vector<double>
  pressures(const SplitBody<2> &,
            const unsigned int,
            const unsigned int,
            const double);
  template std::vector<double>
  pressures(const SplitBody<3> &,
            const unsigned int,
            const unsigned int,
            const double);
  template FullMatrix<double>
  point_stresses(const SplitBody<2> &,
                 const unsigned int,
                 const unsigned int,
                 const FullMatrix<double> &,
                 const OutOfPlane,
                 const unsigned int);
  template FullMatrix<double>
  point_stresses(const SplitBody<3> &,
                 const unsigned int,
                 const unsigned int,
                 const FullMatrix<double> &,
                 const OutOfPlane,
                 const unsigned int);
} // namespace ElastoPlastic::LocalStresses
