// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Tractions on the faces of quadratic elements: what is linear stays, what
// alternates between the nodes of a face goes, force and moments of a face are
// kept, the node on the axis gets a value; faces touched in part do not count.

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>

#include <functional>

#include "contact/contact_nodes.h"
#include "contact/face_filter.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  /// The unit square or cube, its top being 8 elements wide.
  template <int dim>
  class Block
  {
  public:
    using Traction = std::function<double(const ContactNode<dim> &)>;

    Block(const unsigned int degree, const Kinematics kinematics)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
    {
      GridGenerator::subdivided_hyper_cube(mesh, 8, 0., 1., true);
      dof_handler.distribute_dofs(fe);
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints.close();
      layout.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
      filter.reinit(dof_handler, constraints, {top}, kinematics, layout);
      nodes = find_contact_nodes<dim>(
        dof_handler,
        constraints,
        {top},
        [](const Point<dim> &) { return IndenterSurface<dim>{}; },
        kinematics,
        layout);
    }

    /// The vertical tractions after filtering, in the order of the nodes of
    /// this rank; zero at nodes without area before.
    Vector
    filtered(const Traction &traction, const double touched_up_to = 2.) const
    {
      Vector values = layout, touched = layout;
      for (const auto &node : nodes)
        if (!node.without_area && node.position[0] < touched_up_to)
          {
            values.local_element(node.index)  = traction(node);
            touched.local_element(node.index) = 1.;
          }
      filter.apply(values, touched);
      return values;
    }

    /// The largest difference from a traction up to some x.
    double
    error(const Vector   &values,
          const Traction &traction,
          const double    up_to = 2.) const
    {
      double largest = 0;
      for (const auto &node : nodes)
        if (node.position[0] < up_to)
          largest = std::max(largest,
                             std::abs(values.local_element(node.index) -
                                      traction(node)));
      return Utilities::MPI::max(largest, MPI_COMM_WORLD);
    }

    /// 1 at the corners of faces, -1/2 beside them (in space by direction):
    /// neither force nor moment, on any face.
    static double
    alternating(const ContactNode<dim> &node)
    {
      double product = 1;
      for (unsigned int d = 0; d < dim - 1; ++d)
        product *= std::lround(16 * node.position[d]) % 2 == 0 ? 1. : -0.5;
      return product;
    }

  private:
    static constexpr types::boundary_id top = 2 * dim - 1;

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    Vector                                    layout;
    FaceFilter<dim>                           filter;
    std::vector<ContactNode<dim>>             nodes;
  };



  template <int dim>
  void
  check_plane()
  {
    output() << "Quadratic, " << dim << "D" << std::endl;
    const Block<dim> block(2, Kinematics::cartesian);
    const auto       linear = [](const ContactNode<dim> &node) {
      double value = 2.;
      for (unsigned int d = 0; d < dim - 1; ++d)
        value += (d + 1.) * node.position[d];
      return value;
    };
    const auto scattering = [&](const ContactNode<dim> &node) {
      return linear(node) + 0.3 * Block<dim>::alternating(node);
    };
    const auto square = [](const ContactNode<dim> &node) {
      return node.position[0] * node.position[0];
    };
    verify("  linear tractions stay",
           block.error(block.filtered(linear), linear),
           1e-12);
    verify("  what alternates goes",
           block.error(block.filtered(scattering), linear),
           1e-12);
    verify("  others change by less than the square of the width",
           block.error(block.filtered(square), square),
           1. / 64.);
    const Vector half = block.filtered(scattering, 0.7);
    verify("  faces touched in part do not count",
           block.error(half, linear, 0.65) < 1e-12 &&
             block.error(half, linear, 0.69) > 0.01);
  }



  void
  check_axis()
  {
    output() << "Quadratic, of revolution" << std::endl;
    const Block<2> block(2, Kinematics::axisymmetric);
    const auto     linear = [](const ContactNode<2> &node) {
      return 3. - node.position[0];
    };
    verify("  linear tractions stay, and reach the axis",
           block.error(block.filtered(linear), linear),
           1e-12);
  }



  void
  check_linear()
  {
    output() << "Linear" << std::endl;
    const Block<2> block(1, Kinematics::cartesian);
    const auto     jumping = [](const ContactNode<2> &node) {
      return std::lround(8 * node.position[0]) % 2 == 0 ? 1. : 2.;
    };
    verify("  nothing changes",
           block.error(block.filtered(jumping), jumping),
           0.);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_plane<2>();
  check_plane<3>();
  check_axis();
  check_linear();
}
