// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_indenter_path_h
#define loading_indenter_path_h

#include <deal.II/base/tensor.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/expression.h"

namespace ElastoPlastic
{
  /// How an indenter moves sideways: its horizontal displacement over time,
  /// from zero at t = 0, linear between the rows of a table and constant after
  /// the last, or an expression in t for each component.
  class IndenterPath
  {
  public:
    /// @p text is the entry Loading/Path: rows such as "1: 0 | 2: 0.5", in
    /// space "1: 0, 0 | 2: 0.5, 0", or expressions that are separated by ';';
    /// an indenter that does not move if it is empty.
    /// @throws InputError
    explicit IndenterPath(const std::string &text);

    bool
    is_at_rest() const
    {
      return n_components == 0;
    }

    /// One in the plane, two in space: as many as the text has.
    /// @throws InputError if there is a path, and it has not @p n components.
    void
    check_components(const unsigned int n) const;

    /// The times of the rows of a table, increasing.
    std::vector<double>
    corners() const;

    /// Components that the path does not have are zero.
    Tensor<1, 2>
    displacement(const double time) const;

  private:
    void
    read_table();

    void
    read_expressions();

    /// Of @p words, which are components. @throws InputError
    void
    take_n_components(const std::vector<std::string> &words);

    const std::string              text;
    unsigned int                   n_components = 0;
    std::map<double, Tensor<1, 2>> rows;

    std::vector<std::shared_ptr<const Expression<1>>> expressions;
  };
} // namespace ElastoPlastic

#endif
