// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_refused_indenter_h
#define tests_refused_indenter_h

#include <iostream>

#include "indenter/indenter_parameters.h"
#include "refusal.h"

/// Why these parameters give no indenter.
inline void
print_refusal(const ElastoPlastic::IndenterParameters &parameters,
              const unsigned int                       dim)
{
  const auto make = [&]() {
    parameters.check(dim);
    if (dim == 2)
      ElastoPlastic::make_indenter<2>(parameters);
    else
      ElastoPlastic::make_indenter<3>(parameters);
  };
  std::cout << "  " << refusal(make) << std::endl;
}

#endif
