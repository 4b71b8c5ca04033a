// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/largest_error.h"
#include "bounds/stress/stress_program.h"

// What StressProgram does with the faces of the simplices, and under the
// indenter.

namespace ElastoPlastic
{
  // The work of given tractions is on the right-hand side.
  template <int dim>
  void
  StressProgram<dim>::number_equations()
  {
    const unsigned int  n = Element::n_face_points(degree);
    std::vector<double> values, live_load;
    equations.resize(n * body.mesh.faces.size());
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const auto load = point_forces(f, [&](const FacePoint<dim> &x) {
            return body.loads(f, c, x).constant;
          });
          const auto more = point_forces(f, [&](const FacePoint<dim> &x) {
            return body.load_factor_unit * body.loads(f, c, x).growing;
          });
          for (unsigned int i = 0; i < n; ++i)
            {
              equations[index({f, i})][c] = numbers::invalid_unsigned_int;
              if (body.conditions[f].components[c].type ==
                    ConditionType::displacement ||
                  is_on_axis({f, i}))
                continue;
              equations[index({f, i})][c] = values.size();
              values.push_back(load[i]);
              live_load.push_back(more[i]);
            }
        }
    if (has_growing_pressure())
      {
        values.resize(values.size() + body.mesh.simplices.size(), 0.);
        live_load.resize(values.size(), 1.);
      }
    program.right_hand_side = Vector<double>(values.begin(), values.end());
    if (body.load_factor_unit > 0)
      program.live_load = Vector<double>(live_load.begin(), live_load.end());
  }



  template <int dim>
  template <typename Function>
  std::vector<double>
  StressProgram<dim>::moments(const unsigned int face, const Function &f) const
  {
    const unsigned int  n = Element::n_face_points(degree);
    std::vector<double> result(n);
    integrate_on_face<dim>(body.corners_of_face(face),
                           [&](const FacePoint<dim> &point,
                               const double          weight) {
                             const auto functions =
                               Bernstein<dim - 1>::functions(degree,
                                                             point.position);
                             const double density = n * weight * f(point);
                             for (unsigned int i = 0; i < n; ++i)
                               result[i] += density * functions[i];
                           });
    return result;
  }



  // There are none inside the body.
  template <int dim>
  template <typename Load>
  std::vector<double>
  StressProgram<dim>::point_forces(const unsigned int face,
                                   const Load        &load) const
  {
    const unsigned int  n = Element::n_face_points(degree);
    std::vector<double> forces(n);
    if (body.mesh.faces[face].is_inside())
      return forces;
    const auto  of_load = moments(face, [&](const FacePoint<dim> &point) {
      return body.weight(point.x) / body.weight_unit() * load(point);
    });
    const auto &coefficients =
      Bernstein<dim - 1>::coefficients_of_moments(degree);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        forces[i] += share_of_face(face) / body.stress_unit *
                     coefficients(i, j) * of_load[j] / n;
    return forces;
  }



  template <int dim>
  void
  StressProgram<dim>::add_tractions(const unsigned int        t,
                                    const FullMatrix<double> &stresses)
  {
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          if (const unsigned int n =
                equations[index({body.mesh.simplices[t].faces[k], i})][c];
              n != numbers::invalid_unsigned_int)
            program.blocks[t].add_to_equation(n,
                                              row_of(point_force(t, k, i, c),
                                                     stresses));
  }



  template <int dim>
  typename StressProgram<dim>::PointForce
  StressProgram<dim>::point_force(const unsigned int t,
                                  const unsigned int k,
                                  const unsigned int i,
                                  const unsigned int component) const
  {
    const unsigned int   f = body.mesh.simplices[t].faces[k];
    const Tensor<1, dim> normal =
      (body.mesh.faces[f].neighbors[0] == t ? 1. : -1.) *
      body.outward_normal(f);
    const Tensor<1, dim> force =
      share_of_face(f) * body.conditions[f].components[component].direction;
    PointForce result = {
      {},
      Bernstein<dim>::n_functions(degree) * k +
        Element::number_on_face(degree, body.mesh.places_in_part(t, k), i)};
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        result.functional[SymmetricTensor<2, dim>::component_to_unrolled_index(
          TableIndices<2>(d, e))] += force[d] * normal[e];
    return result;
  }



  template <int dim>
  Vector<double>
  StressProgram<dim>::row_of(const PointForce         &force,
                             const FullMatrix<double> &stresses) const
  {
    Vector<double> row(stresses.n());
    for (unsigned int e = 0; e < Element::n_components; ++e)
      for (unsigned int j = 0; j < row.size(); ++j)
        row[j] += force.functional[e] *
                  stresses(n_stress_components<dim> * force.value + e, j);
    return row;
  }



  template <int dim>
  double
  StressProgram<dim>::multiplier(const PointOfFace    &point,
                                 const unsigned int    component,
                                 const Vector<double> &y) const
  {
    if (const unsigned int n = equations[index(point)][component];
        n != numbers::invalid_unsigned_int)
      return y[n];
    return has_energy ? given_multiplier(point, component) : 0.;
  }



  template <int dim>
  double
  StressProgram<dim>::given_multiplier(const PointOfFace &point,
                                       const unsigned int component) const
  {
    return -moments(point.face,
                    body.conditions[point.face]
                      .components[component]
                      .value)[point.point] /
           (body.strain_unit * body.length_unit);
  }



  // The indenter's forces point down.
  template <int dim>
  void
  StressProgram<dim>::add_indenter()
  {
    Vector<double> row(1);
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      if (body.conditions[f].is_pressed())
        for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
          if (const unsigned int n = equations[index({f, i})][dim - 1];
              n != numbers::invalid_unsigned_int)
            {
              contact_points.push_back({f, i});
              ConicBlock &block = program.blocks.emplace_back(1);
              row[0]            = contact_unit(f);
              block.add_to_equation(n, row);
              row[0] = -1.;
              block.add_inequality(row);
            }
  }



  // The force at a point is expected to be of the size of its share of the
  // area, and the gap that is its multiplier of the size 1, in units of the
  // body.
  template <int dim>
  void
  StressProgram<dim>::add_gap()
  {
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        const auto [face, point]        = contact_points[i];
        contact_block(i).cone_scales[0] = {share_of_face(face) /
                                             contact_unit(face),
                                           contact_unit(face)};
        add_contact_cost(i, moments(face, [&](const FacePoint<dim> &x) {
                           return body.gap(x.x);
                         })[point]);
      }
  }



  template <int dim>
  void
  StressProgram<dim>::add_force(const double factor)
  {
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      add_contact_cost(i, factor);
  }



  template <int dim>
  void
  StressProgram<dim>::prescribe_force(const double force)
  {
    const unsigned int row = program.right_hand_side.size();
    program.right_hand_side.grow_or_shrink(row + 1);
    program.right_hand_side[row] = force / body.force_unit();
    program.has_dense_row        = true;
    Vector<double> part(1);
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        part[0] = contact_unit(contact_points[i].face) * vertical_part(i);
        contact_block(i).add_to_equation(row, part);
      }
  }



  // Where it comes to the axis, the weighted pressure is zero: there, the
  // pressure is that of the coefficient beside it.
  template <int dim>
  void
  StressProgram<dim>::set_pressure(StressField<dim> &field,
                                   const double     *unknowns) const
  {
    const unsigned int n = Element::n_face_points(degree);
    field.pressure.resize(body.mesh.faces.size());
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        const auto [f, point] = contact_points[i];
        const double force    = contact_unit(f) * unknowns[i];
        const auto   x =
          point_on_face<dim>(body.corners_of_face(f),
                             Bernstein<dim - 1>::points(degree)[point]);
        auto &pressure = field.pressure[f];
        pressure.resize(n);
        pressure[point] = force * body.stress_unit * body.weight_unit() /
                          (share_of_face(f) * body.weight(x.x));
        if (point == 1 && is_on_axis({f, 0}))
          pressure[0] = pressure[point];
        if (point + 2 == n && is_on_axis({f, n - 1}))
          pressure[n - 1] = pressure[point];
        field.force += body.force_unit() * vertical_part(i) * force;
      }
  }
} // namespace ElastoPlastic
