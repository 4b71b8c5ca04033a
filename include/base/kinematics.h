// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_kinematics_h
#define base_kinematics_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include "base/enum_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What the coordinates of a mesh mean.
  enum class Kinematics
  {
    cartesian,    ///< a body in space; in two dimensions, its section in plane
                  ///< strain, of unit thickness
    plane_stress, ///< in two dimensions, a sheet of unit thickness that bears
                  ///< no stress across
    axisymmetric  ///< in two dimensions, the half section x = r >= 0 of a body
                  ///< of revolution about the axis x = 0
  };

  template <>
  inline const EnumNames<Kinematics> enum_names<Kinematics> = {
    {"plane strain", Kinematics::cartesian},
    {"plane stress", Kinematics::plane_stress},
    {"axisymmetric", Kinematics::axisymmetric}};



  /// How the volumetric strain enters the stress (doc/theory, "Locking").
  enum class VolumetricTreatment
  {
    standard, ///< tr(strain) point by point: Q1 then locks in plastic flow
    b_bar     ///< its mean value over the cell
  };

  template <>
  inline const EnumNames<VolumetricTreatment> enum_names<VolumetricTreatment> =
    {{"standard", VolumetricTreatment::standard},
     {"B-bar", VolumetricTreatment::b_bar}};



  /// How large strains may become.
  enum class Strain
  {
    small,      ///< the symmetric part of the displacement gradient
    logarithmic ///< ln(F^T F) / 2, of the deformation gradient F
  };

  template <>
  inline const EnumNames<Strain> enum_names<Strain> = {{"small", Strain::small},
                                                       {"logarithmic",
                                                        Strain::logarithmic}};



  /// How strains follow from displacements. In plane stress, the volumetric
  /// strain follows from the stress; so there is nothing to treat.
  struct StrainModel
  {
    StrainModel(const VolumetricTreatment treatment,
                const Kinematics          kinematics = Kinematics::cartesian,
                const Strain              strain     = Strain::small)
      : treatment(kinematics == Kinematics::plane_stress ?
                    VolumetricTreatment::standard :
                    treatment)
      , kinematics(kinematics)
      , strain(strain)
    {}

    bool
    is_finite() const
    {
      return strain == Strain::logarithmic;
    }

    /// Whether tangents are those of nominal stresses with respect to
    /// displacement gradients, without any special form.
    bool
    has_nominal_tangents() const
    {
      return is_finite() || has_general_criteria;
    }

    /// The same with another treatment.
    StrainModel
    with_treatment(const VolumetricTreatment other) const
    {
      StrainModel result(other, kinematics, strain);
      result.has_general_criteria = has_general_criteria;
      return result;
    }

    VolumetricTreatment treatment;
    Kinematics          kinematics;
    Strain              strain;
    /// Whether materials yield by other criteria than that of von Mises
    /// (ElastoPlastic::has_general_criterion()).
    bool has_general_criteria = false;
  };



  /// Whether the problem is one of plane strain or plane stress.
  template <int dim>
  bool
  is_plane_problem(const Kinematics kinematics)
  {
    return dim == 2 && kinematics != Kinematics::axisymmetric;
  }



  /// How much of the body a point of the mesh stands for, per unit of the
  /// mesh's area or length: 2 pi r for a ring.
  template <int dim, typename Number>
  Number
  out_of_plane_length(const Point<dim, Number> &point,
                      const Kinematics          kinematics)
  {
    return kinematics == Kinematics::axisymmetric ?
             2. * numbers::PI * point[0] :
             Number(1.);
  }
} // namespace ElastoPlastic

#endif
