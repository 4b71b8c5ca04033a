// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_active_set_change_h
#define contact_active_set_change_h

namespace ElastoPlastic
{
  /// Which nodes begin to stick or to slip at once.
  enum class FrictionPace
  {
    all,        ///< that violate Coulomb's law
    worst_first ///< those that do so most
  };



  /// What of ContactSet has changed, on any rank.
  struct ActiveSetChange
  {
    bool statuses = false; ///< of nodes: open, entering, closed
    /// Whether the edge has moved by more than one node somewhere.
    bool edge_jumps = false;
    bool friction   = false; ///< whether nodes stick

    explicit operator bool() const
    {
      return statuses || friction;
    }
  };
} // namespace ElastoPlastic

#endif
