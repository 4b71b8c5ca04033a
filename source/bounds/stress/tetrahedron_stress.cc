// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/conic/local_algebra.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic::TetrahedronStress
{
  namespace
  {
    /// Adds the traction of the stress at a corner of a part, on a plane with
    /// this normal, to three rows of @p matrix.
    void
    add_traction(FullMatrix<double> &matrix,
                 const unsigned int  row,
                 const unsigned int  part,
                 const unsigned int  corner,
                 const Tensor<1, 3> &normal)
    {
      const FullMatrix<double> traction = traction_matrix(normal);
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int c = 0; c < n_components; ++c)
          matrix(row + d, value_index(part, corner, c)) += traction(d, c);
    }



    /// One per row.
    FullMatrix<double>
    basis_on_reference()
    {
      const Tetrahedron reference = {
        {Point<3>(), Point<3>(1, 0, 0), Point<3>(0, 1, 0), Point<3>(0, 0, 1)}};
      const FullMatrix<double> jumps       = jump_matrix(reference);
      const FullMatrix<double> divergences = divergence_matrix(reference);
      FullMatrix<double> conditions(jumps.m() + divergences.m(), n_values);
      conditions.fill(jumps);
      conditions.fill(divergences, jumps.m());
      return LocalAlgebra::kernel(conditions);
    }
  } // namespace



  Tetrahedron
  part_of(const Tetrahedron &tetrahedron, const unsigned int part)
  {
    Tetrahedron result = tetrahedron;
    result[part]       = Point<3>(0.25 * (tetrahedron[0] + tetrahedron[1] +
                                    tetrahedron[2] + tetrahedron[3]));
    return result;
  }



  SymmetricTensor<2, 3>
  stress_from(const double *values)
  {
    SymmetricTensor<2, 3> stress;
    for (unsigned int c = 0; c < n_components; ++c)
      stress.access_raw_entry(c) = values[c];
    return stress;
  }



  FullMatrix<double>
  traction_matrix(const Tensor<1, 3> &normal)
  {
    FullMatrix<double> matrix(3, n_components);
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < 3; ++e)
        matrix(d,
               SymmetricTensor<2, 3>::component_to_unrolled_index(
                 TableIndices<2>(d, e))) += normal[e];
    return matrix;
  }



  // The parts k and l have in common all corners but k and l: at these, one of
  // them has the centre, which they also have in common.
  FullMatrix<double>
  jump_matrix(const Tetrahedron &tetrahedron)
  {
    FullMatrix<double> jumps(54, n_values);
    unsigned int       row = 0;
    for (unsigned int k = 0; k < n_parts; ++k)
      for (unsigned int l = k + 1; l < n_parts; ++l)
        {
          const Tensor<1, 3> normal =
            outward_normal(part_of(tetrahedron, k), l);
          for (unsigned int i = 0; i < 4; ++i)
            if (i != l)
              {
                add_traction(jumps, row, k, i, normal);
                add_traction(jumps, row, l, i == k ? l : i, -normal);
                row += 3;
              }
        }
    return jumps;
  }



  FullMatrix<double>
  divergence_matrix(const Tetrahedron &tetrahedron)
  {
    FullMatrix<double> divergence(3 * n_parts, n_values);
    for (unsigned int part = 0; part < n_parts; ++part)
      {
        const auto gradient = gradients(part_of(tetrahedron, part));
        for (unsigned int i = 0; i < 4; ++i)
          add_traction(divergence, 3 * part, part, i, gradient[i]);
      }
    return divergence;
  }



  // Piola's transformation B tau B^T carries stresses without divergence and
  // with continuous tractions from the reference tetrahedron to any other.
  FullMatrix<double>
  equilibrated_basis(const Tetrahedron &tetrahedron)
  {
    static const FullMatrix<double> reference = basis_on_reference();

    Tensor<2, 3> piola;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int d = 0; d < 3; ++d)
        piola[d][j] = tetrahedron[j + 1][d] - tetrahedron[0][d];
    piola /= piola.norm();

    FullMatrix<double> basis(n_values, reference.m());
    for (unsigned int j = 0; j < reference.m(); ++j)
      for (unsigned int p = 0; p < n_points; ++p)
        {
          const Tensor<2, 3> of_reference =
            stress_from(&reference(j, n_components * p));
          const SymmetricTensor<2, 3> stress =
            symmetrize(piola * of_reference * transpose(piola));
          for (unsigned int c = 0; c < n_components; ++c)
            basis(n_components * p + c, j) = stress.access_raw_entry(c);
        }
    return basis;
  }



  FullMatrix<double>
  deviator_matrix()
  {
    FullMatrix<double> d(5, n_components);
    d(0, 0) = std::sqrt(0.5);
    d(0, 1) = -std::sqrt(0.5);
    d(1, 0) = d(1, 1) = -std::sqrt(1. / 6.);
    d(1, 2)           = std::sqrt(2. / 3.);
    for (unsigned int i = 0; i < 3; ++i)
      d(2 + i, 3 + i) = std::sqrt(2.);
    return d;
  }
} // namespace ElastoPlastic::TetrahedronStress
