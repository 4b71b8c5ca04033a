// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_state_h
#define contact_contact_state_h

#include <deal.II/base/numbers.h>

#include <boost/serialization/array.hpp>

#include <array>
#include <cmath>

namespace ElastoPlastic
{
  /// The contact quantities of a solution, of all ranks together.
  struct ContactState
  {
    unsigned int active_nodes = 0;
    /// Sum of the nodal forces, positive when the indenter presses.
    double force = 0;
    /// Of the touched part of the faces; if the contact ends at nodes, the sum
    /// of the lumped areas of the active ones.
    double contact_area = 0;
    double max_pressure = 0;
    /// The smallest pressure of an active node: negative would be tension.
    double min_pressure = 0;
    /// The largest violation of the bounds of the candidates.
    double max_penetration = 0;
    /// max(u_d - (g - depth), 0) over the candidates: how deep the nodes beside
    /// the edge of the contact, which may be inside by what the edge allows
    /// them (EdgeLaw), are in the indenter.
    double edge_penetration = 0;
    /// The same over the nodes without a pressure of their own: hanging ones,
    /// which follow their masters, and those without area.
    double max_hanging_penetration = 0;
    /// The horizontal force of the indenter on the body, by component: positive
    /// when it pushes in the direction of the axis.
    std::array<double, 2> tangential_force = {{0., 0.}};
    /// The part of contact_area that belongs to nodes that stick.
    double stick_area = 0;
    /// What friction has dissipated: in the load step, or once that has been
    /// committed, since the virgin state.
    double frictional_dissipation = 0;
    /// sum |force * distance| / (total force * |depth|) over the candidates.
    double complementarity_error = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &active_nodes &force &contact_area &max_pressure &min_pressure
        &max_penetration &edge_penetration &max_hanging_penetration
          &complementarity_error &tangential_force &stick_area
            &frictional_dissipation;
    }
  };



  /// The radius of the circle that has the area of the contact, of which
  /// @p area is the modelled @p part; in a plane problem half its width.
  inline double
  contact_radius(const double area, const double part, const bool is_plane)
  {
    return is_plane ? 0.5 * area / part :
                      std::sqrt(area / (part * dealii::numbers::PI));
  }



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
