// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_load_h
#define loading_load_h

namespace ElastoPlastic
{
  enum class Control
  {
    depth, ///< the depth of the indenter is given, the force results
    force  ///< the force is given, the depth results
  };



  /// What drives the indenter at one moment: a depth or a force.
  struct Load
  {
    Control control;
    double  value;
  };
} // namespace ElastoPlastic

#endif
