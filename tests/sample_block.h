// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_block_h
#define tests_sample_block_h

#include <deal.II/base/tensor_function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include "material/material_parameters.h"
#include "multigrid/multigrid_preconditioner.h"
#include "sample_mesh.h"
#include "sample_model.h"
#include "schur_complement.h"
#include "solver/krylov_methods.h"
#include "solver/tangent_solver.h"
#include "verdict.h"

using namespace ElastoPlastic;

/// A block to test multigrid with, on a fixed face; its elastic tangent. It has
/// been turned round by half a turn, so that the Jacobians of its cells have
/// negative entries.
template <int dim>
class Block
{
public:
  Block(const unsigned int degree,
        const StrainModel &strain_model,
        const bool         with_hanging_nodes,
        const unsigned int n_refinements,
        const double       poisson_ratio = 0.3)
    : model(sample_model(conditions(), strain_model))
    , mesh(MPI_COMM_WORLD)
    , fe(FE_Q<dim>(degree), dim)
    , dof_handler(mesh)
    , supports(model)
    , solid(std::make_unique<SolidOperator<dim>>(degree,
                                                 strain_model,
                                                 materials(poisson_ratio)))
  {
    // (p4est orders the 3^2 cells differently from deal.II)
    GridGenerator::subdivided_hyper_cube(mesh, dim == 2 ? 3 : 2, 0., 1., true);
    GridTools::transform(
      [](Point<dim> point) {
        for (const unsigned int d : {0, 1})
          point[d] = 1. - point[d];
        return point;
      },
      mesh);
    if (with_hanging_nodes)
      refine_corner(mesh);
    mesh.refine_global(n_refinements);
    dof_handler.distribute_dofs(fe);
    supports.reinit(dof_handler, 0.);
    solid->reinit(dof_handler, supports.constraints());
    solid->initialize_vector(zero);
    u = zero;
    solid->linearize(zero);
    held = zero;
    supports.set_fixed_entries(held, 1.);
  }

  /// Linearises about a displacement with the same gradient everywhere.
  void
  deform()
  {
    VectorTools::interpolate(
      dof_handler,
      VectorFunctionFromTensorFunction<dim>(LinearField(), 0, dim),
      u);
    solid->predict_flow(u, u);
    solid->linearize(u);
  }

  void
  check_finest_level() const
  {
    LevelHierarchy<dim> hierarchy(model,
                                  dof_handler,
                                  supports.constraints(),
                                  1);
    hierarchy.update(*solid, {zero, zero});
    const LevelOperator<dim> &level =
      *hierarchy.operators()[hierarchy.max_level()];

    VectorType  v = field(), product = derivative_of_forces(v), diagonal;
    LevelVector level_v, level_product;
    level.initialize_vector(level_v);
    level.initialize_vector(level_product);
    level_v.copy_locally_owned_data_from(v);
    level.vmult(level_product, level_v);
    // (on constrained unknowns, the level operator is the identity)
    supports.constraints().set_zero(level_product);
    verify("  the finest level is the tangent",
           difference(product, level_product),
           1e-5);
    solid->vmult(product, v);
    verify("  the problem's product, too",
           difference(product, level_product),
           1e-5);

    TangentMatrix<dim> matrix;
    matrix.reinit(dof_handler, supports.constraints());
    matrix.assemble(level, {zero, zero});
    matrix.matrix().vmult(product, v);
    verify("  its matrix", difference(product, level_product), 1e-5);

    level.inverse_diagonal(level_product);
    solid->diagonal(diagonal);
    for (double &value : diagonal)
      value = (value == 0. ? 1. : 1. / value);
    verify("  its diagonal", difference(diagonal, level_product), 1e-5);
  }

