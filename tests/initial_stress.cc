// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The initial stress of a body on distorted cells with hanging nodes and two
// materials, for all measures of strain: where it is not deformed, it bears
// that stress and has no energy; forces are derivatives of the energy, and the
// tangent is their derivative, with plastic flow; a finite rotation turns
// forces and stresses; what is added to the stress is the elastic response; a
// new mesh bears none.

#include <deal.II/base/function_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include "base/compatibility.h"
#include "material/material_parameters.h"
#include "mechanics/solid_operator.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  MaterialParameters
  two_materials()
  {
    MaterialParameters parameters;
    parameters.laws             = {MaterialLaw::isotropic_hardening,
                                   MaterialLaw::combined_hardening};
    parameters.young_moduli     = {2., 3.};
    parameters.poisson_ratios   = {0.3, 0.4};
    parameters.yield_stresses   = {0.2, 0.4};
    parameters.isotropic_moduli = {0.1};
    parameters.kinematic_moduli = {0.2};
    return parameters;
  }



  /// That of a point, in directions of its own.
  InitialStressParameters
  waves(const StrainModel &strain_model, const unsigned int dim)
  {
    InitialStressParameters stress;
    stress.components = {
      {"0.1*sin(3*x)", "0.05 + 0.05*y", "0.03*x*y", "0.04*cos(2*y)", "", ""}};
    if (strain_model.kinematics == Kinematics::plane_stress)
      stress.components[2].clear();
    if (dim == 3)
      {
        stress.components[4] = "0.02*z";
        stress.components[5] = "0.03*cos(x)";
      }
    return stress;
  }



  template <int dim>
  FunctionFromFunctionObjects<dim>
  vector_function(
    const std::function<Tensor<1, dim>(const Point<dim> &)> &function)
  {
    std::vector<std::function<double(const Point<dim> &)>> components;
    for (unsigned int d = 0; d < dim; ++d)
      components.push_back(
        [function, d](const Point<dim> &x) { return function(x)[d]; });
    return FunctionFromFunctionObjects<dim>(components);
  }



  /// By an angle with this cosine and sine, about the last axis.
  template <int dim>
  Tensor<1, dim>
  turned(const Tensor<1, dim> &v, const double cosine, const double sine)
  {
    Tensor<1, dim> result = v;
    result[0]             = cosine * v[0] - sine * v[1];
    result[1]             = sine * v[0] + cosine * v[1];
    return result;
  }



  template <int dim>
  class Body
  {
  public:
    Body(const unsigned int degree, const StrainModel &strain_model)
      : strain_model(strain_model)
      , stress(waves(strain_model, dim), strain_model.kinematics)
      , mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , solid(degree, strain_model, two_materials().materials())
    {
      make_distorted_mesh(mesh);
      if (strain_model.kinematics == Kinematics::axisymmetric)
        GridTools::shift(Point<dim>::unit_vector(0), mesh);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      solid.reinit(dof_handler, constraints);
      solid.initialize_vector(zero);
    }

    void
    check()
    {
      solid.linearize(zero);
      check_sum();
      solid.set_initial_stress(stress);
      check_rest();
      if (strain_model.is_finite() &&
          strain_model.kinematics == Kinematics::cartesian)
        check_rotation();
      check_derivatives();
      solid.reinit(dof_handler, constraints);
      verify("  on a new mesh, there is none", forces(zero).linfty_norm(), 0.);
    }

  private:
    VectorType
    field(const unsigned int number, const double size) const
    {
      VectorType vector = zero;
      VectorTools::interpolate(dof_handler,
                               SampleField<dim>(number, size),
                               vector);
      constraints.distribute(vector);
      return vector;
    }

    VectorType
    forces(const VectorType &displacement) const
    {
      VectorType result = zero;
      solid.internal_forces(result, displacement);
      return result;
    }

    VectorType
    tangent_product(const VectorType &increment) const
    {
      VectorType result = zero;
      solid.vmult(result, increment);
      return result;
    }

    double
    relative_difference(VectorType a, const VectorType &b) const
    {
      a -= b;
      constraints.set_zero(a);
      return a.l2_norm() / b.l2_norm();
    }

    /// (The strain of a small displacement is small, to its square.)
    void
    check_sum()
    {
      InitialStressParameters none;
      none.components[0] = "0";
      solid.set_initial_stress(
        InitialStress<dim>(none, strain_model.kinematics));
      const VectorType w = field(2, 1e-6);
      solid.add_to_initial_stress(w);
      verify("  the response that is added is elastic",
             relative_difference(forces(zero), tangent_product(w)),
             strain_model.is_finite() ? 1e-4 : 1e-12);
      const double work = w * tangent_product(w);
      verify("  and has the elastic energy",
             std::abs(2. * solid.initial_stress_size().energy / work - 1.),
             strain_model.is_finite() ? 1e-4 : 1e-12);
    }

    void
    check_rest() const
    {
      const QGauss<dim> quadrature(fe.degree + 1);
      FEValues<dim>     values(fe, quadrature, update_quadrature_points);
      double            difference = 0, size = 0;
      solid.for_each_cell(zero, [&](const auto &cell, const auto &points) {
        values.reinit(cell);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const auto given = stress.value(values.quadrature_point(q));
            difference       = std::max({difference,
                                         (points[q].stress - given).norm(),
                                         points[q].strain.norm(),
                                         std::abs(points[q].elastic_energy)});
            size             = std::max(size, given.norm());
          }
      });
      verify("  at rest, the body bears it, without strain and energy",
             difference / size,
             1e-14);
      verify("  the sum of all energies is zero",
             std::abs(solid.energy(zero)),
             1e-15);
    }

    void
    check_rotation() const
    {
      const double c = std::cos(0.5), s = std::sin(0.5);
      VectorType   rotation = zero;
      VectorTools::interpolate(dof_handler,
                               vector_function<dim>(
                                 [c, s](const Point<dim> &x) {
                                   return turned<dim>(x, c, s) - x;
                                 }),
                               rotation);
      constraints.distribute(rotation);
      const auto waves = [](const Point<dim> &x) {
        Tensor<1, dim> v;
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = std::sin(1. + d + 3. * x[0] + 2. * x[d]);
        return v;
      };
      VectorType w = zero, turned_w = zero;
      VectorTools::interpolate(dof_handler, vector_function<dim>(waves), w);
      VectorTools::interpolate(dof_handler,
                               vector_function<dim>([&](const Point<dim> &x) {
                                 return turned<dim>(waves(x), c, s);
                               }),
                               turned_w);
      constraints.distribute(w);
      constraints.distribute(turned_w);
      const double before = forces(zero) * w,
                   after  = forces(rotation) * turned_w;
      verify("  a rotation turns the forces",
             std::abs(after / before - 1.),
             1e-11);
      verify("  and stores no energy", std::abs(solid.energy(rotation)), 1e-14);
    }

    void
    check_derivatives()
    {
      const VectorType u = field(0, 0.1), w = field(2, 1.);
      const auto       moved = [&](const double factor) {
        VectorType result = u;
        result.add(factor, w);
        return result;
      };
      const double step = 1e-5;
      const double work = forces(u) * w;
      verify("  forces are the derivative of the energy",
             std::abs((solid.energy(moved(step)) - solid.energy(moved(-step))) /
                        (2 * step) / work -
                      1.),
             1e-6);
      solid.predict_flow(u, u);
      solid.linearize(u);
      VectorType quotient = forces(moved(step));
      quotient -= forces(moved(-step));
      quotient /= 2 * step;
      verify("  tangent is the derivative of the forces",
             relative_difference(quotient, tangent_product(w)),
             2 * PackedDeviator<dim>::largest_turn);
    }

    const StrainModel                         strain_model;
    const InitialStress<dim>                  stress;
    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    SolidOperator<dim>                        solid;
    VectorType                                zero;
  };



  template <int dim>
  void
  check(const unsigned int degree, const StrainModel &strain_model)
  {
    output()
      << dim << "D, degree " << degree << ", "
      << (strain_model.is_finite() ? "logarithmic" : "small")
      << (strain_model.treatment == VolumetricTreatment::b_bar ? ", B-bar" : "")
      << (strain_model.kinematics == Kinematics::axisymmetric ? ", revolution" :
          strain_model.kinematics == Kinematics::plane_stress ? ", sheet" :
                                                                "")
      << std::endl;
    Body<dim>(degree, strain_model).check();
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Strain strain : {Strain::small, Strain::logarithmic})
    {
      check<2>(1, {VolumetricTreatment::b_bar, Kinematics::cartesian, strain});
      check<2>(
        2, {VolumetricTreatment::standard, Kinematics::axisymmetric, strain});
      check<2>(1,
               {VolumetricTreatment::b_bar, Kinematics::axisymmetric, strain});
      check<2>(
        1, {VolumetricTreatment::standard, Kinematics::plane_stress, strain});
      check<3>(1, {VolumetricTreatment::b_bar, Kinematics::cartesian, strain});
    }
}
