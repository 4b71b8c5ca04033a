// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <set>

#include "output/body_output.h"

namespace ElastoPlastic
{
  namespace
  {
    PointField
    tensor_field(const std::string    &name,
                 const std::string    &quantity,
                 SymmetricTensor<2, 3> PointResult::*const tensor)
    {
      return {name,
              quantity,
              3 * 3,
              false,
              [tensor](const PointResult &point, float *values) {
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    *values++ = (point.*tensor)[i][j];
              }};
    }



    PointField
    number_field(const std::string                                &name,
                 const std::string                                &quantity,
                 const bool                                        is_positive,
                 const std::function<double(const PointResult &)> &number)
    {
      return {name,
              quantity,
              1,
              is_positive,
              [number](const PointResult &point, float *values) {
                *values = number(point);
              }};
    }



    double
    von_mises_stress(const PointResult &point)
    {
      return std::sqrt(1.5) * deviator(point.stress).norm();
    }



    double
    pressure(const PointResult &point)
    {
      return -trace(point.stress) / 3.;
    }



    double
    triaxiality(const PointResult &point)
    {
      const double von_mises = von_mises_stress(point);
      return von_mises > 0. ? -pressure(point) / von_mises : 0.;
    }



    std::vector<PointField>
    fields_of(const AdditionalField field)
    {
      std::vector<PointField> fields;
      switch (field)
        {
          case AdditionalField::principal_stresses:
            for (unsigned int i = 0; i < 3; ++i)
              fields.push_back(
                number_field("principal_stress_" + std::to_string(i + 1),
                             "stress",
                             false,
                             [i](const PointResult &point) {
                               return eigenvalues(point.stress)[i];
                             }));
            break;
          case AdditionalField::pressure:
            fields = {number_field("pressure", "stress", false, pressure)};
            break;
          case AdditionalField::triaxiality:
            fields = {number_field("triaxiality", "1", false, triaxiality)};
            break;
          case AdditionalField::back_stress:
            fields = {
              tensor_field("back_stress", "stress", &PointResult::back_stress)};
            break;
        }
      return fields;
    }
  } // namespace



  std::vector<PointField>
  point_fields(const std::vector<AdditionalField> &additional,
               const bool                          is_rate_dependent)
  {
    std::vector<PointField> fields = {
      tensor_field("stress", "stress", &PointResult::stress),
      tensor_field("plastic_strain", "1", &PointResult::plastic_strain),
      number_field("von_mises_stress", "stress", true, von_mises_stress),
      number_field("equivalent_plastic_strain",
                   "1",
                   true,
                   std::mem_fn(&PointResult::equivalent_plastic_strain))};
    if (is_rate_dependent)
      fields.push_back(number_field(
        "equivalent_plastic_strain_rate",
        "1 / time",
        true,
        std::mem_fn(&PointResult::equivalent_plastic_strain_rate)));
    for (const AdditionalField field :
         std::set<AdditionalField>(additional.begin(), additional.end()))
      for (const PointField &part : fields_of(field))
        fields.push_back(part);
    return fields;
  }
} // namespace ElastoPlastic
