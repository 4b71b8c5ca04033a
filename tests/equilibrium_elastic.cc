// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The equilibrium method for elastic bodies against an exact solution, on
// meshes with hanging nodes: order of convergence, exact equilibrium, and the
// interpolation of the element.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <complex>
#include <limits>

#include "base/tensors.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "element_tractions.h"
#include "interpolated_stress.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

using Element = JohnsonMercier<2>;

namespace
{
  const double young = 200., poisson = 0.3;



  /// A plane elastic state by the formulas of Kolosov and Muskhelishvili, with
  /// the functions phi(z) = psi(z) = exp(z).
  struct ExactSolution
  {
    bool plane_stress;

    Tensor<1, 2>
    displacement(const Point<2> &p) const
    {
      const std::complex<double> z(p[0], p[1]), f = std::exp(z);
      const double               kappa =
        plane_stress ? (3. - poisson) / (1. + poisson) : 3. - 4. * poisson;
      const std::complex<double> u =
        (kappa * f - z * std::conj(f) - std::conj(f)) * (1. + poisson) / young;
      return Tensor<1, 2>({u.real(), u.imag()});
    }

    SymmetricTensor<2, 2>
    stress(const Point<2> &p) const
    {
      const std::complex<double> z(p[0], p[1]), f = std::exp(z);
      const double               sum        = 4. * f.real();
      const std::complex<double> difference = 2. * (std::conj(z) * f + f);
      SymmetricTensor<2, 2>      stress;
      stress[0][0] = 0.5 * (sum - difference.real());
      stress[1][1] = 0.5 * (sum + difference.real());
      stress[0][1] = 0.5 * difference.imag();
      return stress;
    }
  };



  /// A square, refined around its centre, with given displacements on all sides
  /// but the right one, where the tractions are given.
  SplitBody<2>
  make_body(const ExactSolution &exact, const unsigned int n_refinements)
  {
    Triangulation<2> triangulation;
    GridGenerator::hyper_cube(triangulation, 0., 1., true);
    triangulation.refine_global(1);
    refine_where(triangulation, [&](const auto &cell) {
      return cell->center()[0] < 0.5 && cell->center()[1] < 0.5;
    });
    triangulation.refine_global(n_refinements);

    SplitBody<2> body;
    body.mesh = make_split_mesh(triangulation);
    body.kinematics =
      exact.plane_stress ? Kinematics::plane_stress : Kinematics::cartesian;
    body.gap = [](const Point<2> &) {
      return 0.;
    };
    body.stress_unit = 1.;
    body.strain_unit = 1. / young;
    body.length_unit = 1.;
    for (const auto &side : body.mesh.faces)
      {
        FaceCondition<2> condition;
        for (unsigned int d = 0; d < 2; ++d)
          {
            auto &component     = condition.components[d];
            component.direction = Point<2>::unit_vector(d);
            component.type      = ConditionType::continuous;
            if (side.boundary_id == 1)
              {
                component.type  = ConditionType::traction;
                component.value = {[exact, d](const FacePoint<2> &p) {
                  return exact.stress(p.x)[0][d];
                }};
              }
            else if (side.boundary_id != numbers::internal_face_boundary_id)
              {
                component.type  = ConditionType::displacement;
                component.value = {[exact, d](const FacePoint<2> &p) {
                  return exact.displacement(p.x)[d];
                }};
              }
          }
        body.conditions.push_back(condition);
      }

    Material<double> material;
    material.bulk_modulus      = young / (3. * (1. - 2. * poisson));
    material.shear_modulus     = young / (2. * (1. + poisson));
    material.yield_radius      = std::numeric_limits<double>::infinity();
    material.isotropic_modulus = 0.;
    body.materials.assign(body.mesh.simplices.size(), material);
    return body;
  }



