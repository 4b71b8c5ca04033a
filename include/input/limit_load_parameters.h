// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_limit_load_parameters_h
#define input_limit_load_parameters_h

#include <deal.II/base/parameter_handler.h>

#include "base/enum_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What grows until the body collapses.
  enum class GrowingLoad
  {
    indenter, ///< its force
    tractions ///< and body forces
  };

  template <>
  inline const EnumNames<GrowingLoad> enum_names<GrowingLoad> = {
    {"indenter", GrowingLoad::indenter}, {"tractions", GrowingLoad::tractions}};



  /// The degree of the stresses of the lower bound; in a body of revolution, of
  /// their product with the distance from the axis.
  enum class StressDegree
  {
    automatic, ///< quadratic in bodies of revolution, linear in other ones
    linear,
    quadratic
  };

  template <>
  inline const EnumNames<StressDegree> enum_names<StressDegree> = {
    {"automatic", StressDegree::automatic},
    {"linear", StressDegree::linear},
    {"quadratic", StressDegree::quadratic}};



  /// The entries of the section "Limit load".
  struct LimitLoadParameters
  {
    GrowingLoad  load     = GrowingLoad::indenter;
    StressDegree stresses = StressDegree::automatic;

    /// In two dimensions.
    unsigned int
    degree_of_stresses(const bool is_axisymmetric) const;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace ElastoPlastic

#endif
