// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

#include "indenter/indenter_parameters.h"
#include "mesh/body_size.h"
#include "problem/model.h"

namespace ElastoPlastic
{
  namespace
  {
    /// nu = 0.48
    constexpr double locking_bulk_to_shear = 74. / 3.;

    /// No metal, polymer or ceramic bears more without flow.
    constexpr double largest_yield_strain = 0.1;



    /// In tension; infinite if the material does not yield.
    double
    yield_strain(const Material<double> &material)
    {
      const double K = material.bulk_modulus, G = material.shear_modulus;
      return std::sqrt(1.5) * material.yield_radius * (3. * K + G) /
             (9. * K * G);
    }



    /// Bounds of errors are those with the vertical gap. A single step is the
    /// stationary problem of Johnson, whose contact ends at nodes.
    ContactParameters
    contact_of(const Parameters &parameters)
    {
      ContactParameters result = parameters.contact;
      if (parameters.analysis == Analysis::contact_with_error_bound &&
          result.geometry == ContactGeometry::automatic)
        result.geometry = ContactGeometry::vertical;
      if (parameters.loading.is_single_step() &&
          result.edge == EdgeRule::within_faces)
        result.edge = EdgeRule::measured_within_faces;
      return result;
    }
  } // namespace



  template <int dim>
  GapFunction<dim>
  make_mesh_and_place_indenter(
    const Model<dim>                          &model,
    parallel::distributed::Triangulation<dim> &triangulation)
  {
    model.geometry.make_mesh(triangulation);
    return GapFunction<dim>(model.indenter,
                            range_of_heights(triangulation,
                                             model.boundary_conditions.ids(
                                               BoundaryConditionType::contact))
                              .second,
                            body_size(triangulation));
  }



  template <int dim>
  ContactBounds<dim>
  make_contact_bounds(
    const Model<dim>                                &model,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation)
  {
    ContactGeometry geometry = model.contact.geometry;
    if (geometry == ContactGeometry::automatic)
      {
        const bool is_level = are_level(triangulation,
                                        model.boundary_conditions.ids(
                                          BoundaryConditionType::contact));
        geometry = model.strain_model.is_finite() ? ContactGeometry::present :
                   is_level                       ? ContactGeometry::vertical :
                                                    ContactGeometry::normal;
      }
    if (geometry == ContactGeometry::vertical)
      return vertical_bounds<dim>(
        [&gap_function](const Point<dim> &x) { return gap_function.value(x); });
    return ContactBounds<dim>(
      [&gap_function](const Point<dim> &origin, const Point<dim> &place) {
        return gap_function.surface_for(origin, place);
      },
      geometry);
  }



  template <int dim>
  std::vector<std::string>
  warnings(const Model<dim> &model)
  {
    std::vector<std::string> texts = model.geometry.warnings();
    if (model.strain_model.treatment == VolumetricTreatment::standard &&
        model.strain_model.kinematics != Kinematics::plane_stress &&
        std::any_of(model.materials.begin(),
                    model.materials.end(),
                    [](const Material<double> &material) {
                      return material.bulk_modulus >
                             locking_bulk_to_shear * material.shear_modulus;
                    }))
      texts.push_back(
        "'Material/Poisson's ratio' is above 0.48, and elements with "
        "'Discretization/Volumetric treatment = standard' lock then: linear "
        "ones may bear several times the force, the pressures of quadratic "
        "ones oscillate, and linear systems take long. Set 'Volumetric "
        "treatment = B-bar', for both.");
    for (const Material<double> &material : model.materials)
      if (const double strain = yield_strain(material);
          std::isfinite(strain) && strain > largest_yield_strain)
        texts.push_back(
          "By 'Material/Young's modulus' and 'Yield stress' a material yields "
          "at a strain of " +
          Patterns::Tools::to_string(strain) +
          " only, which no metal or polymer bears. Are both in the same unit, "
          "such as MPa?");
    return texts;
  }



  template std::vector<std::string>
  warnings(const Model<2> &);
  template std::vector<std::string>
  warnings(const Model<3> &);
  template GapFunction<2>
  make_mesh_and_place_indenter(const Model<2> &,
                               parallel::distributed::Triangulation<2> &);
  template GapFunction<3>
  make_mesh_and_place_indenter(const Model<3> &,
                               parallel::distributed::Triangulation<3> &);
  template ContactBounds<2>
  make_contact_bounds(const Model<2> &,
                      const GapFunction<2> &,
                      const parallel::distributed::Triangulation<2> &);
  template ContactBounds<3>
  make_contact_bounds(const Model<3> &,
                      const GapFunction<3> &,
                      const parallel::distributed::Triangulation<3> &);



  template <int dim>
  Model<dim>
  make_model(const Parameters &parameters)
  {
    const Geometry<dim> geometry(parameters.geometry);
    StrainModel         strain_model = parameters.discretization.strain_model();
    strain_model.has_general_criteria =
      parameters.material.criteria.are_general();
    std::vector<Material<double>> materials = parameters.material.materials();
    for (unsigned int id = 0; id < materials.size(); ++id)
      if (const auto &criteria = parameters.material.criteria;
          criteria.has_varying_axes(id))
        materials[id].criterion_at = criteria.criterion_along_axes<dim>(id);
    return {{BoundaryConditions<dim>(parameters.boundary_conditions,
                                     geometry.boundary_names()),
             BodyForce<dim>(parameters.body_force.components),
             strain_model},
            geometry,
            parameters.discretization.degree,
            materials,
            make_indenter<dim>(parameters.indenter),
            contact_of(parameters),
            LoadProgram(parameters.loading),
            InitialStress<dim>(parameters.initial_stress,
                               parameters.discretization.kinematics)};
  }



  template Model<2>
  make_model(const Parameters &);
  template Model<3>
  make_model(const Parameters &);
} // namespace ElastoPlastic
