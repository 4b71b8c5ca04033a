// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_face_filter_h
#define contact_face_filter_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <set>
#include <vector>

#include "base/kinematics.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Takes from nodal tractions of elements of higher degree what scatters
  /// between the nodes of a face.
  ///
  /// On each face, tractions become (bi)linear functions with the same force
  /// and the same moments: with the lumped areas D_n of the face's nodes, those
  /// q for which
  ///
  ///   sum_n D_n (t_n - q(x_n)) phi(x_n) = 0   for all (bi)linear phi.
  ///
  /// A node gets the mean of the q of its faces, weighted with their areas; so
  /// does a node without area, that of quadratic elements on the axis of an
  /// axisymmetric body. Only faces that are touched as a whole count, and
  /// nodes without any stay as they are.
  /// For linear elements, this changes nothing, and is not done.
  template <int dim>
  class FaceFilter
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// Finds the faces on @p boundaries; @p constraints are those of hanging
    /// nodes, and must outlive this object or the next call; @p layout gives
    /// the partition of vectors. Collective.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &boundaries,
           const Kinematics                    kinematics,
           const Vector                       &layout);

    /// Of the nodal tractions @p values, all components of which are filtered.
    /// @p touched has ones in the vertical component of nodes with tractions.
    /// Collective.
    void
    apply(Vector &values, const Vector &touched) const;

  private:
    struct Face
    {
      /// By node of the lattice and by component.
      std::vector<types::global_dof_index> dofs;
      /// D_n.
      std::vector<double> areas;
    };

    /// Whether all nodes of @p face that have an area are touched.
    bool
    is_touched(const Face &face, const Vector &touched) const;

    /// The values of q at the nodes, for nodal @p values.
    std::vector<double>
    filtered(const Face &face, const std::vector<double> &values) const;

    const AffineConstraints<double>                   *constraints = nullptr;
    std::vector<Face>                                  faces;
    std::shared_ptr<const Utilities::MPI::Partitioner> vector_layout;

    /// The (bi)linear functions phi at the nodes of a face, by node.
    std::vector<std::vector<double>> linear_functions;
  };
} // namespace ElastoPlastic

#endif
