// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_vector_field_h
#define tests_vector_field_h

#include <deal.II/base/function.h>

#include <functional>

/// The vector field with the components of_component(x, component).
template <int dim>
class VectorField : public dealii::Function<dim>
{
public:
  using Component =
    std::function<double(const dealii::Point<dim> &x, const unsigned int)>;

  explicit VectorField(const Component &of_component)
    : dealii::Function<dim>(dim)
    , of_component(of_component)
  {}

  double
  value(const dealii::Point<dim> &x,
        const unsigned int        component) const override
  {
    return of_component(x, component);
  }

private:
  const Component of_component;
};

#endif
