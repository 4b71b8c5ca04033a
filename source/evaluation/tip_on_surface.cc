// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/rethrow_collectively.h"
#include "evaluation/tip_on_surface.h"

namespace ElastoPlastic
{
  TipOnLevelSurface::TipOnLevelSurface(
    const std::shared_ptr<const TipShape> &tip,
    const double                           gap,
    const MPI_Comm                         communicator)
    : tip(tip)
    , gap(gap)
    , communicator(communicator)
  {}



  double
  TipOnLevelSurface::initial_gap() const
  {
    return gap;
  }



  double
  TipOnLevelSurface::depth_factor() const
  {
    return tip->depth_factor();
  }



  // The tip may be an expression, which can fail.
  double
  TipOnLevelSurface::overlapped_area(const double height) const
  {
    double area = 0;
    rethrow_collectively(communicator,
                         [&]() { area = tip->section_area(height); });
    return area;
  }
} // namespace ElastoPlastic
