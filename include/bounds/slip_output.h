// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_slip_output_h
#define bounds_slip_output_h

#include <vector>

#include "bounds/mechanism/velocity_field.h"
#include "output/vtu_series.h"

namespace ElastoPlastic
{
  /// Writes where the parts of a mechanism of collapse slide along each other,
  /// along supports or a rough indenter: the files slip_lines-*.vtu with the
  /// field slip, the jump of the velocity, on faces. Those with less than a
  /// thousandth of the largest velocity are left out. On one rank.
  class SlipOutput
  {
  public:
    explicit SlipOutput(const OutputParameters &parameters);

    /// @p cycle numbers the file. @throws FileError
    template <int dim>
    void
    write(const SplitBody<dim>                    &body,
          const std::vector<SimplexVelocity<dim>> &velocity,
          const unsigned int                       cycle);

  private:
    VtuSeries series;
  };
} // namespace ElastoPlastic

#endif
