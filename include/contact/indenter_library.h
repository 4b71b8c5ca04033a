// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_indenter_library_h
#define contact_indenter_library_h

#include <memory>
#include <string>

#include "contact/indenter.h"
#include "contact/indenter_parameters.h"

namespace ElastoPlastic
{
  /// All values of the entry "Type", separated by '|'.
  std::string
  indenter_types();

  /// The indenter that the parameters describe, a null pointer for type
  /// "none". The parameters must have passed their check. What is wrong in an
  /// expression or a file that they name is an InputError.
  template <int dim>
  std::unique_ptr<Indenter<dim>>
  make_indenter(const IndenterParameters &parameters);
} // namespace ElastoPlastic

#endif
