// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <map>

#include "bounds/conic/local_algebra.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The number of a component of a symmetric tensor.
    template <int dim>
    unsigned int
    component(const unsigned int d, const unsigned int e)
    {
      return SymmetricTensor<2, dim>::component_to_unrolled_index(
        TableIndices<2>(d, e));
    }



    /// Adds the traction of a coefficient, whose components begin in column
    /// @p value, on a plane with this @p normal to rows of @p matrix.
    template <int dim>
    void
    add_traction(FullMatrix<double>   &matrix,
                 const unsigned int    row,
                 const unsigned int    value,
                 const Tensor<1, dim> &normal)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          matrix(row + d, value + component<dim>(d, e)) += normal[e];
    }



    /// A basis of the kernel of @p conditions, one per column.
    FullMatrix<double>
    kernel_of(const FullMatrix<double> &conditions)
    {
      const FullMatrix<double> rows = LocalAlgebra::kernel(conditions);
      FullMatrix<double>       columns(rows.n(), rows.m());
      columns.copy_transposed(rows);
      return columns;
    }



    /// The bases of the reference simplex.
    template <int dim>
    struct ReferenceBases
    {
      FullMatrix<double> all, equilibrated;

      explicit ReferenceBases(const unsigned int degree)
      {
        Corners<dim> corners;
        for (unsigned int d = 0; d < dim; ++d)
          corners[d + 1][d] = 1.;
        const auto jumps = JohnsonMercier<dim>::jump_matrix(corners, degree);
        const auto divergence =
          JohnsonMercier<dim>::divergence_matrix(corners, degree);
        FullMatrix<double> conditions(jumps.m() + divergence.m(), jumps.n());
        conditions.fill(jumps, 0, 0);
        conditions.fill(divergence, jumps.m(), 0);
        all          = kernel_of(jumps);
        equilibrated = kernel_of(conditions);
      }
    };



    template <int dim>
    const ReferenceBases<dim> &
    reference_bases(const unsigned int degree)
    {
      static std::map<unsigned int, ReferenceBases<dim>> by_degrees;
      return by_degrees.try_emplace(degree, degree).first->second;
    }



    // Piola's transformation F tau F^T carries stresses with continuous
    // tractions, and those without divergence, from the reference simplex to
    // any other.
    template <int dim>
    FullMatrix<double>
    transform(const FullMatrix<double> &reference, const Corners<dim> &corners)
    {
      constexpr unsigned int n = JohnsonMercier<dim>::n_components;

      double         square = 0;
      Tensor<2, dim> piola;
      for (unsigned int j = 0; j < dim; ++j)
        {
          const Tensor<1, dim> way = corners[j + 1] - corners[0];
          square += way.norm_square();
          for (unsigned int d = 0; d < dim; ++d)
            piola[d][j] = way[d];
        }
      piola *= 1. / std::sqrt(square);

      FullMatrix<double> basis(reference.m(), reference.n());
      for (unsigned int i = 0; i < basis.m(); i += n)
        for (unsigned int j = 0; j < basis.n(); ++j)
          {
            Tensor<2, dim> stress;
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = 0; e < dim; ++e)
                stress[d][e] = reference(i + component<dim>(d, e), j);
            stress = piola * stress * transpose(piola);
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = d; e < dim; ++e)
                basis(i + component<dim>(d, e), j) = stress[d][e];
          }
      return basis;
    }
  } // namespace



  template <int dim>
  Corners<dim>
  JohnsonMercier<dim>::part_of(const Corners<dim> &corners,
                               const unsigned int  part)
  {
    Corners<dim> result;
    for (unsigned int i = 0; i <= dim; ++i)
      result[place_in_part<dim>(part, i)] = corners[i];
    result[place_of_centre<dim>(part)] = centre_of<dim>(corners);
    return result;
  }



  template <int dim>
  unsigned int
  JohnsonMercier<dim>::number_on_face(
    const unsigned int                   degree,
    const std::array<unsigned int, dim> &places,
    const unsigned int                   i)
  {
    const auto &on_face = Bernstein<dim - 1>::exponents(degree)[i];
    typename Bernstein<dim>::Exponents exponents = {};
    for (unsigned int j = 0; j < dim; ++j)
      exponents[places[j]] = on_face[j];
    return Bernstein<dim>::number_of(exponents);
  }



  template <int dim>
  std::array<std::array<unsigned int, dim>, 2>
  JohnsonMercier<dim>::places_between(const unsigned int k,
                                      const unsigned int l)
  {
    std::array<std::array<unsigned int, dim>, 2> places;
    unsigned int                                 j = 0;
    for (unsigned int i = 0; i <= dim; ++i)
      if (i != opposite_corner<dim>(k) && i != opposite_corner<dim>(l))
        {
          places[0][j]   = place_in_part<dim>(k, i);
          places[1][j++] = place_in_part<dim>(l, i);
        }
    places[0][j] = place_of_centre<dim>(k);
    places[1][j] = place_of_centre<dim>(l);
    return places;
  }



  template <int dim>
  FullMatrix<double>
  JohnsonMercier<dim>::basis(const Corners<dim> &corners,
                             const unsigned int  degree)
  {
    return transform<dim>(reference_bases<dim>(degree).all, corners);
  }



  template <int dim>
  FullMatrix<double>
  JohnsonMercier<dim>::equilibrated_basis(const Corners<dim> &corners,
                                          const unsigned int  degree)
  {
    return transform<dim>(reference_bases<dim>(degree).equilibrated, corners);
  }



  // The face between parts k and l is that of part k which is opposite to where
  // part l has its centre.
  template <int dim>
  FullMatrix<double>
  JohnsonMercier<dim>::jump_matrix(const Corners<dim> &corners,
                                   const unsigned int  degree)
  {
    FullMatrix<double> jumps(dim * edges_per_simplex<dim> *
                               n_face_points(degree),
                             n_values(degree));
    unsigned int       row = 0;
    for (unsigned int k = 0; k < n_parts; ++k)
      for (unsigned int l = k + 1; l < n_parts; ++l)
        {
          Tensor<1, dim> normal = gradients(
            part_of(corners,
                    k))[place_in_part<dim>(k, opposite_corner<dim>(l))];
          normal /= normal.norm();
          const auto [here, there] = places_between(k, l);
          for (unsigned int i = 0; i < n_face_points(degree); ++i, row += dim)
            {
              add_traction(jumps,
                           row,
                           value_index(degree,
                                       k,
                                       number_on_face(degree, here, i)),
                           normal);
              add_traction(jumps,
                           row,
                           value_index(degree,
                                       l,
                                       number_on_face(degree, there, i)),
                           -normal);
            }
        }
    return jumps;
  }



  // The gradient of sum_a c_a B_a is n sum_b (sum_i c_{b + e_i} grad lambda_i)
  // B_b over the functions of degree n - 1.
  template <int dim>
  FullMatrix<double>
  JohnsonMercier<dim>::divergence_matrix(const Corners<dim> &corners,
                                         const unsigned int  degree)
  {
    FullMatrix<double> divergence(n_divergences(degree), n_values(degree));
    const auto        &lower = Bernstein<dim>::exponents(degree - 1);
    for (unsigned int k = 0; k < n_parts; ++k)
      {
        const auto gradient = gradients(part_of(corners, k));
        for (unsigned int b = 0; b < lower.size(); ++b)
          for (unsigned int i = 0; i <= dim; ++i)
            add_traction<dim>(divergence,
                              dim * (lower.size() * k + b),
                              value_index(degree,
                                          k,
                                          Bernstein<dim>::number_of(
                                            Bernstein<dim>::raised(lower[b],
                                                                   i))),
                              1. * degree * gradient[i]);
      }
    return divergence;
  }



  template struct JohnsonMercier<2>;
  template struct JohnsonMercier<3>;
} // namespace ElastoPlastic
