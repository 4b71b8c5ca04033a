// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "equilibrium/integration.h"
#include "equilibrium/interior_point.h"
#include "equilibrium/side_support.h"
#include "equilibrium/stream_element.h"
#include "equilibrium/stream_program.h"

namespace ElastoPlastic
{
  namespace
  {
    using Bernstein::n_cubics;

    constexpr double work_tolerance = 1e-6;

    /// Relative to the largest of their kind: coefficients that vanish on the
    /// axis.
    constexpr double relative_zero = 1e-12;

    constexpr unsigned int held = numbers::invalid_unsigned_int;



    /// Coefficients that do not vanish on the axis.
    std::vector<unsigned int>
    non_zero_rows(const FullMatrix<double> &matrix)
    {
      std::vector<unsigned int> rows;
      const double              largest = matrix.linfty_norm();
      for (unsigned int i = 0; i < matrix.m(); ++i)
        if (std::any_of(&matrix(i, 0),
                        &matrix(i, 0) + matrix.n(),
                        [&](const double entry) {
                          return std::abs(entry) > relative_zero * largest;
                        }))
          rows.push_back(i);
      return rows;
    }



    /// What a triangle contributes to the dual of the minimisation: unknowns
    /// x, and their power as linear functions of the velocity, which are given
    /// by their coefficients for the local functions.
    class LocalProgram
    {
    public:
      explicit LocalProgram(const unsigned int n_functions)
        : n_functions(n_functions)
      {}

      /// The cost limit times |e| with the components e in the @p rows of a
      /// matrix from @p begin on, less @p offset (x, |x| <= limit, its dual).
      void
      add_norm(const FullMatrix<double> &rows,
               const unsigned int        begin,
               const unsigned int        n_rows,
               const double              weight,
               const double              limit,
               const double              offset = 0.)
      {
        for (unsigned int i = begin; i < begin + n_rows; ++i)
          add_unknown(rows, i, weight, weight * offset);
        norms.push_back({n_rows, limit});
      }

      /// The condition that a row is @p bound at most (a force x >= 0).
      void
      add_condition(const FullMatrix<double> &rows,
                    const unsigned int        row,
                    const double              weight,
                    const double              bound)
      {
        add_unknown(rows, row, weight, weight * bound);
        norms.push_back({0, 0.});
      }

      /// A matrix whose last three columns are those of the velocity of side
      /// @p k.
      FullMatrix<double>
      with_columns_of_side(const FullMatrix<double> &matrix,
                           const unsigned int        k) const
      {
        FullMatrix<double> result(matrix.m(), n_functions);
        for (unsigned int i = 0; i < matrix.m(); ++i)
          for (unsigned int j = 0; j < matrix.n(); ++j)
            result(i,
                   j + 3 < matrix.n() ? j :
                                        n_functions - 9 + 3 * k + j + 3 -
                                          matrix.n()) = matrix(i, j);
        return result;
      }

      /// The block whose couplings are to the @p equations of the local
      /// functions.
      ConicBlock
      block(const std::vector<unsigned int> &equations) const
      {
        ConicBlock result(costs.size());
        std::copy(costs.begin(), costs.end(), result.linear_cost.begin());
        add_cones(result);
        std::map<unsigned int, Vector<double>> rows;
        for (unsigned int f = 0; f < n_functions; ++f)
          if (equations[f] != held)
            {
              auto &row =
                rows.try_emplace(equations[f], costs.size()).first->second;
              for (unsigned int i = 0; i < costs.size(); ++i)
                row[i] += powers[i][f];
            }
        for (const auto &[equation, row] : rows)
          result.add_to_equation(equation, row);
        return result;
      }

    private:
      struct Norm
      {
        unsigned int n_components; ///< 0: of a condition
        double       limit;
      };

      void
      add_unknown(const FullMatrix<double> &rows,
                  const unsigned int        row,
                  const double              weight,
                  const double              cost)
      {
        std::vector<double> &power = powers.emplace_back(n_functions);
        for (unsigned int f = 0; f < rows.n(); ++f)
          power[f] = weight * rows(row, f);
        costs.push_back(cost);
      }