  /// For meshes with hanging nodes on both levels.
  void
  check_transfer() const
  {
    LevelHierarchy<dim> hierarchy(model,
                                  dof_handler,
                                  supports.constraints(),
                                  mesh.n_global_active_cells() - 1);
    hierarchy.update(*solid, {zero, zero});
    const unsigned int finest = hierarchy.max_level();
    const VectorFunctionFromScalarFunctionObject<dim> linear(
      [](const Point<dim> &x) { return 1. + x[0] + 2. * x[dim - 1]; },
      dim - 1,
      dim);

    MGLevelObject<LevelVector> values(0, finest), forces(0, finest);
    for (unsigned int l = 0; l <= finest; ++l)
      {
        hierarchy.operators()[l]->initialize_vector(values[l]);
        forces[l].reinit(values[l]);
      }
    VectorType coarse_values(values[0].get_partitioner());
    VectorTools::interpolate(hierarchy.coarse_dof_handler(),
                             linear,
                             coarse_values);
    hierarchy.coarse_constraints().set_zero(coarse_values);
    values[0].copy_locally_owned_data_from(coarse_values);
    forces[finest].copy_locally_owned_data_from(field());
    for (unsigned int l = 1; l <= finest; ++l)
      {
        hierarchy.transfer().prolongate(l, values[l], values[l - 1]);
        hierarchy.transfer().restrict_and_add(finest + 1 - l,
                                              forces[finest - l],
                                              forces[finest + 1 - l]);
      }

    VectorType fine_values = zero;
    VectorTools::interpolate(dof_handler, linear, fine_values);
    supports.constraints().set_zero(fine_values);
    verify("  linear functions are prolongated exactly",
           difference(fine_values, values[finest]),
           1e-5);
    const double work = values[finest] * forces[finest];
    verify("  restriction is the transpose",
           std::abs(values[0] * forces[0] - work),
           1e-5 * std::abs(work));
  }

  unsigned int
  n_iterations() const
  {
    VectorType solution = zero;
    return solve(solution, multigrid(), unknowns({}));
  }

  void
  check_mixed_form() const
  {
    verify("  the mixed product is all that its result holds",
           mixed_product_of_field(0.) == mixed_product_of_field(1e300));
    const Method factorization{
      "factorisation",
      [this]() {
        return std::make_unique<AssembledPreconditioner<dim>>(
          *solid,
          make_factorization(MPI_COMM_WORLD),
          dof_handler,
          supports.constraints());
      },
      1000};
    for (const auto &coupled : {std::vector<unsigned int>(), entries_of_top()})
      {
        VectorType expected = zero, found = zero;
        solve(expected, factorization, unknowns(coupled));
        solve(found, multigrid(), unknowns(coupled));
        found -= expected;
        verify("  the mixed form has the solution of the tangent",
               found.linfty_norm() / expected.linfty_norm(),
               1e-6);
      }
  }

  /// The Schur complement of the mixed form with its model as preconditioner,
  /// some displacements being held. @return the number of GMRES iterations.
  unsigned int
  n_pressure_iterations() const
  {
    const SchurComplement<dim> schur(*solid, held);
    const auto model = solid->make_pressure_preconditioner(held);
    struct Preconditioner
    {
      const PressurePreconditioner &model;

      void
      vmult(VectorType &result, const VectorType &pressures) const
      {
        model.vmult(result, pressures);
      }
    };

    BlockVectorType mixed, product;
    solid->initialize_mixed_vector(mixed);
    solid->initialize_mixed_vector(product);
    mixed.block(0) = field();
    solid->mixed_vmult(product, mixed);
    return flexible_gmres(schur,
                          mixed.block(1),
                          product.block(1),
                          Preconditioner{*model},
                          1e-6,
                          1000);
  }

private:
  using Method = TangentSolver::Method;

  static std::vector<Material<double>>
  materials(const double poisson_ratio)
  {
    MaterialParameters parameters;
    parameters.poisson_ratios = {poisson_ratio};
    return parameters.materials();
  }

  Method
  multigrid() const
  {
    return {"multigrid",
            [this]() {
              return std::make_unique<MultigridPreconditioner<dim>>(
                model, *solid, dof_handler, supports.constraints());
            },
            1000,
            solid->is_nearly_incompressible() ? TangentForm::mixed :
                                                TangentForm::displacements};
  }

