// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_equilibrium_output_h
#define bounds_equilibrium_output_h

#include <array>
#include <string>
#include <vector>

#include "bounds/limit_load.h"
#include "bounds/mechanism/velocity_field.h"
#include "output/vtu_series.h"

namespace ElastoPlastic
{
  /// What there is on the simplices of a SplitMesh.
  template <int dim>
  struct EquilibriumFields
  {
    const SplitBody<dim>   &body;
    const StressField<dim> &stress;
    /// A displacement, or a velocity: by simplices, at their corners and
    /// their centres of gravity.
    const std::vector<std::array<Tensor<1, dim>, dim + 2>> motion;
    const std::vector<double>                             &errors;
    /// Of a mechanism of collapse: the plastic work per unit of volume. Else it
    /// is empty.
    const std::vector<double> plastic_work = {};
  };

  /// What limit_load.pvd shows of two bounds.
  template <int dim>
  EquilibriumFields<dim>
  fields_of(const SplitBody<dim> &body, const LimitLoad<dim> &bounds);



  /// Writes what ParaView shows of the equilibrium method, on one rank: files
  /// with one triangle or tetrahedron for each part of a simplex, nothing
  /// smoothed, and a list of them.
  class EquilibriumOutput
  {
  public:
    /// The files in the output directory are name-*.vtu and name.pvd; @p
    /// name_of_motion is that of EquilibriumFields::motion.
    EquilibriumOutput(const OutputParameters &parameters,
                      const std::string      &name,
                      const std::string      &name_of_motion);

    /// In the plane with a discontinuous relative of the motion, see
    /// StressField::displacement. @p cycle numbers the file. @throws FileError
    template <int dim>
    void
    write(const EquilibriumFields<dim> &fields, const unsigned int cycle);

  private:
    VtuSeries         series;
    const std::string name_of_motion;
  };



  /// Writes where the parts of a mechanism of collapse slide along each other,
  /// along supports or a rough indenter: the files slip_lines-*.vtu with the
  /// field slip, the jump of the velocity, on faces. Those with less than a
  /// thousandth of the largest velocity are left out. On one rank.
  class SlipOutput
  {
  public:
    explicit SlipOutput(const OutputParameters &parameters);

    /// @p cycle numbers the file. @throws FileError
    template <int dim>
    void
    write(const SplitBody<dim>                    &body,
          const std::vector<SimplexVelocity<dim>> &velocity,
          const unsigned int                       cycle);

  private:
    VtuSeries series;
  };
} // namespace ElastoPlastic

#endif
