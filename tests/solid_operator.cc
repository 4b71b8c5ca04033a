// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The deformable body on distorted cells with hanging nodes and two materials,
// virgin and with a history, in space, in plane strain and as a body of
// revolution:
// forces are derivatives of the energy, the tangent is the derivative of the
// forces, and matrix and diagonal are those of the tangent. The same, but for
// the energy, with back stresses that recover; with other yield criteria; and
// all of it with logarithmic strains.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include <iomanip>

#include "base/compatibility.h"
#include "mechanics/rigid_body_modes.h"
#include "mechanics/solid_operator.h"
#include "sample_body_materials.h"
#include "sample_mesh.h"
#include "solver/tangent_preconditioner.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  class Body
  {
  public:
    Body(const unsigned int        degree,
         const StrainModel        &strain_model,
         const MaterialParameters &materials)
      : strain_model(strain_model)
      , mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
      , solid(std::make_unique<SolidOperator<dim>>(degree,
                                                   strain_model,
                                                   materials.materials()))
    {
      make_distorted_mesh(mesh);
      if (is_axisymmetric())
        GridTools::shift(Point<dim>::unit_vector(0), mesh);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      solid->reinit(dof_handler, constraints);
    }

    void
    check()
    {
      u = field(0, 0.2);
      v = field(1, 1.);
      w = field(2, 1.);
      solid->predict_flow(u, u);
      solid->linearize(u);

      check_points();
      if (solid->has_energy())
        check_energy();
      verify("  virtual work",
             std::abs(solid->virtual_work(u, w) / (forces(u) * w) - 1.),
             1e-12);
      check_tangent();
      check_matrix();
      check_constrained_unknowns();
      if (virgin)
        check_rigid_motions();
    }

    /// Ends a load step with another displacement.
    void
    commit()
    {
      const VectorType old_u  = field(2, 0.15);
      const VectorType before = forces(old_u);
      solid->commit(old_u);
      virgin = false;
      verify("  the end of a step changes no stress",
             relative_difference(forces(old_u), before),
             1e-12);
    }

  private:
    bool
    is_axisymmetric() const
    {
      return strain_model.kinematics == Kinematics::axisymmetric;
    }

    VectorType
    new_vector() const
    {
      VectorType vector;
      solid->initialize_vector(vector);
      return vector;
    }

    VectorType
    field(const unsigned int number, const double size) const
    {
      VectorType vector = new_vector();
      VectorTools::interpolate(dof_handler,
                               SampleField<dim>(number, size),
                               vector);
      constraints.distribute(vector);
      return vector;
    }

    VectorType
    forces(const VectorType &displacement) const
    {
      VectorType result = new_vector();
      solid->internal_forces(result, displacement);
      return result;
    }

    VectorType
    tangent_product(const VectorType &increment) const
    {
      VectorType result = new_vector();
      solid->vmult(result, increment);
      return result;
    }

    /// u + factor * w
    VectorType
    moved(const double factor) const
    {
      VectorType result = u;
      result.add(factor, w);
      return result;
    }

    /// |a - b| / |b|, but for the unknowns that follow others.
    double
    relative_difference(VectorType a, const VectorType &b) const
    {
      a -= b;
      constraints.set_zero(a);
      return a.l2_norm() / b.l2_norm();
    }

    void
    check_points() const
    {
      double volume = 0, plastic_volume = 0;
      solid->for_each_cell(u, [&](const auto &, const auto &points) {
        for (const PointResult &point : points)
          {
            volume += point.volume;
            if (point.plastic)
              plastic_volume += point.volume;
          }
      });
      const double plastic_fraction =
        Utilities::MPI::sum(plastic_volume, MPI_COMM_WORLD) /
        Utilities::MPI::sum(volume, MPI_COMM_WORLD);
      output() << "  energy " << solid->energy(u) << ", plastic "
               << plastic_fraction << std::endl;
    }

    void
    check_energy() const
    {
      const double step = 1e-5;
      const double work = forces(u) * w;
      const double quotient =
        (solid->energy(moved(step)) - solid->energy(moved(-step))) / (2 * step);
      verify("  forces are the derivative of the energy",
             std::abs(quotient - work) / std::abs(work),
             1e-6);
    }

    void
    check_tangent() const
    {
      const double step     = 1e-6;
      VectorType   quotient = forces(moved(step));
      quotient -= forces(moved(-step));
      quotient /= 2 * step;
      verify("  tangent is the derivative of the forces",
             relative_difference(quotient, tangent_product(w)),
             PackedDeviator<dim>::largest_turn);
      const double asymmetry =
        std::abs(v * tangent_product(w) - w * tangent_product(v)) /
        tangent_product(w).l2_norm();
      if (solid->has_energy())
        verify("  tangent is symmetric", asymmetry, 1e-12);
      else
        output() << "  tangent is "
                 << (asymmetry > 1e-6 ? "unsymmetric" : "symmetric")
                 << std::endl;
    }

    void
    check_matrix() const
    {
      TangentMatrix<dim> tangent;
      tangent.reinit(dof_handler, constraints);
      tangent.assemble(*solid, {new_vector(), new_vector()});

      VectorType product = new_vector();
      tangent.matrix().vmult(product, w);
      verify("  matrix is the tangent",
             relative_difference(product, tangent_product(w)),
             1e-12);

      VectorType diagonal, matrix_diagonal = new_vector();
      solid->diagonal(diagonal);
      for (const auto i : dof_handler.locally_owned_dofs())
        matrix_diagonal(i) = tangent.matrix().diag_element(i);
      // (an approximation at the masters of hanging nodes)
      for (const auto &line : constraints.get_lines())
        for (const auto &[master, weight] : line.entries)
          if (diagonal.in_local_range(master))
            matrix_diagonal(master) = diagonal(master);
      verify("  diagonal is that of the matrix",
             relative_difference(diagonal, matrix_diagonal),
             1e-12);
    }

    /// Every seventh unknown is held.
    void
    check_constrained_unknowns() const
    {
      VectorType held = new_vector(), increment = w;
      for (const auto i : dof_handler.locally_owned_dofs())
        if (i % 7 == 0 && !constraints.is_constrained(i))
          {
            held(i)      = 1.;
            increment(i) = 0.;
          }
      constraints.distribute(increment);

      TangentMatrix<dim> tangent;
      tangent.reinit(dof_handler, constraints);
      tangent.assemble(*solid, {held, new_vector()});
      VectorType product = new_vector(), expected = tangent_product(increment);
      tangent.matrix().vmult(product, increment);
      for (const auto i : dof_handler.locally_owned_dofs())
        if (held(i) != 0.)
          expected(i) = 0.;
      verify("  held unknowns are eliminated from the matrix",
             relative_difference(product, expected),
             1e-12);
    }

    void
    check_rigid_motions() const
    {
      double error = 0;
      for (VectorType motion : rigid_body_modes(dof_handler, u))
        {
          constraints.distribute(motion);
          // (the modes are small rotations)
          if (is_axisymmetric() || strain_model.is_finite())
            motion = rigid_body_modes(dof_handler, u)[dim - 1];
          error =
            std::max(error, forces(motion).l2_norm() / forces(u).l2_norm());
        }
      verify("  rigid motions cause no forces", error, 1e-12);
    }

    const StrainModel                         strain_model;
    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    std::unique_ptr<SolidOperator<dim>>       solid;
    bool                                      virgin = true;

    /// The displacement, and two other fields.
    VectorType u, v, w;
  };



  template <int dim>
  void
  check_bodies(const Kinematics                 kinematics,
               const Strain                     strain,
               const MaterialParameters        &materials,
               const std::vector<unsigned int> &degrees)
  {
    for (const unsigned int degree : degrees)
      for (const auto treatment :
           {VolumetricTreatment::standard, VolumetricTreatment::b_bar})
        {
          StrainModel strain_model(treatment, kinematics, strain);
          strain_model.has_general_criteria = materials.criteria.are_general();
          if (kinematics == Kinematics::plane_stress &&
              (treatment == VolumetricTreatment::b_bar ||
               strain_model.has_general_criteria))
            continue;
          output()
            << dim << "D, p = " << degree << ", "
            << (treatment == VolumetricTreatment::b_bar ? "B-bar" : "standard")
            << (kinematics == Kinematics::axisymmetric ? ", axisymmetric" :
                kinematics == Kinematics::plane_stress ? ", plane stress" :
                                                         "")
            << (strain == Strain::logarithmic ? ", logarithmic strain" : "")
            << std::endl;
          Body<dim> body(degree, strain_model, materials);
          body.check();
          body.commit();
          body.check();
        }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << std::setprecision(10);
  // (laws and degrees do not know of each other)
  using Degrees = std::vector<unsigned int>;
  for (const auto &[name, materials, degrees] :
       {std::make_tuple("Linear hardening", linear_materials(), Degrees{1, 2}),
        std::make_tuple("Nonlinear hardening",
                        nonlinear_materials(),
                        Degrees{1}),
        std::make_tuple("Recovering back stresses",
                        recovering_materials(),
                        Degrees{1}),
        std::make_tuple("Other yield criteria",
                        materials_with_criteria(),
                        Degrees{1, 2})})
    {
      output() << name << std::endl;
      for (const auto strain : {Strain::small, Strain::logarithmic})
        {
          check_bodies<2>(Kinematics::cartesian, strain, materials, degrees);
          check_bodies<2>(Kinematics::axisymmetric, strain, materials, degrees);
          check_bodies<2>(Kinematics::plane_stress, strain, materials, degrees);
          check_bodies<3>(Kinematics::cartesian, strain, materials, degrees);
        }
    }
}
