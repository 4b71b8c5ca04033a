// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_library_h
#define indenter_indenter_library_h

#include <string>

#include "indenter/indenter.h"
#include "indenter/indenter_parameters.h"

namespace ElastoPlastic
{
  /// All values of the entry "Type", separated by '|'.
  std::string
  indenter_types();

  /// The indenter that the parameters describe, without a shape for type
  /// "none". The parameters must have passed their check. Reads the file that
  /// they name, if any. @throws InputError for what is wrong in an expression
  /// or a file, and for lists that do not fit the shape.
  template <int dim>
  PlacedIndenter<dim>
  make_indenter(const IndenterParameters &parameters);
} // namespace ElastoPlastic

#endif