      void
      add_cones(ConicBlock &result) const
      {
        unsigned int n_rows = 0, row = 0, unknown = 0;
        for (const Norm &norm : norms)
          n_rows += 1 + norm.n_components;
        result.cone_matrix.reinit(n_rows, costs.size());
        result.cone_offset.reinit(n_rows);
        for (const auto &[n_components, limit] : norms)
          {
            result.cone_sizes.push_back(1 + n_components);
            result.cone_offset[row] = limit;
            if (n_components == 0)
              result.cone_matrix(row, unknown++) = -1.;
            ++row;
            for (unsigned int c = 0; c < n_components; ++c)
              result.cone_matrix(row++, unknown++) = -1.;
          }
        result.cone_scales.resize(norms.size());
      }

      const unsigned int               n_functions;
      std::vector<std::vector<double>> powers; ///< by unknowns
      std::vector<double>              costs;
      std::vector<Norm>                norms;
    };



    /// Its unknowns: the coefficients of psi in plane strain, or of chi and phi
    /// in a body of revolution; and velocities of the sides inside, so that
    /// each of two neighbours pays for how it slides along their side: that
    /// adds up to what both pay with the smaller of their yield stresses.
    class StreamProgram
    {
    public:
      explicit StreamProgram(const PlaneBody &body);

      VelocityField
      solve() const;

    private:
      void
      find_flux();
      void
      number_equations();
      void
      close_side(boost::disjoint_sets_with_storage<> &sets,
                 const unsigned int                   side) const;
      void
      add_block(const unsigned int triangle);
      void
      add_side(LocalProgram        &program,
               const StreamElement &element,
               const unsigned int   triangle,
               const unsigned int   k) const;
      void
      add_tractions(const StreamElement             &element,
                    const std::vector<unsigned int> &equations,
                    const unsigned int               triangle,
                    const unsigned int               k);

      /// Those of the local functions, the last being three for each side's
      /// velocity.
      std::vector<unsigned int>
      unknowns_of(const unsigned int triangle) const;

      unsigned int
      cubic(const unsigned int side,
            const unsigned int first_vertex,
            const unsigned int i) const;

      bool
      has_flux(const unsigned int triangle) const;

      const PlaneBody  &body;
      std::vector<bool> vertex_has_flux;

      // The first unknown of each kind; and their equations, if they are free.
      unsigned int first_on_sides, first_inside, first_flux, first_velocity,
        n_unknowns;
      std::vector<unsigned int> equations;
      ConicProgram              program;
      double                    work_unit;
    };



    StreamProgram::StreamProgram(const PlaneBody &body)
      : body(body)
      , first_on_sides(body.mesh.vertices.size())
      , first_inside(first_on_sides + 2 * body.mesh.sides.size())
      , first_flux(first_inside + body.mesh.triangles.size())
      , first_velocity(first_flux + body.mesh.vertices.size())
      , n_unknowns(first_velocity + 3 * body.mesh.sides.size())
      , work_unit(body.stress_unit * body.length_unit * body.weight_unit())
    {
      find_flux();
      number_equations();
      for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
        add_block(t);
    }



    // There is none in plane strain, nor at triangles that touch the axis.
    void
    StreamProgram::find_flux()
    {
      vertex_has_flux.assign(body.mesh.vertices.size(), body.is_axisymmetric());
      for (const auto &triangle : body.mesh.triangles)
        if (std::any_of(triangle.vertices.begin(),
                        triangle.vertices.end(),
                        [&](const unsigned int v) {
                          return body.is_on_axis(body.mesh.vertices[v]);
                        }))
          for (const unsigned int v : triangle.vertices)
            vertex_has_flux[v] = false;
    }



    bool
    StreamProgram::has_flux(const unsigned int t) const
    {
      const auto &vertices = body.mesh.triangles[t].vertices;
      return std::any_of(vertices.begin(),
                         vertices.end(),
                         [this](const unsigned int v) {
                           return vertex_has_flux[v];
                         });
    }



