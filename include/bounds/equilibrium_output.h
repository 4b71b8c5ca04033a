// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_equilibrium_output_h
#define bounds_equilibrium_output_h

#include <functional>
#include <string>
#include <vector>

#include "bounds/mechanism/velocity_field.h"
#include "bounds/stress/stress_field.h"
#include "output/vtu_series.h"

namespace ElastoPlastic
{
  /// What there is on the simplices of a SplitMesh.
  template <int dim>
  struct EquilibriumFields
  {
    const SplitBody<dim>   &body;
    const StressField<dim> &stress;
    /// A displacement, or a velocity, at a point of a simplex.
    const std::function<Tensor<1, dim>(const unsigned int,
                                       const Barycentric<dim> &)>
                               motion;
    const std::vector<double> &errors;
    /// Of a mechanism of collapse: the plastic work per unit of volume. Else it
    /// is empty.
    const std::vector<double> plastic_work = {};
  };


  /// Writes what ParaView shows of the equilibrium method, on one rank: files
  /// with one triangle or tetrahedron for each part of a simplex, nothing
  /// smoothed, and a list of them.
  template <int dim>
  class EquilibriumOutput
  {
  public:
    /// The files in the output directory are name-*.vtu and name.pvd; @p
    /// name_of_motion is that of EquilibriumFields::motion.
    EquilibriumOutput(const OutputParameters &parameters,
                      const std::string      &name,
                      const std::string      &name_of_motion)
      : series(parameters, name)
      , name_of_motion(name_of_motion)
    {}

    /// In the plane with a discontinuous relative of the motion, see
    /// StressField::displacement. @p cycle numbers the file. @throws FileError
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
  template <int dim>
  class SlipOutput
  {
  public:
    explicit SlipOutput(const OutputParameters &parameters)
      : series(parameters, "slip_lines")
    {}

    /// @p cycle numbers the file. @throws FileError
    void
    write(const SplitBody<dim>                    &body,
          const std::vector<SimplexVelocity<dim>> &velocity,
          const unsigned int                       cycle);

  private:
    VtuSeries series;
  };
} // namespace ElastoPlastic

#endif
