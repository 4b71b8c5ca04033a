// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Nodes that are entering the contact cost hardly any linear iterations more
// than free ones: all preconditioners know their springs, and that closed nodes
// move against them. A factorisation knows all there is.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include "contact/edge_law.h"
#include "mechanics/rigid_body_modes.h"
#include "multigrid/multigrid_preconditioner.h"
#include "sample_mesh.h"
#include "sample_model.h"
#include "solver/tangent_solver.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Method = TangentSolver::Method;

  template <int dim>
  BoundaryConditions<dim>
  fixed_bottom()
  {
    BoundaryConditionParameters parameters;
    BoundaryNames               names;
    parameters.fixed = {"side" + std::to_string(2 * dim - 2)};
    for (unsigned int id = 0; id < 2 * dim; ++id)
      {
        names["side" + std::to_string(id)] = id;
        if (id != 2 * dim - 2)
          parameters.free.push_back("side" + std::to_string(id));
      }
    return BoundaryConditions<dim>(parameters, names);
  }



  /// An elastic block under a paraboloid: in its middle, the nodes at the top
  /// are closed, in a ring around these they are entering.
  template <int dim>
  class PressedBlock
  {
  public:
    PressedBlock()
      : model(sample_model(fixed_bottom<dim>()))
      , mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(1), dim)
      , dof_handler(mesh)
      , supports(model)
      , solid(1,
              StrainModel(VolumetricTreatment::standard),
              MaterialParameters().materials())
    {
      output() << dim << "D" << std::endl;
      GridGenerator::subdivided_hyper_cube(mesh, 4, -1., 1., true);
      mesh.refine_global(dim == 2 ? 3 : 2);
      dof_handler.distribute_dofs(fe);
      supports.reinit(dof_handler, 0.);
      solid.reinit(dof_handler, supports.constraints());
      solid.initialize_vector(zero);
      solid.linearize(zero);
      touch();
    }

    void
    check(const Method &method, const unsigned int most_steps_more) const
    {
      const unsigned int free =
        n_steps(method, ReducedUnknowns(constrained, {}, MPI_COMM_WORLD, {}));
      const unsigned int entering =
        n_steps(method,
                ReducedUnknowns(constrained, {}, MPI_COMM_WORLD, shared));
      output() << method.name << std::endl;
      verify("  steps more than with free nodes",
             static_cast<double>(entering) - free,
             most_steps_more);
    }

    Method
    assembled(const std::string &name) const
    {
      return {name,
              [this, name]() {
                return std::make_unique<AssembledPreconditioner<dim>>(
                  solid,
                  name == "factorisation" ?
                    make_factorization(MPI_COMM_WORLD) :
                    make_algebraic_multigrid(
                      rigid_body_modes(dof_handler, zero)),
                  dof_handler,
                  supports.constraints());
              },
              1000};
    }

    Method
    multigrid() const
    {
      return {"geometric multigrid",
              [this]() {
                return std::make_unique<MultigridPreconditioner<dim>>(
                  model, solid, dof_handler, supports.constraints());
              },
              1000};
    }

  private:
    void
    touch()
    {
      std::map<types::global_dof_index, double> gaps;
      std::vector<EdgeLaw::Pair>                pairs;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == 2 * dim - 1)
              for (const auto v : face->vertex_indices())
                {
                  const auto x   = face->vertex(v);
                  const auto dof = face->vertex_dof_index(v, dim - 1);
                  gaps[dof]      = 0.5 * (x.square() - 1.);
                  for (const auto w : face->vertex_indices())
                    if (cell->is_locally_owned() && w > v)
                      pairs.push_back(
                        {dof, face->vertex_dof_index(w, dim - 1)});
                }
      std::vector<EdgeLaw::Node> nodes;
      for (const auto &[dof, gap] : gaps)
        if (zero.in_local_range(dof))
          nodes.push_back(
            {dof, zero.get_partitioner()->global_to_local(dof), gap, 1.});
      EdgeLaw law;
      law.reinit(nodes, pairs, MPI_COMM_WORLD);
      set_statuses(law, nodes);
    }

    void
    set_statuses(const EdgeLaw &law, const std::vector<EdgeLaw::Node> &nodes)
    {
      constrained = supports.fixed_entries(zero);
      std::vector<ContactStatus> statuses;
      std::vector<double>        distances;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          statuses.push_back(nodes[k].gap < 0.08 ? ContactStatus::closed :
                             nodes[k].gap < 0.19 && law.has_part(k) ?
                                                   ContactStatus::entering :
                                                   ContactStatus::open);
          distances.push_back(0.1 * law.rise(k));
          if (statuses.back() == ContactStatus::closed)
            constrained.push_back(nodes[k].entry);
        }
      const auto place = law.place(distances, statuses);
      VectorType diagonal;
      solid.diagonal(diagonal);
      shared.rows = law.rows(place, statuses);
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (statuses[k] == ContactStatus::entering)
          shared.entering.push_back(
            {nodes[k].entry, diagonal.local_element(nodes[k].entry)});
    }

    unsigned int
    n_steps(const Method &method, const ReducedUnknowns &unknowns) const
    {
      TangentSolver solver(solid, {method}, [](const std::string &) {});
      solver.prepare(unknowns);
      VectorType rhs = zero, solution = zero;
      VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), rhs);
      supports.constraints().set_zero(rhs);
      unknowns.contract(rhs);
      return solver.solve(solution, rhs, 1e-8);
    }

    const Model<dim>                          model;
    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    Supports<dim>                             supports;
    SolidOperator<dim>                        solid;
    VectorType                                zero;
    std::vector<unsigned int>                 constrained;
    SharedForces                              shared;
  };



  template <int dim>
  void
  check()
  {
    const PressedBlock<dim> block;
    block.check(block.assembled("factorisation"), 2);
    block.check(block.assembled("algebraic multigrid"), 3);
    block.check(block.multigrid(), 2);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>();
  check<3>();
}
