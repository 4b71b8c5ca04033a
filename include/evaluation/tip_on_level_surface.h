// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_tip_on_level_surface_h
#define evaluation_tip_on_level_surface_h

#include <deal.II/base/mpi.h>

#include <memory>

#include "evaluation/tip_on_surface.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A tip on a level surface, which overlaps it by a section.
  class TipOnLevelSurface : public TipOnSurface
  {
  public:
    TipOnLevelSurface(const std::shared_ptr<const TipShape> &tip,
                      const double                           gap,
                      const MPI_Comm                         communicator);

    double
    initial_gap() const override;

    double
    depth_factor() const override;

    double
    overlapped_area(const double height) const override;

  private:
    const std::shared_ptr<const TipShape> tip;
    const double                          gap;
    const MPI_Comm                        communicator;
  };
} // namespace ElastoPlastic

#endif
