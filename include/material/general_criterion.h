// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_general_criterion_h
#define material_general_criterion_h

#include <variant>

#include "material/hill.h"
#include "material/hosford.h"

namespace ElastoPlastic
{
  /// The criteria for which the return to the yield surface is not radial: q(z)
  /// <= sigma with another norm q of the relative stress z than that of von
  /// Mises. What they have in common is what GeneralReturn asks of them, point
  /// by point: principal axes and powers are nothing for batches.
  using GeneralCriterion = std::variant<HillCriterion, HosfordCriterion>;
} // namespace ElastoPlastic

#endif
