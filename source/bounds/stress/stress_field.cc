// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/largest_error.h"
#include "base/tensors.h"
#include "bounds/conic/tolerances.h"
#include "bounds/stress/local_stresses.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  template <int dim>
  SymmetricTensor<2, 3>
  StressField<dim>::at(const unsigned int      t,
                       const unsigned int      part,
                       const Barycentric<dim> &point) const
  {
    const auto            functions = Bernstein<dim>::functions(degree, point);
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < functions.size(); ++i)
      stress += functions[i] * coefficient(t, part, i);
    return stress;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  StressField<dim>::tractions(const SplitMesh<dim> &mesh,
                              const unsigned int    t,
                              const unsigned int    k,
                              const Tensor<1, dim> &normal) const
  {
    using Element                      = JohnsonMercier<dim>;
    const auto                  places = mesh.places_in_part(t, k);
    std::vector<Tensor<1, dim>> result;
    for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
      result.push_back(
        in_plane<dim>(
          coefficient(t, k, Element::number_on_face(degree, places, i))) *
        normal);
    return result;
  }



  // On the axis, it is the quotient of the derivatives of weighted stress and
  // weight, to which the coefficients beside those of the corner contribute.
  template <int dim>
  SymmetricTensor<2, 3>
  StressField<dim>::without_weight(const SplitBody<dim> &body,
                                   const unsigned int    t,
                                   const unsigned int    part,
                                   const unsigned int    corner) const
  {
    const auto corners = JohnsonMercier<dim>::part_of(body.corners_of(t), part);
    const auto pressure =
      body.pressure_of_body_force(corners[corner], load_factor) *
      unit_symmetric_tensor<3>();
    if (!body.is_on_axis(corners[corner]))
      return coefficient(t, part, corner) / body.weight(corners[corner]) -
             pressure;
    SymmetricTensor<2, 3> derivative;
    double                of_weight = 0;
    for (unsigned int other = 0; other <= dim; ++other)
      if (other != corner)
        {
          typename Bernstein<dim>::Exponents beside = {};
          beside[corner]                            = degree - 1;
          beside[other]                             = 1;
          derivative += 1. * degree *
                        coefficient(t, part, Bernstein<dim>::number_of(beside));
          of_weight += body.weight(corners[other]);
        }
    return derivative / of_weight - pressure;
  }



  template <int dim>
  double
  StressField<dim>::max_pressure() const
  {
    double largest = 0;
    for (const auto &of_face : pressure)
      for (const double coefficient : of_face)
        keep_largest(largest, coefficient);
    return largest;
  }



  // An interior point leaves a little pressure everywhere. From the end that is
  // pressed to one that is not, the pressure falls to zero; so the part of such
  // a face counts whose coefficients do not vanish: of a side in a body of
  // revolution, they have equal parts in their order.
  template <int dim>
  double
  StressField<dim>::contact_area(const SplitBody<dim> &body) const
  {
    const double threshold = Tolerance::smallest_pressure * max_pressure();
    double       result    = 0;
    for (unsigned int f = 0; f < pressure.size(); ++f)
      for (unsigned int i = 0; i < pressure[f].size(); ++i)
        if (pressure[f][i] > threshold)
          {
            const auto       corners = body.corners_of_face(f);
            const double     share   = 1. / pressure[f].size();
            const Point<dim> middle =
              corners[0] + share * (i + 0.5) * (corners[1] - corners[0]);
            result +=
              body.angle() * body.weight(middle) * share * area(corners);
          }
    return result;
  }



  template struct StressField<2>;
  template struct StressField<3>;
} // namespace ElastoPlastic
