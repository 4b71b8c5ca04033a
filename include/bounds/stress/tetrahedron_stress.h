// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_tetrahedron_stress_h
#define bounds_stress_tetrahedron_stress_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "bounds/mesh/tetrahedral_mesh.h"

/// The element of Johnson and Mercier on a tetrahedron
/// @cite krizek_1982 @cite gopalakrishnan_guzman_lee_2024: symmetric
/// stresses that are linear on each of its four parts, into which its centre of
/// gravity divides it. The tractions are continuous between the parts. Part k
/// has the face k, opposite to corner k; its corners are those of the
/// tetrahedron, with the centre in the place of corner k.
///
/// A stress is given by its values at the corners of the parts, see
/// value_index(). There are 42 such stresses, given by the tractions at the
/// corners of the faces (36) and by six mean values; 30 of them are without
/// divergence.
namespace ElastoPlastic::TetrahedronStress
{
  using namespace dealii;

  constexpr unsigned int n_parts = 4;
  /// Corners of parts, of each part its own.
  constexpr unsigned int n_points = 16;
  /// The order is that of SymmetricTensor: 11, 22, 33, 12, 13, 23.
  constexpr unsigned int n_components = 6;
  constexpr unsigned int n_values     = n_points * n_components;
  /// Stresses without divergence.
  constexpr unsigned int n_equilibrated = 30;



  constexpr unsigned int
  value_index(const unsigned int part,
              const unsigned int corner,
              const unsigned int component = 0)
  {
    return (4 * part + corner) * n_components + component;
  }



  Tetrahedron
  part_of(const Tetrahedron &tetrahedron, const unsigned int part);

  /// The stress whose components begin at @p values.
  SymmetricTensor<2, 3>
  stress_from(const double *values);

  /// The jumps of the tractions at the corners of the six faces between parts
  /// (54 x 96).
  FullMatrix<double>
  jump_matrix(const Tetrahedron &tetrahedron);

  /// What turns values into the divergence on the parts, which is constant
  /// there (12 x 96).
  FullMatrix<double>
  divergence_matrix(const Tetrahedron &tetrahedron);

  /// A basis of the stresses without divergence (96 x 30).
  FullMatrix<double>
  equilibrated_basis(const Tetrahedron &tetrahedron);

  /// What turns a stress into its traction on a plane with this @p normal
  /// (3 x 6).
  FullMatrix<double>
  traction_matrix(const Tensor<1, 3> &normal);

  /// The deviator of a stress, in an orthonormal basis (5 x 6).
  FullMatrix<double>
  deviator_matrix();
} // namespace ElastoPlastic::TetrahedronStress

#endif
