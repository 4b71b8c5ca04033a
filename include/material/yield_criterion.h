// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_yield_criterion_h
#define material_yield_criterion_h

#include "base/enum_names.h"

namespace ElastoPlastic
{
  /// The values of the entry "Yield criterion": which stresses a material bears
  /// without plastic flow.
  enum class YieldCriterion
  {
    von_mises,
    hosford,
    hill,
    mohr_coulomb,
    drucker_prager
  };

  template <>
  inline const EnumNames<YieldCriterion> enum_names<YieldCriterion> = {
    {"von Mises", YieldCriterion::von_mises},
    {"Hosford", YieldCriterion::hosford},
    {"Hill", YieldCriterion::hill},
    {"Mohr-Coulomb", YieldCriterion::mohr_coulomb},
    {"Drucker-Prager", YieldCriterion::drucker_prager}};
} // namespace ElastoPlastic

#endif
