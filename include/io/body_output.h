// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_body_output_h
#define io_body_output_h

#include <deal.II/base/data_out_base.h>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The fields of the body for ParaView: for each cell a patch with as many
  /// points as a displacement component has nodes there.
  ///
  /// Stresses and strains live at the quadrature points. Their L2 projection
  /// onto discontinuous polynomials of the element's degree is the
  /// interpolation of the point values, here evaluated at the points of the
  /// patch: nothing is averaged, and neighbouring cells need not agree. Going
  /// from points to patches directly, this class needs no more memory than the
  /// patches.
  template <int dim>
  class BodyOutput : public DataOutInterface<dim>
  {
  public:
    using Patch = DataOutBase::Patch<dim, dim>;
    using Range =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    /// @p error_indicators has an entry for each active cell.
    BodyOutput(const DoFHandler<dim>    &dof_handler,
               const VectorType         &displacement,
               const SolidOperator<dim> &solid,
               const Vector<float>      &error_indicators);

  protected:
    const std::vector<Patch> &
    get_patches() const override;

    std::vector<std::string>
    get_dataset_names() const override;

    std::vector<Range>
    get_nonscalar_data_ranges() const override;

  private:
    void
    add_displacement(const DoFHandler<dim> &dof_handler,
                     const VectorType      &displacement);

    void
    add_point_fields(const DoFHandler<dim>    &dof_handler,
                     const VectorType         &displacement,
                     const SolidOperator<dim> &solid);

    std::vector<Patch> patches;
  };
} // namespace ElastoPlastic

#endif
