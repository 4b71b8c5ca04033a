// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_multifrontal_factor_h
#define bounds_conic_multifrontal_factor_h

#include <cstddef>
#include <memory>
#include <vector>

#include "bounds/conic/lower_triangle.h"

#include <suitesparse/cholmod.h>

namespace ElastoPlastic
{
  /// Computes the entries of a Cholesky factor whose structure CHOLMOD has
  /// found, and solves with them, by the multifrontal method @cite liu_1992:
  /// columns of one structure are eliminated together in a dense matrix, the
  /// front, and what that changes in later columns is added to the front of the
  /// next of them. Its products of matrices are larger than those of CHOLMOD's
  /// own algorithm, and independent parts of the matrix, as well as parts of
  /// large fronts, are left to different threads (OpenMP). The result does not
  /// depend on their number.
  class MultifrontalFactor
  {
  public:
    /// Some rows of a child's update, from begin to before end, and by how much
    /// later they come among those of the front.
    struct Rows
    {
      unsigned int begin;
      unsigned int end;
      unsigned int shift;
    };

    /// @p factor must be supernodal, with indices of 64 bits (those of 32 end
    /// at 2^31 entries), and live as long as this object. Of it, the structure
    /// is all that counts: the entries are stored here, by tiles.
    explicit MultifrontalFactor(const cholmod_factor &factor);

    /// Bytes of all entries.
    double
    memory() const;

    /// The most bytes that all threads of now, or less, can need beside them.
    double
    workspace() const;

    /// Makes all entries zero. @throws std::bad_alloc
    void
    clear();

    /// The entry of the unknowns @p i and @p j, where the matrix must have one;
    /// from the first clear() on always at the same address.
    double &
    entry(const unsigned int i, const unsigned int j);

    /// Replaces the entries of the matrix by those of its factor.
    /// @return false if the matrix is not positive definite.
    bool
    factorize();

    /// Replaces the right-hand side @p x by the solution, both in the order of
    /// elimination. Each entry of the factor is read twice, which takes as long
    /// as the memory needs.
    void
    solve(double *const x) const;

    MultifrontalFactor(const MultifrontalFactor &) = delete;
    MultifrontalFactor &
    operator=(const MultifrontalFactor &) = delete;

  private:
    /// The columns of the factor that are eliminated together: their rows are
    /// the first ones.
    struct Front : LowerTrapezoid
    {
      std::size_t             first_entry; ///< in the array of all
      const SuiteSparse_long *rows;        ///< in the order of elimination
      unsigned int first;    ///< of the fronts below it; they precede it
      double       work = 0; ///< with that of the fronts below it
      /// The fronts whose updates are for this one.
      std::vector<unsigned int> children;

      unsigned int
      n_updated() const
      {
        return n_rows - n_columns;
      }
    };

    /// How many entries of updates are held while fronts are treated, one after
    /// the other.
    struct UpdatesHeld
    {
      double now  = 0;
      double most = 0;

      void
      eliminate(const std::vector<Front> &fronts, const unsigned int front);
    };

    static std::vector<Rows>
    rows_in_common(const Front &child, const Front &front);

    void
    divide_among_threads();

    /// How many rows of a child's update are columns of its parent.
    static unsigned int
    n_columns_in_common(const Front &child, const Front &front);

    // The steps of a front.
    void
    assemble_columns(const Front &front);
    bool
    eliminate(const Front &front);
    void
    find_update(const unsigned int f);
    void
    assemble_update(const unsigned int f);
    bool
    eliminate(const unsigned int f);

    /// Whether a single thread takes the fronts one after the other: so the
    /// fewest updates wait for others.
    static bool
    is_alone();

    bool
    eliminate_by_parts();

    double *
    columns_of(const Front &front) const
    {
      return entries.get() + front.first_entry;
    }

    std::vector<Front>        fronts;
    std::size_t               n_entries = 0;
    std::unique_ptr<double[]> entries; ///< of the fronts' columns

    /// By fronts, what they change in later ones.
    std::vector<LowerTriangle> updates;

    /// By unknowns of the matrix, when they are eliminated; and by the order of
    /// elimination, in which front.
    std::vector<unsigned int> places;
    std::vector<unsigned int> front_of;

    /// The last fronts of independent parts, the largest first; and the fronts
    /// that come after all of these.
    std::vector<unsigned int> parts;
    std::vector<unsigned int> last_fronts;
  };
} // namespace ElastoPlastic



/// The steps of a Cholesky factorisation of large dense matrices, and of
/// solutions with it. They are stored by columns, @p stride numbers apart; only
/// their lower halves are read. What they do is what dpotrf, dtrsm, dsyrk,
/// dtrsv and dgemv of LAPACK and BLAS do, at about the same speed. But not
/// every BLAS can be called by several threads at a time (Debian's
/// libopenblas0-serial returns wrong numbers), and rounding errors of the BLAS
/// depend on the processor.
namespace ElastoPlastic::DensePanels
{
  /// A := L for the n x n matrix A = L L^T, where n is small: the other
  /// functions are for large ones. @return false if A is not positive definite.
  bool
  factorize(double *a, const unsigned int n, const unsigned int stride);

  /// B := B L^-T for an m x n matrix B
  void
  divide(double            *b,
         const unsigned int m,
         const unsigned int n,
         const double      *l,
         const unsigned int stride);

  /// x := L^-1 x for the m x n matrix L, the first n rows of which are a lower
  /// triangle: the other m - n entries of x lose their product with the first.
  void
  solve(double            *x,
        const unsigned int m,
        const unsigned int n,
        const double      *l,
        const unsigned int stride);

  /// The first n entries of x := L^-T x for the same L, the other m - n being
  /// known.
  void
  solve_transposed(double            *x,
                   const unsigned int m,
                   const unsigned int n,
                   const double      *l,
                   const unsigned int stride);

  /// The lower half of C := -A B^T for an m x k matrix A, the first n rows of
  /// which are B. Above the diagonal of C, anything may result.
  void
  set_to_minus_square(double            *c,
                      const unsigned int m,
                      const unsigned int n,
                      const unsigned int stride_of_c,
                      const double      *a,
                      const unsigned int k,
                      const unsigned int stride);

  /// The same for C -= A B^T.
  void
  subtract_square(double            *c,
                  const unsigned int m,
                  const unsigned int n,
                  const unsigned int stride_of_c,
                  const double      *a,
                  const unsigned int k,
                  const unsigned int stride);
} // namespace ElastoPlastic::DensePanels

#endif
