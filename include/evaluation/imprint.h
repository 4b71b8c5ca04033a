// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_imprint_h
#define evaluation_imprint_h

#include <deal.II/base/point.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <string>
#include <vector>

#include "contact/gap_function.h"
#include "evaluation/contact_surface.h"
#include "evaluation/nominal_contact.h"
#include "evaluation/solve_result.h"
#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// A row of surface_profile.csv: a point of the contact surface at the end of
  /// a load step. In two dimensions, third components are zero.
  struct SurfaceRow
  {
    unsigned int step = 0;
    double       time = 0;
    /// Of Output/Profile lines, from 1; in two dimensions 0.
    unsigned int line = 0;
    /// In the undeformed body.
    Point<3>     position;
    Tensor<1, 3> displacement;
    /// To the indenter in its present position; not a number where it does not
    /// reach.
    double gap              = 0;
    double contact_pressure = 0;
    /// On the body; and 1 where that sticks to the indenter.
    Tensor<1, 3> contact_shear;
    double       stick = 0;
  };



  /// What the indenter leaves on the contact surface: how wide the contact is,
  /// how far the surface piles up or sinks in beside it, and its profile.
  template <int dim>
  class Imprint
  {
  public:
    /// @p profile_lines is the entry Output/Profile lines. The other arguments
    /// must outlive this object. @throws InputError
    Imprint(const NominalContact<dim> &contact,
            const GapFunction<dim>    &gap_function,
            const std::string         &profile_lines);

    /// Every line that the user has named must meet @p surface. Collective.
    /// @throws InputError
    void
    check_lines(const ContactSurface<dim> &surface) const;

    /// Finds contact radius and pile-up of @p result, whose contact area is
    /// known. The pile-up is how far the surface stands above the undeformed
    /// one: its largest height within twice the largest contact radius until
    /// now, if that is positive, else the height of the edge of the contact,
    /// which has sunk in; zero without contact. Collective.
    void
    measure(SolveResult &result, const ContactSurface<dim> &surface) const;

    /// A load step has ended with @p result.
    void
    note(const SolveResult &result)
    {
      largest_radius = std::max(largest_radius, result.contact_radius);
    }

    /// The rows of surface_profile.csv: the nodes in two dimensions, the lines
    /// in three. On all ranks. Collective.
    std::vector<SurfaceRow>
    profile(const SolveResult         &result,
            const ContactSurface<dim> &surface) const;

    /// What has been noted, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &largest_radius;
    }

  private:
    const NominalContact<dim> &contact;
    const GapFunction<dim>    &gap_function;
    const bool                 has_own_lines;
    std::vector<ProfileLine>   lines; ///< none in two dimensions

    double largest_radius = 0;
  };
} // namespace ElastoPlastic

#endif
