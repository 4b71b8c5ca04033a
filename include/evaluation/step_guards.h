// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_step_guards_h
#define evaluation_step_guards_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <set>
#include <string>
#include <vector>

#include "evaluation/nominal_contact.h"
#include "evaluation/solve_result.h"
#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The largest pressure that an indenter can exert on a large body of the
  /// @p material where its equivalent plastic strain is @p plastic_strain:
  /// three times its yield stress Y, which is the mean pressure under a punch,
  /// or that which opens a spherical cavity in it,
  /// 2/3 Y (1 + ln(E / (3 (1 - nu) Y))) @cite hill_1950, whichever is larger.
  /// Infinite for an elastic material. Unit: stress.
  double
  largest_indentation_pressure(const Material<double> &material,
                               const double            plastic_strain);



  /// Tells when contact pressures are beyond what the yield stress of the body
  /// can bear (doc/trust, "Pressures that cannot be").
  class PressureGuard
  {
  public:
    /// So many times largest_indentation_pressure() is beyond doubt.
    static constexpr double factor = 2.;

    explicit PressureGuard(const std::vector<Material<double>> &materials)
      : materials(materials)
    {}


    /// The largest pressure that passes where the equivalent plastic strain is
    /// nowhere more than @p plastic_strain; that of the hardest material.
    double
    limit(const double plastic_strain) const;

    /// Whether @p pressure is beyond limit() for the first time.
    bool
    is_exceeded(const double pressure, const double plastic_strain);

  private:
    const std::vector<Material<double>> materials;
    bool                                was_exceeded = false;
  };



  /// Tells when a run leaves the theory of small strains (doc/trust,
  /// "Small strains or not"): by the largest equivalent plastic strain, by
  /// the slope of the indenter at the edge of the contact, which is that of the
  /// surface there, or, if it is flat, by its depth over the contact radius. In
  /// plane problems, where a depth depends on the size of the body, there is no
  /// such ratio; nor is there an edge under an indenter without a single tip.
  template <int dim>
  class SmallStrainGuard
  {
  public:
    /// Beyond these values there is a warning.
    static constexpr double largest_plastic_strain = 0.1;
    static constexpr double largest_slope          = 0.25;
    static constexpr double largest_relative_depth = 0.2;

    /// @p contact must outlive this object.
    explicit SmallStrainGuard(const NominalContact<dim> &contact)
      : contact(contact)
    {}


    /// A warning about the @p result of a load step: what is beyond its limit
    /// and was not when this function has been called before. Empty if there is
    /// nothing to say.
    std::string
    warning(const SolveResult &result);

  private:
    /// Adds to @p text that @p what is @p value if that is beyond @p limit for
    /// the first time.
    void
    compare(const std::string &what,
            const double       value,
            const double       limit,
            std::string       &text);

    const NominalContact<dim> &contact;
    std::set<std::string>      exceeded;
  };



  /// How good the worst corner of a deformed mesh is, and where it is now.
  template <int dim>
  struct ElementQuality
  {
    double     scaled_jacobian;
    Point<dim> place;
  };

  /// The smallest scaled Jacobian of all corners of all cells
  /// @cite knupp_2000, of a body whose points have moved by @p displacement:
  /// the determinant of the edges that meet in a corner over the product of
  /// their lengths. 1 for right angles, 0 where a corner has collapsed,
  /// negative where it is turned inside out. Collective.
  template <int dim>
  ElementQuality<dim>
  worst_element(const DoFHandler<dim>                            &dof_handler,
                const LinearAlgebra::distributed::Vector<double> &displacement);
} // namespace ElastoPlastic

#endif