  /// The L2 norms of the error of the in-plane stress, of that out of plane,
  /// of the error of the interpolation, and of that of the displacement.
  std::array<double, 4>
  errors(const SplitBody<2>   &body,
         const ExactSolution  &exact,
         const StressField<2> &field)
  {
    const QGaussSimplex<2> quadrature(3);
    std::array<double, 4>  squares = {};
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        const auto corners = body.mesh.corners(body.mesh.simplices[t]);
        const auto stress  = [&](const Point<2> &p) {
          return exact.stress(p);
        };
        const Vector<double> interpolated = interpolate(corners, stress);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const auto subtriangle  = Element::part_of(corners, k);
            const auto displacement = on_part<2>(field.displacement[t], k);
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const auto                 &x     = quadrature.point(q);
                const std::array<double, 3> shape = {
                  {1. - x[0] - x[1], x[0], x[1]}};
                Point<2>              p;
                SymmetricTensor<2, 2> interpolation;
                SymmetricTensor<2, 3> stress_here;
                Tensor<1, 2>          u;
                for (unsigned int i = 0; i < 3; ++i)
                  {
                    p += shape[i] * subtriangle[i];
                    u += shape[i] * displacement[i];
                    stress_here += shape[i] * field.coefficient(t, k, i);
                    interpolation +=
                      shape[i] *
                      ElementTractions<2>::coefficient(interpolated, k, i);
                  }
                const auto   computed = in_plane<2>(stress_here);
                const double across   = stress_here[2][2];
                const auto   s        = exact.stress(p);
                const double w =
                  quadrature.weight(q) * 2. * volume(subtriangle);
                squares[0] += w * (computed - s).norm() * (computed - s).norm();
                squares[1] +=
                  w * std::pow(across -
                                 (exact.plane_stress ? 0. : poisson * trace(s)),
                               2);
                squares[2] +=
                  w * (interpolation - s).norm() * (interpolation - s).norm();
                squares[3] += w * (u - exact.displacement(p)).norm_square();
              }
          }
      }
    for (double &square : squares)
      square = std::sqrt(square);
    return squares;
  }



  void
  test_convergence(const bool plane_stress)
  {
    output() << (plane_stress ? "Plane stress" : "Plane strain") << std::endl;
    const ExactSolution   exact = {plane_stress};
    std::array<double, 4> last  = {};
    for (unsigned int k = 1; k <= 3; ++k)
      {
        const SplitBody<2>   body  = make_body(exact, k);
        const StressField<2> field = equilibrate_with_depth(body, 0.);
        const auto           error = errors(body, exact, field);

        // the tractions given on the right side are not linear
        StressErrors check   = check_stress(body, field);
        check.boundary_force = check.force_difference = 0;
        const double size = exact.stress(Point<2>(1., 0.)).norm();
        verify("in equilibrium", check.largest() / size, 1e-12);
        if (k > 1)
          {
            verify("order 2", std::log2(last[0] / error[0]) > 1.9);
            verify("order 2 out of plane",
                   plane_stress || std::log2(last[1] / error[1]) > 1.9);
            verify("order 2 of the interpolation",
                   std::log2(last[2] / error[2]) > 1.9);
            verify("order 2 of the displacement",
                   std::log2(last[3] / error[3]) > 1.9);
          }
        last = error;
      }
    verify("small error", last[0], 2e-3);
  }



  // pi_h has no divergence where the stress has none; with one that is
  // linear, the mean and the moments of the divergence are kept, J (4.5).
  void
  test_interpolation()
  {
    output() << "Interpolation" << std::endl;
    const Corners<2> triangle = {{Point<2>(0.3, -0.2), {2.1, 0.4}, {1.2, 1.7}}};
    const auto       divergence_of = [&](const auto &stress) {
      Vector<double> divergence(Element::n_divergences(1));
      Element::divergence_matrix(triangle, 1)
        .vmult(divergence, interpolate(triangle, stress));
      return divergence;
    };

    // Airy's function x^2 y^3
    verify("no divergence",
           divergence_of([](const Point<2> &p) {
             SymmetricTensor<2, 2> stress;
             stress[0][0] = 6. * p[0] * p[0] * p[1];
             stress[1][1] = 2. * std::pow(p[1], 3);
             stress[0][1] = -6. * p[0] * p[1] * p[1];
             return stress;
           }).linfty_norm(),
           1e-11);

    // stresses x^2, y^2, x y have the divergence (3 x, 3 y)
    const Vector<double>   divergence = divergence_of([](const Point<2> &p) {
      SymmetricTensor<2, 2> stress;
      stress[0][0] = p[0] * p[0];
      stress[1][1] = p[1] * p[1];
      stress[0][1] = p[0] * p[1];
      return stress;
    });
    double                 mean_error = 0, moment_error = 0;
    const QGaussSimplex<2> quadrature(3);
    for (unsigned int c = 0; c < 2; ++c)
      {
        Tensor<1, 2> moment;
        double       mean = 0;
        for (unsigned int k = 0; k < 3; ++k)
          {
            const auto subtriangle = Element::part_of(triangle, k);
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const auto    &x = quadrature.point(q);
                const Point<2> p = subtriangle[0] +
                                   x[0] * (subtriangle[1] - subtriangle[0]) +
                                   x[1] * (subtriangle[2] - subtriangle[0]);
                const double w = quadrature.weight(q) * 2. *
                                 volume(subtriangle) *
                                 (divergence[2 * k + c] - 3. * p[c]);
                mean += w;
                moment += w * Tensor<1, 2>(p);
              }
          }
        mean_error   = std::max(mean_error, std::abs(mean));
        moment_error = std::max(moment_error, moment.norm());
      }
    verify("mean of the divergence", mean_error, 1e-12);
    verify("moments of the divergence", moment_error, 1e-12);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_convergence(false);
  test_convergence(true);
  test_interpolation();
}
