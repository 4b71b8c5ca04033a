// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_side_support_h
#define bounds_body_side_support_h

#include "bounds/body/plane_body.h"

namespace ElastoPlastic
{
  /// What the conditions of a side at the boundary demand of a mechanism.
  struct SideSupport
  {
    /// Nothing moves through the side.
    bool is_closed = false;
    /// To slide along the side, or along the indenter, takes plastic work.
    bool resists_slip = false;
    /// Of what the body slides along, see PlaneBody::indenter_velocity.
    Tensor<1, 2> velocity;
  };



  /// If a side is held in a direction oblique to it, it is taken to be closed
  /// and rough: such a mechanism is admissible as well.
  SideSupport
  support_of(const PlaneBody &body, const unsigned int side);
} // namespace ElastoPlastic

#endif
