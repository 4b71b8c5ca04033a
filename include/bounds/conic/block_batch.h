// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_block_batch_h
#define bounds_conic_block_batch_h

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <functional>
#include <tuple>
#include <vector>

#include "base/simd.h"
#include "bounds/conic/conic_program.h"
#include "bounds/conic/second_order_cone.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Some blocks of a ConicProgram of the same shape, in the notation of
  /// ConicBlock and KktSystem: one in each lane of the processor's SIMD
  /// instructions. Stresses on triangles of a mesh have only a few shapes.
  class BlockBatch
  {
  public:
    static constexpr unsigned int max_blocks = n_lanes<Simd<double>>;

    template <typename T>
    using ByLanes = std::array<T, max_blocks>;

    /// By cones.
    using Scalings = std::vector<SecondOrderCone::Scaling<double>>;

    /// What the blocks of a batch have in common.
    struct Shape
    {
      struct Cone
      {
        unsigned int size;
        unsigned int first_row;    ///< 1 if that of G is zero: a fixed radius
        unsigned int first_column; ///< see ConicLayout::Cone
        unsigned int n_columns;

        unsigned int
        n_rows() const
        {
          return size - first_row;
        }

        auto
        members() const
        {
          return std::tie(size, first_row, first_column, n_columns);
        }

        bool
        operator==(const Cone &other) const
        {
          return members() == other.members();
        }
      };

      unsigned int      n_unknowns;
      unsigned int      n_equations;
      unsigned int      n_null; ///< directions that no cone sees
      bool              has_quadratic_cost;
      std::vector<Cone> cones;

      auto
      members() const
      {
        return std::tie(
          n_unknowns, n_equations, n_null, has_quadratic_cost, cones);
      }

      bool
      operator==(const Shape &other) const
      {
        return members() == other.members();
      }
    };

    /// All batches of a program's @p blocks, which end one by one: so the
    /// memory need not hold their matrices twice.
    static std::vector<BlockBatch>
    make(std::vector<ConicBlock> blocks, const ConicLayout &layout);

    /// Asks for the address of the entry of each pair of equations, the larger
    /// one first, in the matrix that eliminate() adds to.
    void
    set_targets(const std::function<double *(const unsigned int,
                                             const unsigned int)> &target);

    /// Factorises H = P + G^T W^-2 G and adds A H^-1 A^T to the matrix. Blocks
    /// without quadratic cost may be singular: their H gets a small compliance
    /// in the directions that no cone sees, and in no others. All diagonals
    /// grow by the order of rounding errors.
    /// @return false if rounding has made an H indefinite all the same.
    bool
    eliminate(const Scalings &scalings);

    /// What several calls use, one after the other, for x, z, y and their
    /// products.
    struct Workspace
    {
      AlignedVector<Simd<double>> x, z, y, of_x, of_z, of_y;
    };

    /// Computes the @p reduced residual r_x + G^T W^-2 r_z of the @p residual
    /// r, and adds its product with A H^-1 to y.
    void
    reduce(Vector<double>  &y,
           Vector<double>  &reduced,
           const KktVector &residual,
           Workspace       &workspace) const;

    /// Solves H x = r_x + G^T W^-2 r_z - A^T y and W^2 z = G x - r_z for the
    /// @p residual r that has been @p reduced, and adds x and z to the
    /// @p solution. From the residual, it subtracts their product and that of y
    /// with the matrix of KktSystem.
    void
    substitute(KktVector            &solution,
               KktVector            &residual,
               const Vector<double> &reduced,
               const Vector<double> &y,
               Workspace            &workspace) const;

    /// Adds P x to @p slope.
    void
    add_quadratic_slope(Vector<double>       &slope,
                        const Vector<double> &x,
                        Workspace            &workspace) const;

    /// residual -= (the matrix of KktSystem without W) solution
    void
    subtract_product(KktVector       &residual,
                     const KktVector &solution,
                     Workspace       &workspace) const;

  private:
    using Lanes = AlignedVector<Simd<double>>;

    BlockBatch(const std::vector<ConicBlock>         &all_blocks,
               const ConicLayout                     &layout,
               const Shape                           &shape,
               const std::vector<unsigned int>       &blocks,
               const std::vector<FullMatrix<double>> &null_space);

    void
    set_cones(const unsigned int lane, const FullMatrix<double> &cone_matrix);

    /// Unknowns from begin to before end that neither cones nor cost couple
    /// with others. Their factor begins at this entry of all.
    struct Part
    {
      unsigned int begin;
      unsigned int end;
      unsigned int entry = 0;

      unsigned int
      size() const
      {
        return end - begin;
      }
    };

    void
    find_parts();

    /// H
    void
    assemble();
    void
    add_compliance(const Simd<double> &compliance);

    /// x := H^-1 x
    void
    solve(Lanes &x) const;

    // Some of the products of P, A and G with x, y and z.
    void
    multiply_unknowns(Workspace &workspace) const;
    void
    multiply_equations(Workspace &workspace) const;
    void
    subtract_products(KktVector &residual, const Workspace &workspace) const;

    /// Calls the @p function for each cone with its shape, its scaling, the
    /// transpose of its part of G (from the cone's first row on), and the first
    /// row of the cone among those of a block.
    template <typename Function>
    void
    for_each_cone(const Function &function) const
    {
      const Simd<double> *columns = cone_columns.begin();
      for (unsigned int c = 0, row = 0; c < shape.cones.size(); ++c)
        {
          const Shape::Cone &cone = shape.cones[c];
          function(cone, scalings[c], columns, row);
          row += cone.size;
          columns += cone.n_columns * cone.n_rows();
        }
    }

    void
    load_equations(Lanes &lanes, const Vector<double> &values) const;
    void
    add(Vector<double>              &values,
        const Lanes                 &lanes,
        const ByLanes<unsigned int> &begins,
        const double                 factor) const;
    void
    add_to_equations(Vector<double> &values,
                     const Lanes    &lanes,
                     const double    factor) const;

    Shape        shape;
    unsigned int n_blocks;
    unsigned int n_rows; ///< of G

    std::vector<Part> parts;

    /// Of each block; in lanes without one, those of the first.
    ByLanes<unsigned int> unknowns, rows, cones;

    /// By equations and blocks.
    std::vector<ByLanes<unsigned int>> equations;

    /// By entries of the lower half of A H^-1 A^T and blocks.
    std::vector<ByLanes<double *>> targets;

    Lanes quadratic_cost; ///< P
    Lanes coupling;       ///< A
    Lanes cone_columns;   ///< the transposes of the cones' parts of G
    Lanes null_space;     ///< an orthonormal basis, one direction per row
    Lanes factor;         ///< of the parts, see LocalAlgebra::factorize()
    std::vector<SecondOrderCone::Scaling<Simd<double>>> scalings;
  };
} // namespace ElastoPlastic

#endif
