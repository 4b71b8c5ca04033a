// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_surface_finish_h
#define indenter_surface_finish_h

#include "base/enum_names.h"

namespace ElastoPlastic
{
  /// What an indenter's surface lets a perfectly plastic body do at its limit.
  enum class SurfaceFinish
  {
    smooth, ///< slide without shear stress
    rough   ///< not slide: any shear stress that the body bears
  };

  template <>
  inline const EnumNames<SurfaceFinish> enum_names<SurfaceFinish> = {
    {"smooth", SurfaceFinish::smooth}, {"rough", SurfaceFinish::rough}};
} // namespace ElastoPlastic

#endif
