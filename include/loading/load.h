// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_load_h
#define loading_load_h

#include "base/enum_names.h"

namespace ElastoPlastic
{
  enum class Control
  {
    depth, ///< the depth of the indenter is given, the force results
    force  ///< the force is given, the depth results
  };

  template <>
  inline const EnumNames<Control> enum_names<Control> = {
    {"depth", Control::depth}, {"force", Control::force}};



  /// What drives the indenter at one moment: a depth or a force.
  struct Load
  {
    Control control;
    double  value;
  };
} // namespace ElastoPlastic

#endif
