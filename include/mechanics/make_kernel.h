// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_make_kernel_h
#define mechanics_make_kernel_h

#include <memory>

#include "mechanics/strain_measures.h"

namespace ElastoPlastic
{
  /// The @p Implementation of the interface @p Kernel for the elements of
  /// @p degree and the strain measure of @p strain_model, in which
  /// @p FiniteMeasure stands for logarithmic strains, and @p GeneralMeasure for
  /// small ones of materials with general criteria, which sheets do not have.
  template <typename Kernel,
            int dim,
            template <int, typename>
            class Implementation,
            template <typename>
            class FiniteMeasure,
            template <typename>
            class GeneralMeasure>
  std::unique_ptr<Kernel>
  make_kernel(const unsigned int degree, const StrainModel &strain_model)
  {
    const auto of_measure = [&](auto measure) -> std::unique_ptr<Kernel> {
      using Measure = decltype(measure);
      AssertIndexRange(degree, 3);
      if (degree == 1)
        return std::make_unique<Implementation<1, Measure>>(strain_model);
      return std::make_unique<Implementation<2, Measure>>(strain_model);
    };
    const auto of_coordinates = [&](auto coordinates) {
      using Coordinates = decltype(coordinates);
      if (strain_model.is_finite())
        return of_measure(FiniteMeasure<Coordinates>());
      if constexpr (!Coordinates::is_sheet)
        if (strain_model.has_general_criteria)
          return of_measure(GeneralMeasure<Coordinates>());
      AssertThrow(!strain_model.has_general_criteria, ExcInternalError());
      return of_measure(SmallStrain<Coordinates>());
    };

    if constexpr (dim == 2)
      {
        if (strain_model.kinematics == Kinematics::axisymmetric)
          return of_coordinates(AxisymmetricCoordinates());
        if (strain_model.kinematics == Kinematics::plane_stress)
          return of_coordinates(SheetCoordinates());
      }
    return of_coordinates(CartesianCoordinates<dim>());
  }
} // namespace ElastoPlastic

#endif
