// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/hencky_material.h"
#include "bounds/body/yield_matrices.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  using namespace HenckyMaterial;

  template <int dim>
  StressProgram<dim>::StressProgram(const SplitBody<dim> &body,
                                    const OutOfPlane      out_of_plane,
                                    const unsigned int    degree)
    : body(body)
    , out_of_plane(out_of_plane)
    , degree(degree)
  {
    if (body.is_axisymmetric())
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        bases.push_back(local(t).equilibrated_basis());
    number_equations();
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      add_block(t);
    add_indenter();
  }



  template <int dim>
  unsigned int
  StressProgram<dim>::n_growths(const unsigned int t) const
  {
    if (!hardens(body.materials[t]))
      return 0;
    const auto weights = local(t).weights();
    return weights.size() - std::count(weights.begin(), weights.end(), 0.);
  }



  template <int dim>
  FullMatrix<double>
  StressProgram<dim>::point_stresses(const unsigned int t) const
  {
    const FullMatrix<double> &basis =
      bases.empty() ? local(t).equilibrated_basis() : bases[t];
    const unsigned int n_unknown =
      out_of_plane == OutOfPlane::unknown ? Element::n_points(degree) : 0;
    return local(t).point_stresses(basis,
                                   out_of_plane,
                                   basis.n() + n_unknown + n_growths(t) +
                                     has_growing_pressure());
  }



  // |dev tau| <= R + zeta, or with friction R - sqrt(2) f p; with Hill's
  // criterion, the matrix of another norm.
  template <int dim>
  void
  StressProgram<dim>::add_block(const unsigned int t)
  {
    const FullMatrix<double> stresses = point_stresses(t);
    const Material<double>  &material = body.materials[t];
    ConicBlock              &block = program.blocks.emplace_back(stresses.n());
    if (yields(material))
      add_yield_conditions(block,
                           stress_matrix<dim>(material),
                           stresses,
                           local(t).weights(),
                           usable_part(t) * material.yield_radius /
                             body.stress_unit);
    if (hardens(material))
      for (unsigned int i = 0, n = n_growths(t); i < n; ++i)
        block.cone_matrix(n_stress_components<dim> * i,
                          block.cone_matrix.n() - n + i) = -1.;
    if (body.has_friction())
      add_friction_to(t, stresses);
    add_tractions(t, stresses);
  }



  // The pressure of body forces is not in the stresses.
  template <int dim>
  void
  StressProgram<dim>::add_friction_to(const unsigned int        t,
                                      const FullMatrix<double> &stresses)
  {
    ConicBlock  &block    = program.blocks[t];
    const double slope    = usable_part(t) * body.friction_slopes[t];
    const auto   weights  = local(t).weights();
    const auto   constant = local(t).pressures(0.);
    add_friction<dim>(block, stresses, weights, constant, slope);
    if (!has_growing_pressure())
      return;
    const auto         loaded  = local(t).pressures(body.load_factor_unit);
    const unsigned int unknown = stresses.n() - 1;
    for (unsigned int p = 0; p < loaded.size(); ++p)
      block.cone_matrix(n_stress_components<dim> * p, unknown) -=
        std::sqrt(2.) * slope * (loaded[p] - constant[p]);
    Vector<double> row(stresses.n());
    row[unknown] = 1.;
    block.add_to_equation(program.right_hand_side.size() -
                            body.mesh.simplices.size() + t,
                          row);
  }



  template <int dim>
  StressField<dim>
  StressProgram<dim>::solve(const double tolerance)
  {
    const ConicLayout   layout(program);
    const bool          force_is_given = program.has_dense_row;
    const ConicSolution solution = minimize(std::move(program), tolerance);
    const double        length   = body.length_unit;

    StressField<dim> field;
    field.degree                   = degree;
    const unsigned int n_simplices = body.mesh.simplices.size();
    for (unsigned int t = 0; t < n_simplices; ++t)
      {
        const FullMatrix<double> stresses = point_stresses(t);
        Vector<double>           values(stresses.m());
        LocalAlgebra::add_product(values.begin(),
                                  stresses,
                                  solution.x.begin() + layout.unknowns[t]);
        if (dim == 2)
          field.displacement.push_back(
            displacement_of(t,
                            strain_moments_of_solution(
                              t, values, solution.z.begin() + layout.rows[t]),
                            solution.y));
        add_stress(field, values);
      }
    set_pressure(field, solution.x.begin() + layout.unknowns[n_simplices]);
    if (force_is_given)
      field.depth =
        -body.strain_unit * length * solution.y[solution.y.size() - 1];
    field.load_factor = body.load_factor_unit * solution.load_factor;
    field.cost = solution.cost * body.force_unit() * body.strain_unit * length;
    if (has_energy)
      field.cost += energy_of_initial_stress();
    field.multipliers.assign(solution.multipliers.begin(),
                             solution.multipliers.begin() + n_simplices);
    field.n_iterations = solution.n_iterations;
    field.is_optimal   = solution.is_optimal;
    return field;
  }



  // The circumferential stress is a derivative of S, with rounding errors that
  // grow as triangles become small: the component 33 follows from it.
  template <int dim>
  void
  StressProgram<dim>::add_stress(StressField<dim>     &field,
                                 const Vector<double> &values) const
  {
    const unsigned int t      = field.values.size();
    Vector<double>    &stress = field.values.emplace_back(values);
    stress *= body.stress_unit * body.weight_unit();
    if constexpr (dim == 2)
      if (out_of_plane == OutOfPlane::circumferential)
        {
          const unsigned int n_points = Element::n_points(degree);
          Vector<double>     of_element(Element::n_values(degree)),
            hoop(Element::n_points(degree - 1)), weighted(n_points);
          for (unsigned int i = 0; i < of_element.size(); ++i)
            of_element[i] = stress[n_stress_components<2> * (i / 3) + i % 3];
          local(t).circumferential_matrix().vmult(hoop, of_element);
          local(t).weighting_matrix().vmult(weighted, hoop);
          hoop /= body.length_unit;
          weighted *= body.weight_unit() / body.length_unit;
          field.circumferential.emplace_back(hoop.begin(), hoop.end());
          for (unsigned int p = 0; p < n_points; ++p)
            stress[n_stress_components<2> * p + 3] = weighted[p];
        }
  }



  // sigma_33 follows the others where it is their mean; where it is an unknown,
  // its own derivative vanishes; where it is the circumferential stress, its
  // derivative is the mean of u_h along r, which displacement_of() finds from
  // the others.
  template <int dim>
  Vector<double>
  StressProgram<dim>::strain_moments_of_solution(const unsigned int    t,
                                                 const Vector<double> &values,
                                                 const double         *z) const
  {
    constexpr unsigned int n_components = n_stress_components<dim>;

    Vector<double> all(values.size());
    if (has_energy)
      {
        FullMatrix<double> column(values.size(), 1);
        for (unsigned int i = 0; i < values.size(); ++i)
          column(i, 0) = values[i];
        const auto strains = strain_moments(t, column);
        for (unsigned int i = 0; i < values.size(); ++i)
          all[i] = strains(i, 0);
        if (!body.initial_strains.empty())
          all -= moments_of_initial_strain(t);
      }
    if (yields(body.materials[t]))
      {
        ConicBlock               block(values.size());
        const FullMatrix<double> identity{IdentityMatrix(values.size())};
        const auto               weights = local(t).weights();
        add_yield_conditions(block,
                             stress_matrix<dim>(body.materials[t]),
                             identity,
                             weights,
                             /* radius = */ 1.);
        if (body.has_friction())
          add_friction<dim>(block,
                            identity,
                            weights,
                            std::vector<double>(weights.size(), 0.),
                            usable_part(t) * body.friction_slopes[t]);
        LocalAlgebra::add_transposed_product(all.begin(), block.cone_matrix, z);
      }

    Vector<double> of_element(Element::n_values(degree));
    for (unsigned int p = 0; p < Element::n_points(degree); ++p)
      {
        const double *const of_point = &all[n_components * p];
        for (unsigned int c = 0; c < Element::n_components; ++c)
          of_element[Element::n_components * p + c] = of_point[c];
        if (out_of_plane == OutOfPlane::mean)
          {
            const auto weights = weights_out_of_plane(body.materials[t]);
            for (unsigned int c = 0; c < weights.size(); ++c)
              of_element[Element::n_components * p + c] +=
                weights[c] * of_point[3];
          }
      }
    return of_element;
  }



  // For all stresses tau of the simplex, with the traces w of the displacement
  // on its faces,
  //   (strain, tau) + (u_h, div tau) - <w, tau n> = 0.
  // Of these (in the plane at most 15 or 36) equations, those of the unknowns
  // have been solved; least squares take out of the others the moments of u_h
  // for the coefficients of div tau, and thus its means over the parts. With
  // the sum s of a linear function at the n corners, which that of its means is
  // also, the mean over a part is (s + s / n - u) / n if u is the value at the
  // corner opposite to the part's face.
  template <int dim>
  std::array<Tensor<1, dim>, dim + 1>
  StressProgram<dim>::displacement_of(const unsigned int    t,
                                      const Vector<double> &strain_moments,
                                      const Vector<double> &y) const
  {
    constexpr unsigned int   n_corners = dim + 1;
    const auto               corners   = body.corners_of(t);
    const FullMatrix<double> shapes    = local(t).basis();
    const unsigned int       n         = Element::n_divergences(degree);
    FullMatrix<double>       divergence(n, shapes.n());
    Element::divergence_matrix(corners, degree).mmult(divergence, shapes);
    divergence *= volume(corners) / (n_corners * body.length_unit);

    Vector<double> moments = strain_moments;
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto [functional, value] = point_force(t, k, i, c);
            const double factor =
              multiplier({body.mesh.simplices[t].faces[k], i}, c, y);
            for (unsigned int e = 0; e < Element::n_components; ++e)
              moments[Element::n_components * value + e] +=
                factor * functional[e];
          }
    Vector<double> residual(shapes.n());
    shapes.Tvmult(residual, moments);

    FullMatrix<double> normal_matrix(n, n);
    divergence.mTmult(normal_matrix, divergence);
    normal_matrix.gauss_jordan();
    Vector<double> weighted(n), of_coefficients(n);
    divergence.vmult(weighted, residual);
    normal_matrix.vmult(of_coefficients, weighted);

    std::array<Tensor<1, dim>, n_corners> means;
    Tensor<1, dim>                        sum;
    for (unsigned int i = 0; i < n; ++i)
      means[i / (n / n_corners)][i % dim] -=
        body.strain_unit * body.length_unit * of_coefficients[i];
    for (const auto &mean : means)
      sum += mean;
    std::array<Tensor<1, dim>, n_corners> at_corners;
    for (unsigned int k = 0; k < n_corners; ++k)
      at_corners[opposite_corner<dim>(k)] =
        (n_corners + 1.) / n_corners * sum - double(n_corners) * means[k];
    return at_corners;
  }
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "stress_program_energy.cc"
#include "stress_program_faces.cc"

namespace ElastoPlastic
{
  template class StressProgram<2>;
  template class StressProgram<3>;
} // namespace ElastoPlastic
