// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Under a uniform stress, the force of a supported boundary on the body is
// stress times normal times area, and those of several add up to the forces of
// equilibrium: with hanging nodes, on skew boundaries, and in whole rings.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include <map>
#include <sstream>

#include "loads/reactions.h"
#include "sample_material.h"
#include "sample_mesh.h"
#include "sample_model.h"
#include "vector_field.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;



  /// A body with a linear displacement; a traction balances its stress on all
  /// boundaries that are not supported.
  template <int dim>
  class StressedBody
  {
  public:
    /// @p normals are the outer normals times area of all boundaries.
    StressedBody(const std::function<void(Mesh<dim> &)>      &make_mesh,
                 const BoundaryNames                         &names,
                 const std::map<std::string, Tensor<1, dim>> &normals,
                 const Tensor<2, dim>                        &gradient,
                 const Kinematics kinematics = Kinematics::cartesian)
      : mesh(MPI_COMM_WORLD)
      , names(names)
      , normals(normals)
      , kinematics(kinematics)
      , field([gradient](const Point<dim> &x, const unsigned int component) {
        return gradient[component] * x;
      })
      , stress(stress_of(gradient))
      , fe(FE_Q<dim>(2), dim)
      , dof_handler(mesh)
    {
      make_mesh(mesh);
      dof_handler.distribute_dofs(fe);
    }

    /// The reactions, by name, of the boundaries that @p supports name; those
    /// in @p loaded carry their traction.
    std::map<std::string, double>
    reactions(const std::string              &support_entries,
              const std::vector<std::string> &loaded)
    {
      ParameterHandler            prm;
      BoundaryConditionParameters parameters;
      parameters.add_parameters(prm);
      prm.parse_input_from_string(
        "subsection Boundary conditions\n" + support_entries +
        "\nset Traction = " + tractions(loaded) + "\nend");
      const StrainModel strain_model(VolumetricTreatment::standard, kinematics);
      const Model<dim>  model =
        sample_model(BoundaryConditions<dim>(parameters, names), strain_model);
      Supports<dim> supports(model);
      supports.reinit(dof_handler, 1.);
      const auto solid = std::make_unique<SolidOperator<dim>>(
        fe.degree,
        strain_model,
        std::vector<Material<double>>{sample_material("linear elastic")});
      solid->reinit(dof_handler, supports.constraints());

      VectorType u, no_contact;
      solid->initialize_vector(u);
      solid->initialize_vector(no_contact);
      VectorTools::interpolate(dof_handler, field, u);
      const Reactions<dim> evaluation(model, dof_handler, supports);
      const auto           columns = evaluation.names();
      const auto forces = evaluation.compute(*solid, u, no_contact, 1.);
      std::map<std::string, double> result;
      for (unsigned int i = 0; i < columns.size(); ++i)
        {
          output() << "  " << columns[i];
          result[columns[i]] = forces[i];
        }
      output() << std::endl;
      double vertical = 0, all = 0;
      for (const auto &[name, force] : result)
        {
          vertical += name.back() == "xyz"[dim - 1] ? force : 0.;
          all += std::abs(force);
        }
      verify("  the vertical force is their sum",
             std::abs(evaluation.vertical_force(*solid, u, no_contact, 1.) -
                      vertical) /
               all,
             1e-12);
      return result;
    }

    /// The exact force on a boundary.
    double
    exact(const std::string &boundary, const unsigned int direction) const
    {
      return stress[direction] * normals.at(boundary);
    }

  private:
    Tensor<2, dim>
    stress_of(const Tensor<2, dim> &gradient) const
    {
      const auto   material = sample_material("linear elastic");
      const auto   strain   = symmetrize(gradient);
      const double shear    = material.shear_modulus;
      const double volumetric =
        trace(strain) +
        (kinematics == Kinematics::axisymmetric ? strain[0][0] : 0.);
      return (material.bulk_modulus - 2. / 3. * shear) * volumetric *
               Tensor<2, dim>(unit_symmetric_tensor<dim>()) +
             2. * shear * Tensor<2, dim>(strain);
    }

    std::string
    tractions(const std::vector<std::string> &loaded) const
    {
      std::ostringstream text;
      text.precision(17);
      for (const std::string &boundary : loaded)
        {
          const auto &normal = normals.at(boundary);
          text << (text.str().empty() ? "" : " | ") << boundary << ": ";
          for (unsigned int d = 0; d < dim; ++d)
            text << (d > 0 ? "; " : "") << exact(boundary, d) / normal.norm();
        }
      return text.str();
    }

    Mesh<dim>                                   mesh;
    const BoundaryNames                         names;
    const std::map<std::string, Tensor<1, dim>> normals;
    const Kinematics                            kinematics;
    const VectorField<dim>                      field;
    const Tensor<2, dim>                        stress;
    const FESystem<dim>                         fe;
    DoFHandler<dim>                             dof_handler;
  };



  template <int dim>
  Tensor<2, dim>
  sample_gradient()
  {
    return 1e-3 * Tensor<2, dim>(sample_tensor<dim>(3, 1.));
  }



  double
  relative_error(const double value, const double exact)
  {
    return std::abs(value / exact - 1.);
  }



  template <int dim>
  void
  check_block()
  {
    std::vector<std::string> boundaries = {"left", "right", "front", "back"};
    if (dim == 2)
      boundaries.resize(2);
    boundaries.push_back("bottom");
    boundaries.push_back("top");

    BoundaryNames                         names;
    std::map<std::string, Tensor<1, dim>> normals;
    for (unsigned int i = 0; i < boundaries.size(); ++i)
      {
        names[boundaries[i]]          = i;
        normals[boundaries[i]][i / 2] = (i % 2 == 0 ? -1. : 1.);
      }
    StressedBody<dim> body(
      [](Mesh<dim> &mesh) {
        GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
        refine_corner(mesh);
      },
      names,
      normals,
      sample_gradient<dim>());
    const auto all_but = [&](const std::set<std::string> &supported) {
      std::vector<std::string> rest;
      for (const std::string &boundary : boundaries)
        if (supported.count(boundary) == 0)
          rest.push_back(boundary);
      return rest;
    };

    const std::string axes = "xyz", title = std::to_string(dim) + "D, ";
    const auto fixed = body.reactions("set Fixed = top", all_but({"top"}));
    for (unsigned int d = 0; d < dim; ++d)
      verify(title + "fixed boundary, along " + axes[d],
             relative_error(fixed.at(std::string("top_") + axes[d]),
                            body.exact("top", d)),
             1e-11);

    const auto shared = body.reactions("set Fixed = top, right, left",
                                       all_but({"top", "right", "left"}));
    for (unsigned int d = 0; d < dim; ++d)
      {
        double sum = 0;
        for (const std::string boundary : {"top_", "right_", "left_"})
          sum += shared.at(boundary + axes[d]);
        verify(title + "adjacent boundaries together, along " + axes[d],
               relative_error(sum, body.exact("top", d)),
               1e-11);
      }

    const std::string free_components = (dim == 2 ? "" : "free; ");
    const auto        partly          = body.reactions(
      "set Fixed = bottom\nset Roller = right\nset Prescribed displacement = "
                      "top: 0.1; " +
        free_components + "free",
      all_but({"bottom", "right", "top"}));
    verify(title + "no force along free components", partly.size() == dim + 2);
  }



  /// A quadrilateral that stands on a slope. (With the slope 1, the components
  /// are equal there: one of them takes the place of the other.)
  void
  check_skew_roller(const double slope)
  {
    // the displacement of the slope along itself
    const Tensor<1, 2> normal({slope, -1.}), tangent({1., slope});
    Tensor<2, 2>       gradient = sample_gradient<2>();
    gradient -= (normal * gradient * tangent) /
                (normal.norm_square() * tangent.norm_square()) *
                outer_product(normal, tangent);
    StressedBody<2> body(
      [slope](Mesh<2> &mesh) {
        const std::vector<Point<2>> vertices = {{0, 0},
                                                {1, slope},
                                                {0, 3},
                                                {1, 3}};
        std::vector<CellData<2>>    cells(1);
        cells[0].vertices = {0, 1, 2, 3};
        mesh.create_triangulation(vertices, cells, SubCellData());
        const auto cell = mesh.begin_active();
        for (const unsigned int f : cell->face_indices())
          cell->face(f)->set_boundary_id(f);
        mesh.refine_global(2);
      },
      {{"left", 0}, {"right", 1}, {"slope", 2}, {"top", 3}},
      {{"left", Tensor<1, 2>({-3., 0.})},
       {"right", Tensor<1, 2>({3. - slope, 0.})},
       {"slope", normal},
       {"top", Tensor<1, 2>({0., 1.})}},
      gradient);
    const auto forces =
      body.reactions("set Roller = slope", {"left", "right", "top"});
    const std::string title =
      "roller with the slope " + std::to_string(std::lround(slope));
    verify(title + ", along x",
           relative_error(forces.at("slope_x"), body.exact("slope", 0)),
           1e-11);
    verify(title + ", along y",
           relative_error(forces.at("slope_y"), body.exact("slope", 1)),
           1e-11);
  }



  void
  check_rings()
  {
    Tensor<2, 2> gradient;
    gradient[0][0] = 0.001;
    gradient[1][1] = -0.003;
    StressedBody<2> body(
      [](Mesh<2> &mesh) {
        GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
        refine_corner(mesh);
      },
      {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}},
      {{"left", Tensor<1, 2>({-1., 0.})},
       {"right", Tensor<1, 2>({1., 0.})},
       {"bottom", Tensor<1, 2>({0., -1.})},
       {"top", Tensor<1, 2>({0., 1.})}},
      gradient,
      Kinematics::axisymmetric);
    const auto forces =
      body.reactions("set Fixed = top\nset Roller = left", {"right", "bottom"});
    verify("disc of radius 1, along its axis",
           relative_error(forces.at("top_y"),
                          numbers::PI * body.exact("top", 1)),
           1e-11);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_block<2>();
  check_block<3>();
  for (const double slope : {2., 1.})
    check_skew_roller(slope);
  check_rings();
}
