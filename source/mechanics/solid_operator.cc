// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <numeric>

#include "base/compatibility.h"
#include "material/material_lists.h"
#include "material/plane_stress.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Whether a point flows in any lane, or may do so soon: the flow
    /// @p direction that is predicted for an elastic point has the length of
    /// the stress, and 1 if that reaches the yield surface.
    bool
    may_flow(const RadialReturn<Simd<double>>          &plasticity,
             const SymmetricTensor<2, 3, Simd<double>> &direction)
    {
      constexpr double   enough = 0.5;
      const Simd<double> flows  = plasticity.plastic(1.);
      const Simd<double> length = direction.norm();
      for (unsigned int lane = 0; lane < Simd<double>::size(); ++lane)
        if (flows[lane] > 0. || length[lane] > enough)
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  SolidOperator<dim>::SolidOperator(
    const unsigned int                   degree,
    const StrainModel                   &strain_model,
    const std::vector<Material<double>> &materials)
    : materials(materials)
    , is_sheet(strain_model.kinematics == Kinematics::plane_stress)
    , is_finite(strain_model.is_finite())
    , has_general_criteria(strain_model.has_general_criteria)
    , has_nominal_tangents(strain_model.has_nominal_tangents())
    , is_b_bar(strain_model.treatment == VolumetricTreatment::b_bar)
    , n_points(Utilities::fixed_power<dim>(degree + 1))
    , has_potential(this->materials.have_potential())
    , recovers(this->materials.recover())
    , becomes_steeper(this->materials.become_steeper())
    , kernel(make_solid_kernel<dim>(degree, strain_model))
    , tangents(n_points, recovers, strain_model)
    , history(this->materials.n_back_stresses())
  {
    AssertThrow(has_general_criteria ==
                  ElastoPlastic::has_general_criterion(materials.front()),
                ExcMessage("The strain model knows what criteria there are."));
  }



  template <int dim>
  void
  SolidOperator<dim>::reinit(const DoFHandler<dim>           &dof_handler,
                             const AffineConstraints<double> &constraints)
  {
    kernel->reinit(dof_handler, constraints);
    materials.reinit(*kernel, n_points, communicator_of(dof_handler));

    tangents.reinit(kernel->n_batches());
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      tangents.set_bulk_modulus(batch, materials[batch].bulk_modulus);
    history.reinit(kernel->n_batches(), n_points);
    initial_strains.clear();
  }



  template <int dim>
  SymmetricTensor<2, 3, Simd<double>>
  SolidOperator<dim>::strain_at(const Strains     &strains,
                                const unsigned int point) const
  {
    Strain strain = strains.strain[point];
    if (initial_strains.are_present())
      strain += initial_strains.at(strains.batch, point);
    if (is_sheet)
      strain[2][2] = out_of_plane_strain(materials[strains.batch],
                                         strain,
                                         history.state(strains.batch, point));
    return strain;
  }



  template <int dim>
  PointResponse<Simd<double>>
  SolidOperator<dim>::response(const Strains     &strains,
                               const unsigned int point) const
  {
    return PointResponse<Number>(is_sheet,
                                 materials.at(strains.batch, point),
                                 strain_at(strains, point),
                                 volumetric_strain_at(strains, point),
                                 history.state(strains.batch, point));
  }



  template <int dim>
  double
  SolidOperator<dim>::find_stresses(const Strains &strains,
                                    Stresses      &stresses) const
  {
    Number energies = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto at_point = response(strains, q);
        stresses[q]         = at_point.stress();
        energies +=
          at_point.incremental_energy(has_energy()) * strains.volume[q];
        if (initial_strains.are_present())
          energies -= initial_energy_at(strains, q) * strains.volume[q];
      }
    double energy = 0;
    for (unsigned int lane = 0; lane < kernel->n_cells(strains.batch); ++lane)
      energy += energies[lane];
    return energy;
  }



  template <int dim>
  double
  SolidOperator<dim>::energy(const VectorType &u) const
  {
    double   local_sum = 0;
    Stresses stresses;
    kernel->for_each_batch({&u}, [&](const std::vector<Strains> &strains) {
      local_sum += find_stresses(strains[0], stresses);
    });
    return Utilities::MPI::sum(local_sum, u.get_mpi_communicator());
  }



  template <int dim>
  double
  SolidOperator<dim>::virtual_work(const VectorType &u,
                                   const VectorType &w) const
  {
    return Utilities::MPI::sum(kernel->work(u,
                                            w,
                                            [this](const Strains &strains,
                                                   Stresses      &stresses) {
                                              find_stresses(strains, stresses);
                                            }),
                               u.get_mpi_communicator());
  }



  template <int dim>
  double
  SolidOperator<dim>::internal_forces(VectorType       &forces,
                                      const VectorType &u) const
  {
    double local_energy = 0;
    kernel->integrate(forces,
                      u,
                      [&](const Strains &strains, Stresses &stresses) {
                        local_energy += find_stresses(strains, stresses);
                      });
    return Utilities::MPI::sum(local_energy, u.get_mpi_communicator());
  }



  template <int dim>
  void
  SolidOperator<dim>::linearize(const VectorType &u)
  {
    AtPoints<OpenTangent<Number>>                         of_points;
    AtPoints<Strain>                                      flow_directions;
    AtPoints<typename PointTangents<dim>::GeneralTangent> general;
    kernel->linearize(
      tangents, u, [&](const Strains &strains, Stresses &stresses) {
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const auto  at_point   = response(strains, q);
            const auto &plasticity = at_point.plasticity();
            stresses[q]            = at_point.stress();
            of_points[q]           = plasticity.tangent();
            if (is_flow_exact())
              flow_directions[q] = plasticity.flow_direction();
            if (has_general_criteria)
              general[q] = plasticity.general_tangent();
          }
        tangents.set(strains.batch, of_points);
        if (is_flow_exact() && !tangents.are_constant(strains.batch))
          tangents.set_flow_directions(strains.batch, flow_directions);
        if (has_general_criteria)
          tangents.set_general(general);
      });
    if (is_nearly_incompressible())
      moderate_bulk_moduli();
  }



  template <int dim>
  void
  SolidOperator<dim>::predict_flow(const VectorType &old_u,
                                   const VectorType &new_u)
  {
    if (is_flow_exact())
      return;
    AtPoints<Strain> directions;
    const auto       predict = [&](const std::vector<Strains> &strains) {
      const unsigned int batch      = strains[0].batch;
      bool               are_needed = false;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto  at_point   = response(strains[0], q);
          const auto &plasticity = at_point.plasticity();
          directions[q]          = plasticity.predicted_flow(
            tangents.flow_direction(batch, q),
            strain_deviator(strain_at(strains.back(), q)) -
              strain_deviator(strain_at(strains[0], q)));
          are_needed = are_needed || may_flow(plasticity, directions[q]);
        }
      if (are_needed)
        tangents.set_flow_directions(batch, directions);
      else
        tangents.forget_flow_directions(batch);
    };
    std::vector<const VectorType *> fields = {&old_u};
    if (&new_u != &old_u)
      fields.push_back(&new_u);
    kernel->for_each_batch(fields, predict);
  }



  template <int dim>
  void
  SolidOperator<dim>::for_each_cell(
    const VectorType &u,
    const std::function<
      void(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const std::vector<PointResult> &points)> &receive) const
  {
    // for each lane, the points of its cell
    std::array<std::vector<PointResult>, Number::size()> results;
    results.fill(std::vector<PointResult>(n_points));
    const auto law = [this](const Strains &strains, Stresses &stresses) {
      find_stresses(strains, stresses);
    };
    const auto use = [&](const Strains &strains, const Stresses &stresses) {
      const unsigned int n_cells = kernel->n_cells(strains.batch);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto  at_point       = response(strains, q);
          const auto &plasticity     = at_point.plasticity();
          const auto  state          = plasticity.state();
          Strain      strain         = strain_at(strains, q);
          Number      elastic_energy = at_point.elastic_energy();
          if (initial_strains.are_present())
            {
              strain -= initial_strains.at(strains.batch, q);
              elastic_energy -= initial_energy_at(strains, q);
            }
          const Number thickness =
            is_sheet && is_finite ? std::exp(strain[2][2]) : Number(1.);
          const Number hardening_energy = plasticity.hardening_energy();
          const Number plastic_work     = plasticity.plastic_work();
          const Number dissipation      = plasticity.dissipation();
          const double duration = materials[strains.batch].step_duration;
          const Number rate =
            duration > 0. ?
              (state.equivalent_plastic_strain -
               history.state(strains.batch, q).equivalent_plastic_strain) /
                Number(duration) :
              Number(0.);
          const Strain back_stress =
            std::accumulate(state.back_stresses.begin(),
                            state.back_stresses.end(),
                            Strain());
          for (unsigned int lane = 0; lane < n_cells; ++lane)
            results[lane][q] = {lane_of(stresses[q], lane) / thickness[lane],
                                lane_of(strain, lane),
                                lane_of(state.plastic_strain, lane),
                                lane_of(back_stress, lane),
                                state.equivalent_plastic_strain[lane],
                                rate[lane],
                                state.equivalent_plastic_strain[lane] >
                                  smallest_strain,
                                strains.volume[q][lane],
                                elastic_energy[lane],
                                hardening_energy[lane],
                                plastic_work[lane],
                                dissipation[lane]};
        }
      for (unsigned int lane = 0; lane < n_cells; ++lane)
        receive(kernel->cell(strains.batch, lane), results[lane]);
    };
    kernel->for_each_true_stress(u, law, use);
  }
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "solid_operator_initial_stress.cc"
#include "solid_operator_preconditioning.cc"
#include "solid_operator_states.cc"

namespace ElastoPlastic
{
  template class SolidOperator<2>;
  template class SolidOperator<3>;
} // namespace ElastoPlastic
