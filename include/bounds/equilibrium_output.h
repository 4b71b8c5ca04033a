// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_equilibrium_output_h
#define bounds_equilibrium_output_h

#include <array>
#include <string>
#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/stress/space_stress.h"
#include "bounds/stress/stress_field.h"
#include "output/vtu_series.h"

namespace ElastoPlastic
{
  /// What there is on the triangles of a SplitMesh.
  struct EquilibriumFields
  {
    const PlaneBody   &body;
    const StressField &stress;
    /// A displacement, or a velocity: by triangles, at their corners and
    /// their centres of gravity.
    const std::vector<std::array<Tensor<1, 2>, 4>> motion;
    const std::vector<double>                     &errors; ///< by triangles
    /// Of a mechanism of collapse: the plastic work per unit of volume, by
    /// triangles. Else it is empty.
    const std::vector<double> plastic_work = {};
  };



  /// What there is on the tetrahedra of a TetrahedralMesh.
  struct SpaceFields
  {
    const SpaceBody        &body;
    const SpaceStressField &stress;
    /// A displacement, or a velocity: by tetrahedra, at their corners and
    /// their centres of gravity.
    const std::vector<std::array<Tensor<1, 3>, 5>> motion;
    const std::vector<double>                     &errors; ///< by tetrahedra
    /// See EquilibriumFields, by tetrahedra.
    const std::vector<double> plastic_work = {};
  };



  /// Writes what ParaView shows of the equilibrium method, on one rank: files
  /// with one triangle for each subtriangle, or one tetrahedron for each of the
  /// parts of a tetrahedron, nothing smoothed, and a list of them.
  class EquilibriumOutput
  {
  public:
    /// The files in the output directory are name-*.vtu and name.pvd; @p
    /// name_of_motion is that of EquilibriumFields::motion.
    EquilibriumOutput(const OutputParameters &parameters,
                      const std::string      &name,
                      const std::string      &name_of_motion);

    /// @p cycle numbers the file. @throws FileError
    void
    write(const EquilibriumFields &fields, const unsigned int cycle);

    /// The same in space, without a discontinuous relative of the motion.
    void
    write(const SpaceFields &fields, const unsigned int cycle);

  private:
    VtuSeries         series;
    const std::string name_of_motion;
  };
} // namespace ElastoPlastic

#endif
