// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Two-step backward differentiation of the flow (SolidOperator::go_on()): the
// errors of a perfectly plastic body that is stretched to the yield surface and
// then sheared, against the exact solution, fall with the square of the step,
// also where steps are of different lengths; so do those of hardening and of
// creep, against many steps. The tangent is the derivative of the forces.
// States that are taken to another body, as after a checkpoint, go on alike;
// what does not flow stays as it is.

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>

#include "material/material_parameters.h"
#include "mechanics/solid_operator.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double young = 2., poisson = 0.3, yield_stress = 0.02;
  constexpr double shear_modulus = young / (2. * (1. + poisson));
  /// Of the strain, when it has grown by pure shear along the axes.
  constexpr double final_shear = 0.015;

  MaterialParameters
  perfect()
  {
    MaterialParameters result;
    result.laws           = {MaterialLaw::perfectly_plastic};
    result.young_moduli   = {young};
    result.poisson_ratios = {poisson};
    result.yield_stresses = {yield_stress};
    return result;
  }



  MaterialParameters
  hardening()
  {
    MaterialParameters result = perfect();
    result.laws               = {MaterialLaw::nonlinear_hardening};
    result.voce_stresses      = {yield_stress};
    result.voce_rates         = {50.};
    result.back_stress_moduli = {"0.5"};
    result.recovery_rates     = {"0"};
    return result;
  }



  MaterialParameters
  creeping()
  {
    MaterialParameters result     = perfect();
    result.rates.types            = {RateLawType::duvaut_lions};
    result.rates.relaxation_times = {0.3};
    return result;
  }



  /// A square of four cells in plane strain, the strain being the same in all.
  class Square
  {
  public:
    explicit Square(const MaterialParameters &material)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<2>(1), 2)
      , dof_handler(mesh)
      , solid(1, VolumetricTreatment::standard, material.materials())
    {
      GridGenerator::subdivided_hyper_cube(mesh, 2);
      dof_handler.distribute_dofs(fe);
      constraints.close();
      solid.keep_increments();
      solid.reinit(dof_handler, constraints);
      solid.initialize_vector(u);
    }

    /// A stretch @p e_x = - @p e_y, and the shear gamma = 2 @p e_xy.
    VectorType
    displacement(const double e_x, const double e_xy) const
    {
      VectorType result(u.get_partitioner());
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < 2; ++d)
              if (const auto i = cell->vertex_dof_index(v, d);
                  result.in_local_range(i))
                result(i) = d == 0 ? e_x * cell->vertex(v)[0] +
                                       2. * e_xy * cell->vertex(v)[1] :
                                     -e_x * cell->vertex(v)[1];
      return result;
    }

    /// The strain that the elastic body has at the yield surface.
    static double
    elastic_limit()
    {
      return yield_stress / std::sqrt(3.) / (2. * shear_modulus);
    }

    void
    stretch()
    {
      solid.begin_step(1.);
      u = displacement(elastic_limit(), 0.);
      solid.commit(u);
    }

    /// The next step of the shear, up to its part @p end.
    void
    begin_step_to(const double end)
    {
      const double duration = end - time;
      solid.begin_step(duration);
      if (time > 0. && two_steps)
        solid.go_on(duration, last_duration);
      last_duration = duration;
      time          = end;
      u             = displacement(elastic_limit(), final_shear * end);
    }

    /// Shears it in pairs of steps, of which the second ones are longer by the
    /// factor @p ratio.
    void
    shear(const unsigned int n_pairs, const double ratio)
    {
      stretch();
      for (unsigned int pair = 0; pair < n_pairs; ++pair)
        for (const double part : {1. / (1. + ratio), 1.})
          {
            begin_step_to((pair + part) / n_pairs);
            last_stress = stress();
            solid.commit(u);
          }
    }

    /// That of a point at the end of the step; the same at all of them.
    SymmetricTensor<2, 3>
    stress() const
    {
      SymmetricTensor<2, 3> sum;
      double                volume = 0;
      solid.for_each_cell(u, [&](const auto &, const auto &points) {
        for (const PointResult &point : points)
          {
            sum += point.volume * point.stress;
            volume += point.volume;
          }
      });
      return Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
             Utilities::MPI::sum(volume, MPI_COMM_WORLD);
    }

    SymmetricTensor<2, 3> last_stress;
    bool                  two_steps = true;

    parallel::distributed::Triangulation<2> mesh;
    const FESystem<2>                       fe;
    DoFHandler<2>                           dof_handler;
    AffineConstraints<double>               constraints;
    SolidOperator<2>                        solid;
    VectorType                              u;
    double                                  time = 0, last_duration = 0;
  };



  /// The exact stress: the angle psi between the stress and the direction of
  /// the shear e falls from pi / 2 with the rate 2 G |e'| sin(psi) / R, so that
  /// tan(psi / 2) is exp(-2 G |e| / R).
  SymmetricTensor<2, 3>
  exact_stress()
  {
    const double radius = std::sqrt(2. / 3.) * yield_stress;
    const double psi =
      2. * std::atan(std::exp(-2. * shear_modulus * std::sqrt(2.) *
                              final_shear / radius));
    SymmetricTensor<2, 3> result;
    result[0][1] = std::cos(psi) * radius / std::sqrt(2.);
    result[0][0] = std::sin(psi) * radius / std::sqrt(2.);
    result[1][1] = -result[0][0];
    return result;
  }



  double
  error(const MaterialParameters    &material,
        const SymmetricTensor<2, 3> &exact,
        const unsigned int           n_pairs,
        const double                 ratio,
        const bool                   two_steps)
  {
    Square square(material);
    square.two_steps = two_steps;
    square.shear(n_pairs, ratio);
    return (square.last_stress - exact).norm() / exact.norm();
  }



  /// Twice the steps leave a quarter of the error: the order 2, to 0.15.
  void
  check_order(const std::string           &name,
              const MaterialParameters    &material,
              const SymmetricTensor<2, 3> &exact)
  {
    for (const double ratio : {1., 2.})
      {
        const double coarse = error(material, exact, 40, ratio, true);
        const double fine   = error(material, exact, 80, ratio, true);
        verify(name + ", steps of lengths 1 and " + std::to_string(int(ratio)) +
                 ": order",
               std::abs(std::log2(coarse / fine) - 2.),
               0.15);
        verify("  less than a fifth of the error of backward Euler steps",
               coarse < 0.2 * error(material, exact, 40, ratio, false));
      }
  }



  SymmetricTensor<2, 3>
  stress_of_many_steps(const MaterialParameters &material)
  {
    Square square(material);
    square.shear(2000, 1.);
    return square.last_stress;
  }



  // Of a body that does not flow alike everywhere, in its second step.
  void
  check_tangent()
  {
    Square square(hardening());
    square.stretch();
    square.begin_step_to(0.3);
    square.solid.commit(square.u);
    square.begin_step_to(0.6);
    VectorType direction(square.u.get_partitioner());
    for (unsigned int i = 0; i < direction.locally_owned_size(); ++i)
      direction.local_element(i) =
        std::sin(1. + 3. * direction.get_partitioner()->local_to_global(i));
    square.u.add(1e-3, direction);

    SolidOperator<2> &solid = square.solid;
    solid.predict_flow(square.u, square.u);
    solid.linearize(square.u);
    VectorType product, forces, difference;
    for (VectorType *vector : {&product, &forces, &difference})
      solid.initialize_vector(*vector);
    solid.vmult(product, direction);

    const double step = 1e-6;
    VectorType   u    = square.u;
    u.add(step, direction);
    const double energy_after = solid.internal_forces(difference, u);
    u.add(-2. * step, direction);
    const double energy_before = solid.internal_forces(forces, u);
    difference -= forces;
    difference /= 2. * step;
    difference -= product;
    verify("the tangent is the derivative of the forces",
           difference.l2_norm() / product.l2_norm(),
           1e-4);
    solid.internal_forces(forces, square.u);
    const double work = forces * direction;
    verify("forces are the derivative of the energy",
           std::abs((energy_after - energy_before) / (2. * step) / work - 1.),
           1e-6);
  }



  // As after a checkpoint, or on another mesh.
  void
  check_other_body()
  {
    Square first(hardening()), second(hardening());
    first.stretch();
    for (const double end : {0.2, 0.5})
      {
        first.begin_step_to(end);
        first.solid.commit(first.u);
      }
    second.solid.set_states(first.solid.states());
    second.time          = first.time;
    second.last_duration = first.last_duration;
    for (Square *square : {&first, &second})
      square->begin_step_to(0.8);
    verify("states go on in another body",
           (first.stress() - second.stress()).norm() / first.stress().norm(),
           1e-14);

    for (Square *square : {&first, &first, &second})
      square->solid.commit(square->u);
    for (Square *square : {&first, &second})
      square->begin_step_to(1.);
    verify("where no time passes, nothing is forgotten",
           (first.stress() - second.stress()).norm() / first.stress().norm(),
           1e-12);
  }



  // Back by a part of the strain, and then, in another step, no further.
  void
  check_unloading()
  {
    Square square(perfect());
    square.stretch();
    for (const double end : {0.3, 0.6})
      {
        square.begin_step_to(end);
        square.solid.commit(square.u);
      }
    const double elastic_limit = Square::elastic_limit();
    const auto   unloaded =
      square.displacement(0.7 * elastic_limit,
                          0.6 * final_shear - 0.3 * elastic_limit);
    SymmetricTensor<2, 3> stresses[2];
    for (unsigned int i = 0; i < 2; ++i)
      {
        square.begin_step_to(square.time + 0.1);
        square.u    = unloaded;
        stresses[i] = square.stress();
        square.solid.commit(square.u);
      }
    const double radius = std::sqrt(2. / 3.) * yield_stress;
    verify("unloaded",
           stresses[0].norm() < 0.9 * radius &&
             stresses[0].norm() > 0.1 * radius);
    verify("what does not flow stays as it is",
           (stresses[1] - stresses[0]).norm() / radius,
           1e-14);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_order("perfectly plastic", perfect(), exact_stress());
  for (const auto &[name, material] :
       {std::pair("hardening", hardening()), std::pair("creep", creeping())})
    check_order(name, material, stress_of_many_steps(material));
  check_tangent();
  check_other_body();
  check_unloading();
}
