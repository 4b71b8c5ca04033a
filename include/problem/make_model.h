// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_make_model_h
#define problem_make_model_h

#include "input/parameters.h"
#include "problem/model.h"

namespace ElastoPlastic
{
  /// The problem that @p parameters describe, which must have passed their
  /// check. Reads the files that they name.
  /// @throws InputError for what is wrong in expressions, tables and files, on
  /// all ranks.
  template <int dim>
  Model<dim>
  make_model(const Parameters &parameters);
} // namespace ElastoPlastic

#endif
