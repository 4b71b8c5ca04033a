// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_tip_on_surface_h
#define evaluation_tip_on_surface_h

#include <deal.II/base/mpi.h>

#include <memory>

#include "base/exceptions.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// What the evaluation of an indentation test needs to know of a tip and the
  /// surface that it is pressed on.
  class TipOnSurface
  {
  public:
    virtual ~TipOnSurface() = default;

    /// From the undisplaced tip down to the first contact. Collective.
    virtual double
    initial_gap() const = 0;

    /// TipShape::depth_factor(), of what lies between tip and surface.
    virtual double
    depth_factor() const = 0;

    /// The area, seen from above and all around the tip, that tip and
    /// undeformed surface overlap when the tip has moved by @p height > 0 from
    /// the first contact on; 0 if it is not known. Collective.
    virtual double
    overlapped_area(const double height) const = 0;
  };



  /// A tip on a level surface, which overlaps it by a section.
  class TipOnLevelSurface : public TipOnSurface
  {
  public:
    TipOnLevelSurface(const std::shared_ptr<const TipShape> &tip,
                      const double                           gap,
                      const MPI_Comm                         communicator)
      : tip(tip)
      , gap(gap)
      , communicator(communicator)
    {}

    double
    initial_gap() const override
    {
      return gap;
    }

    double
    depth_factor() const override
    {
      return tip->depth_factor();
    }

    // (The tip may be an expression, which can fail.)
    double
    overlapped_area(const double height) const override
    {
      double area = 0;
      rethrow_collectively(communicator,
                           [&]() { area = tip->section_area(height); });
      return area;
    }

  private:
    const std::shared_ptr<const TipShape> tip;
    const double                          gap;
    const MPI_Comm                        communicator;
  };
} // namespace ElastoPlastic

#endif