  /// The last component of the unknowns at the top.
  std::vector<unsigned int>
  entries_of_top() const
  {
    std::vector<bool> last(dim, false);
    last.back() = true;
    std::vector<unsigned int> entries;
    for (const auto dof : DoFTools::extract_boundary_dofs(dof_handler,
                                                          ComponentMask(last),
                                                          {2 * dim - 1}))
      if (zero.in_local_range(dof) &&
          !supports.constraints().is_constrained(dof))
        entries.push_back(zero.get_partitioner()->global_to_local(dof));
    return entries;
  }

  ReducedUnknowns
  unknowns(const std::vector<unsigned int> &coupled) const
  {
    return ReducedUnknowns(supports.fixed_entries(zero),
                           coupled,
                           MPI_COMM_WORLD);
  }

  /// The dilatations, in a result that holds @p before before.
  std::vector<double>
  mixed_product_of_field(const double before) const
  {
    BlockVectorType mixed;
    solid->initialize_mixed_vector(mixed);
    BlockVectorType product = mixed;
    mixed.block(0)          = field();
    product                 = before;
    solid->mixed_vmult(product, mixed);
    return {product.block(1).begin(), product.block(1).end()};
  }

  unsigned int
  solve(VectorType            &solution,
        const Method          &method,
        const ReducedUnknowns &unknowns) const
  {
    TangentSolver solver(*solid, {method}, [](const std::string &) {});
    solver.prepare(unknowns);
    VectorType rhs = field(), product = zero;
    unknowns.contract(rhs);
    const unsigned int n = solver.solve(solution, rhs, 1e-8);

    unknowns.expand(solution);
    solid->vmult(product, solution);
    unknowns.contract(product);
    product -= rhs;
    verify("  solves", product.l2_norm() < 1.1e-8 * rhs.l2_norm());
    return n;
  }

  class LinearField : public TensorFunction<1, dim>
  {
  public:
    Tensor<1, dim>
    value(const Point<dim> &x) const override
    {
      Tensor<1, dim> u;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          u[i] += 0.1 * std::sin(1. + 2. * i + 5. * j) * x[j];
      return u;
    }
  };

  static BoundaryConditions<dim>
  conditions()
  {
    BoundaryConditionParameters parameters;
    BoundaryNames               names;
    names["bottom"]  = 2 * dim - 2;
    parameters.fixed = {"bottom"};
    for (unsigned int id = 0; id < 2 * dim; ++id)
      if (id != 2 * dim - 2)
        {
          names["side" + std::to_string(id)] = id;
          parameters.free.push_back("side" + std::to_string(id));
        }
    return BoundaryConditions<dim>(parameters, names);
  }

  VectorType
  field() const
  {
    VectorType vector = zero;
    VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), vector);
    supports.constraints().set_zero(vector);
    return vector;
  }

  /// At u, in the direction @p v: at quadrature points, never mode by mode.
  VectorType
  derivative_of_forces(const VectorType &v) const
  {
    const double step  = 1e-5;
    VectorType   there = u, forces = zero, derivative = zero;
    there.add(step, v);
    solid->internal_forces(derivative, there);
    there.add(-2. * step, v);
    solid->internal_forces(forces, there);
    derivative -= forces;
    derivative /= 2. * step;
    return derivative;
  }

  static double
  difference(const VectorType &expected, const LevelVector &found)
  {
    VectorType error = expected;
    error.copy_locally_owned_data_from(found);
    error -= expected;
    return error.linfty_norm() / expected.linfty_norm();
  }

  const Model<dim>                          model;
  parallel::distributed::Triangulation<dim> mesh;
  const FESystem<dim>                       fe;
  DoFHandler<dim>                           dof_handler;
  Supports<dim>                             supports;
  std::unique_ptr<SolidOperator<dim>>       solid;
  VectorType                                zero, u, held;
};



template <int dim>
void
describe(const unsigned int degree, const StrainModel &strain_model)
{
  output()
    << dim << "D, p = " << degree
    << (strain_model.treatment == VolumetricTreatment::b_bar ? ", B-bar" : "")
    << (strain_model.kinematics == Kinematics::axisymmetric ? ", axisymmetric" :
        strain_model.kinematics == Kinematics::plane_stress ? ", plane stress" :
                                                              "")
    << (strain_model.is_finite() ? ", finite strains" : "") << std::endl;
}

#endif
