// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "contact/indenter_symmetric.h"

namespace ElastoPlastic
{
  template <int dim>
  IndenterSymmetric<dim>::IndenterSymmetric(const Symmetry symmetry,
                                            const Section &section)
    : symmetry(symmetry)
    , section(section)
  {}



  template <int dim>
  double
  IndenterSymmetric<dim>::profile(const Point<dim - 1> &x) const
  {
    return section.profile(symmetry == Symmetry::revolution ? x.norm() :
                                                              std::abs(x[0]));
  }



  template <int dim>
  bool
  IndenterSymmetric<dim>::is_convex() const
  {
    return true;
  }



  template <int dim>
  double
  IndenterSymmetric<dim>::depth_factor() const
  {
    return section.depth_factor;
  }



  template class IndenterSymmetric<2>;
  template class IndenterSymmetric<3>;
} // namespace ElastoPlastic