    /// The coefficient on a side that is the @p i th from this end on.
    unsigned int
    StreamProgram::cubic(const unsigned int s,
                         const unsigned int first_vertex,
                         const unsigned int i) const
    {
      const auto        &vertices = body.mesh.sides[s].vertices;
      const unsigned int k        = vertices[0] == first_vertex ? i : 3 - i;
      return k == 0 ? vertices[0] :
             k == 3 ? vertices[1] :
                      first_on_sides + 2 * s + k - 1;
    }



    // Nothing moves through a side if the stream function is constant there.
    // r^2 chi is where r is, if chi is; elsewhere if it vanishes.
    void
    StreamProgram::close_side(boost::disjoint_sets_with_storage<> &sets,
                              const unsigned int                   s) const
    {
      const auto    &vertices = body.mesh.sides[s].vertices;
      const Point<2> a        = body.mesh.vertices[vertices[0]],
                     b        = body.mesh.vertices[vertices[1]];
      if (body.is_on_axis(a) && body.is_on_axis(b))
        return;
      const unsigned int known   = n_unknowns;
      const bool         is_zero = std::abs(body.weight(a) - body.weight(b)) >
                           relative_zero * a.distance(b);
      for (unsigned int i = 0; i < 4; ++i)
        sets.union_set(cubic(s, vertices[0], i), is_zero ? known : vertices[0]);
      sets.union_set(first_flux + vertices[0], first_flux + vertices[1]);
    }



    // Zero is one more unknown. The stream function is known up to a constant:
    // it vanishes on the axis, or else in the first vertex.
    void
    StreamProgram::number_equations()
    {
      const unsigned int                  known = n_unknowns;
      boost::disjoint_sets_with_storage<> sets(n_unknowns + 1);
      for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
        {
          if (support_of(body, s).is_closed)
            close_side(sets, s);
          if (body.mesh.sides[s].boundary_id !=
              numbers::internal_face_boundary_id)
            for (unsigned int i = 0; i < 3; ++i)
              sets.union_set(first_velocity + 3 * s + i, known);
        }
      for (unsigned int v = 0; v < body.mesh.vertices.size(); ++v)
        if (!vertex_has_flux[v])
          sets.union_set(first_flux + v, known);
      if (!body.is_axisymmetric())
        sets.union_set(0u, known);
      else if (std::find(vertex_has_flux.begin(),
                         vertex_has_flux.end(),
                         false) == vertex_has_flux.end())
        sets.union_set(first_flux, known);

      std::map<unsigned int, unsigned int> numbers;
      for (unsigned int i = 0; i < n_unknowns; ++i)
        equations.push_back(
          sets.find_set(i) == sets.find_set(known) ?
            held :
            numbers.try_emplace(sets.find_set(i), numbers.size())
              .first->second);
      program.right_hand_side.reinit(numbers.size());
    }



    std::vector<unsigned int>
    StreamProgram::unknowns_of(const unsigned int t) const
    {
      const auto               &triangle = body.mesh.triangles[t];
      std::vector<unsigned int> result(triangle.vertices.begin(),
                                       triangle.vertices.end());
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 1; i < 3; ++i)
          result.push_back(cubic(triangle.sides[k], triangle.vertices[k], i));
      result.push_back(first_inside + t);
      if (has_flux(t))
        for (const unsigned int v : triangle.vertices)
          result.push_back(first_flux + v);
      for (unsigned int k = 0; k < 3; ++k)
        {
          const unsigned int s = triangle.sides[k];
          const bool         same_direction =
            body.mesh.sides[s].vertices[0] == triangle.vertices[k];
          for (unsigned int i = 0; i < 3; ++i)
            result.push_back(first_velocity + 3 * s +
                             (same_direction ? i : 2 - i));
        }
      return result;
    }



