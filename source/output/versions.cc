// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/config.h>
#include <deal.II/base/vectorization.h>

#include "base/simd.h"
#include "base/version.h"
#include "output/versions.h"

namespace ElastoPlastic
{
  std::string
  versions(const unsigned int n_ranks, const std::string &prefix)
  {
    return prefix + "ElastoPlasticContact " + ELASTO_PLASTIC_CONTACT_VERSION +
           " (" + ELASTO_PLASTIC_CONTACT_REVISION + "), " +
           ELASTO_PLASTIC_CONTACT_BUILD_TYPE + " build\n" + prefix +
           "deal.II " + DEAL_II_PACKAGE_VERSION + ", " +
           std::to_string(Simd<double>::size()) +
           " number(s) per SIMD batch, " + std::to_string(n_ranks) +
           " MPI rank(s)\n";
  }
} // namespace ElastoPlastic
