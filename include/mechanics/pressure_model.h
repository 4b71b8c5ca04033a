// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_pressure_model_h
#define mechanics_pressure_model_h

#include <deal.II/lac/diagonal_matrix.h>

#include <vector>

#include "mechanics/solid_kernel.h"

namespace ElastoPlastic
{
  /// Solves with a model of the Schur complement S = 1 + D A^-1 D^T of the
  /// mixed form (doc/theory, "Nearly incompressible bodies"). With the bulk
  /// modulus K, that of A, K_A, and e = 1 - K_A / K,
  ///   S^-1 = 1 - e + e (e + F)^-1 e,   F = D A_G^-1 D^T,
  /// where A_G is A without the bulk modulus wherever K > K_A.
  ///
  /// If each cell has one pressure, F = R P R^T. P are the compliances of nodes
  /// that hang on springs each for itself, and the cells' rows of R are those
  /// of D, plus a constant that lets a pressure drag all nodes of its cell
  /// along: it makes a pressure that hardly changes from cell to cell as
  /// effective as it is in A_G, without being effective where D^T is not, at
  /// pressures that change their sign from cell to cell. Else, F is a diagonal.
  template <int dim>
  class PressureModel : public PressurePreconditioner
  {
  public:
    using Number = Simd<double>;

    /// Of a batch of cells: K, K_A and the shear modulus.
    struct Moduli
    {
      Number bulk, moderate_bulk, shear;
    };

    /// For the @p moduli of all cell batches. Displacements are held where
    /// @p held is not 0. @p kernel must outlive this object.
    PressureModel(const SolidKernel<dim>    &kernel,
                  const PointTangents<dim>  &tangents,
                  const std::vector<Moduli> &moduli,
                  const VectorType          &held);

    void
    vmult(VectorType &result, const VectorType &pressures) const override;

  private:
    void
    set_diagonals(const std::vector<Moduli> &moduli);

    /// Sets R and P.
    void
    couple(const PointTangents<dim>  &tangents,
           const std::vector<Moduli> &moduli,
           const VectorType          &held);

    /// (e + F) times @p pressures.
    void
    multiply(VectorType &result, const VectorType &pressures) const;

    const SolidKernel<dim>             &kernel;
    typename SolidKernel<dim>::CellRows rows;
    VectorType                          compliances;

    /// Of the pressures: e, and the reciprocals of a diagonal for e + F.
    VectorType                 excess;
    DiagonalMatrix<VectorType> inverse_diagonal;

    mutable VectorType rhs, displacements;
  };
} // namespace ElastoPlastic

#endif