    void
    StreamProgram::add_block(const unsigned int t)
    {
      const StreamElement element(body, t, has_flux(t));
      const auto          unknowns = unknowns_of(t);
      LocalProgram        local(unknowns.size());
      const double limit = body.materials[t].yield_radius / body.stress_unit;
      const auto [rates, weights] = element.rates();
      const unsigned int n        = element.n_rate_components();
      for (unsigned int p = 0; p < weights.size(); ++p)
        local.add_norm(
          rates, n * p, n, weights[p] / (work_unit / body.stress_unit), limit);

      std::vector<unsigned int> rows;
      for (const unsigned int unknown : unknowns)
        rows.push_back(equations[unknown]);
      for (unsigned int k = 0; k < 3; ++k)
        {
          add_side(local, element, t, k);
          add_tractions(element, rows, t, k);
        }
      program.blocks.push_back(local.block(rows));
    }



    void
    StreamProgram::add_side(LocalProgram        &local,
                            const StreamElement &element,
                            const unsigned int   t,
                            const unsigned int   k) const
    {
      const unsigned int s       = body.mesh.triangles[t].sides[k];
      const auto        &side    = body.mesh.sides[s];
      const SideSupport  support = support_of(body, s);
      const Tensor<1, 2> tangent = -cross_product_2d(body.mesh.normal(side));
      const auto         weights = element.weights_on_side(k);
      const double       weight =
        body.mesh.length(side) / weights.size() * body.stress_unit / work_unit;
      const double limit = std::sqrt(0.5) * body.materials[t].yield_radius /
                           body.stress_unit; // yields in shear

      if (side.boundary_id == numbers::internal_face_boundary_id)
        {
          const auto slips =
            local.with_columns_of_side(element.slips_on_side(k, tangent), k);
          for (const unsigned int i : non_zero_rows(slips))
            local.add_norm(slips, i, 1, weight, limit);
        }
      if (support.resists_slip)
        {
          const auto slips = element.velocities_on_side(k, tangent);
          for (const unsigned int i : non_zero_rows(slips))
            local.add_norm(slips,
                           i,
                           1,
                           weight,
                           limit,
                           weights[i] * (support.velocity * tangent));
        }
      if (body.conditions[s].is_reached)
        {
          const auto &direction  = body.conditions[s].components[1].direction;
          const auto  velocities = element.velocities_on_side(k, direction);
          for (const unsigned int i : non_zero_rows(velocities))
            local.add_condition(velocities,
                                i,
                                1. / body.weight_unit(),
                                weights[i] * (support.velocity * direction));
        }
    }



    // Their power, for each of the local functions.
    void
    StreamProgram::add_tractions(const StreamElement             &element,
                                 const std::vector<unsigned int> &rows,
                                 const unsigned int               t,
                                 const unsigned int               k)
    {
      const auto        &triangle = body.mesh.triangles[t];
      const auto         corners  = body.mesh.corners(triangle);
      const unsigned int next     = (k + 1) % 3;
      for (const auto &component :
           body.conditions[triangle.sides[k]].components)
        if (component.type == SideConditionType::traction)
          integrate_on_side(
            corners[k],
            corners[next],
            [&](const double position, const Point<2> &x, const double weight) {
              Bernstein::Barycentric point = {};
              point[k]                     = 1. - position;
              point[next]                  = position;
              const double force = weight * corners[k].distance(corners[next]) *
                                   component.value(x) / work_unit;
              const auto velocities = element.weighted_velocities(point);
              for (unsigned int f = 0; f < velocities.size(); ++f)
                if (rows[f] != held)
                  program.right_hand_side[rows[f]] +=
                    force * (velocities[f] * component.direction);
            });
    }



    VelocityField
    StreamProgram::solve() const
    {
      const ConicSolution solution = minimize(program, work_tolerance);
      VelocityField       field;
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.is_optimal;
      for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
        {
          const StreamElement element(body, t, has_flux(t));
          const auto          unknowns = unknowns_of(t);
          Vector<double>      coefficients(element.n_functions());
          for (unsigned int f = 0; f < coefficients.size(); ++f)
            if (equations[unknowns[f]] != held)
              coefficients[f] = -solution.y[equations[unknowns[f]]];
          field.velocity.push_back(element.velocity(coefficients));
        }
      return field;
    }
  } // namespace



  VelocityField
  find_stream(const PlaneBody &body)
  {
    return StreamProgram(body).solve();
  }
} // namespace ElastoPlastic
