// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/job_preview.h"
#include "contact/contact_set.h"
#include "loads/supports.h"
#include "mesh/body_size.h"
#include "mesh/boundary_faces.h"
#include "mesh/mesh_entities.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A mesh with more unknowns takes more than a fraction of a second.
    constexpr double max_quick_unknowns = 50000;



    /// How many times as many cells the next mesh has.
    double
    refinement_factor(const RefinementParameters &refinement,
                      const unsigned int          dim)
    {
      const double n_children = std::pow(2., dim);
      return 1 + (n_children - 1) * refinement.refinement_fraction -
             (1 - 1 / n_children) * refinement.coarsening_fraction;
    }



    /// See expected_cost().
    struct CostPerUnknown
    {
      double kilobytes;
      double microseconds; ///< in each load step
    };

    CostPerUnknown
    cost_per_unknown(const unsigned int dim, const unsigned int degree)
    {
      if (dim == 2)
        return degree == 1 ? CostPerUnknown{1., 10.} : CostPerUnknown{0.6, 12.};
      return degree == 1 ? CostPerUnknown{0.8, 25.} : CostPerUnknown{0.5, 18.};
    }

    /// How many times as long a step takes with finite strains: more
    /// iterations of Newton's method, and larger tangents.
    constexpr double time_of_finite_strain = 4.;

    /// Nominal tangents at all points.
    double
    kilobytes_of_nominal_tangents(const unsigned int dim)
    {
      return dim == 2 ? 0.2 : 0.6;
    }

    /// In space, of cells that are no boxes: Jacobians at all points, and
    /// reference tangents.
    constexpr double kilobytes_of_other_cells = 0.4;

    /// The basis of nearly incompressible bodies' linear solver: for each step,
    /// two vectors of displacements and pressures.
    constexpr double kilobytes_of_mixed_form = 2.;
  } // namespace



  template <int dim>
  JobPreview<dim>::JobPreview(const Model<dim> &model,
                              const Parameters &parameters)
    : parameters(parameters)
    , quick(model.with_few_cells(max_quick_unknowns /
                                 (dim * std::pow(model.degree, dim))))
    , n_refinements_left_out(model.geometry.n_initial_refinements() -
                             quick.geometry.n_initial_refinements())
    , triangulation(MPI_COMM_SELF)
    , gap_function(make_mesh_and_place_indenter(quick, triangulation))
    , contact(quick, quick.indenter, triangulation, gap_function)
    , fe(FE_Q<dim>(model.degree), dim)
    , dof_handler(triangulation)
  {
    dof_handler.distribute_dofs(fe);
  }



  namespace
  {
    /// Around one spot with this many elements over its radius, in space around
    /// a quarter of it: what the cases in parameter_files/indentation/ had.
    template <int dim>
    double
    cells_around_contact(const unsigned int n_over_radius)
    {
      return dim == 2 ? 190. * n_over_radius :
                        200. * n_over_radius * n_over_radius;
    }
  } // namespace



  // The sequence ends as MeshAdaptation::mark_in_step() ends it.
  template <int dim>
  std::vector<typename JobPreview<dim>::MeshSize>
  JobPreview<dim>::meshes() const
  {
    MeshEntities<dim> entities(triangulation);
    const auto        size_of = [&]() -> MeshSize {
      return {entities.n_cells(), dim * entities.n_nodes(fe.degree)};
    };
    for (unsigned int i = 0; i < n_refinements_left_out; ++i)
      entities.refine();

    const auto           &refinement = parameters.refinement;
    std::vector<MeshSize> sizes      = {size_of()};
    if (is_first_mesh())
      sizes.front().unknowns = dof_handler.n_dofs();
    while (sizes.size() < refinement.n_cycles)
      {
        const MeshSize &last = sizes.back();
        MeshSize        next;
        if (refinement.is_adaptive())
          {
            const double factor = refinement_factor(refinement, dim);
            next                = {factor * last.cells, factor * last.unknowns};
          }
        else
          {
            entities.refine();
            next = size_of();
          }
        if (!refinement.allows(last.unknowns +
                               estimated_unknowns(next.cells - last.cells, fe)))
          break;
        sizes.push_back(next);
      }
    if (refinement.n_over_contact_radius > 0)
      {
        MeshSize     following = sizes.back();
        const double n_cells =
          cells_around_contact<dim>(refinement.n_over_contact_radius);
        following.cells += n_cells;
        following.unknowns += estimated_unknowns(n_cells, fe);
        sizes.push_back(following);
      }
    return sizes;
  }



  template <int dim>
  double
  JobPreview<dim>::n_candidates() const
  {
    Supports<dim> supports(quick);
    supports.reinit(dof_handler);
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    const LinearAlgebra::distributed::Vector<double> layout(
      dof_handler.locally_owned_dofs(), relevant, MPI_COMM_SELF);
    ContactSet<dim> contact_set(vertical_bounds<dim>(
                                  [this](const Point<dim> &x) {
                                    return gap_function.value(x);
                                  }),
                                quick.strain_model.kinematics);
    contact_set.reinit(dof_handler,
                       supports.constraints(),
                       quick.boundary_conditions.ids(
                         BoundaryConditionType::contact),
                       supports.fixed_dofs(),
                       layout);
    return contact_set.n_candidates() *
           std::pow(2., (dim - 1) * n_refinements_left_out);
  }



  template <int dim>
  std::map<types::material_id, typename JobPreview<dim>::Share>
  JobPreview<dim>::materials() const
  {
    std::map<types::material_id, Share> shares;
    Share                               sum = {0., 0.};
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const double volume =
          cell->measure() *
          out_of_plane_length(cell->center(), quick.strain_model.kinematics);
        for (Share *share : {&shares[cell->material_id()], &sum})
          {
            share->cells += 1;
            share->volume += volume;
          }
      }
    for (auto &[id, share] : shares)
      share = {share.cells / sum.cells, share.volume / sum.volume};
    return shares;
  }



  template <int dim>
  unsigned int
  JobPreview<dim>::n_steps() const
  {
    TimeSteps steps(quick.load_program.segment_ends(),
                    parameters.loading.n_steps,
                    0);
    while (!steps.finished())
      steps.advance();
    return steps.number() - 1;
  }



  // The size of a face is the root of its area; if the middle of none is
  // within the radius, that of the nearest.
  template <int dim>
  double
  JobPreview<dim>::size_of_elements_within(const double radius) const
  {
    const auto boundaries =
      quick.boundary_conditions.ids(BoundaryConditionType::contact);
    double sum = 0, nearest = std::numeric_limits<double>::max(),
           area_of_nearest = 0;
    unsigned int n         = 0;
    for (const auto &[cell, f] : owned_faces(triangulation, boundaries))
      {
        const auto         face = cell->face(f);
        Tensor<1, dim - 1> offset;
        for (unsigned int d = 0; d < dim - 1; ++d)
          offset[d] = face->center()[d] - gap_function.position()[d];
        if (offset.norm() <= radius)
          {
            sum += face->measure();
            ++n;
          }
        if (offset.norm() < nearest)
          {
            nearest         = offset.norm();
            area_of_nearest = face->measure();
          }
      }
    return std::pow(n > 0 ? sum / n : area_of_nearest, 1. / (dim - 1)) /
           std::pow(2., n_refinements_left_out);
  }



  template <int dim>
  std::optional<typename JobPreview<dim>::Contact>
  JobPreview<dim>::expected_contact() const
  {
    const auto depth = largest_load(quick.load_program,
                                    TimeSteps(quick.load_program.segment_ends(),
                                              parameters.loading.n_steps,
                                              0),
                                    Control::depth);
    if (!depth)
      return {};
    const auto radius = contact.radius_at_surface(*depth);
    const bool is_level =
      are_level(triangulation,
                quick.boundary_conditions.ids(BoundaryConditionType::contact));
    if (!radius || !is_level)
      return {};
    return Contact{*depth,
                   *radius,
                   *radius / size_of_elements_within(*radius),
                   contact.slope(*radius)};
  }



  template <int dim>
  bool
  JobPreview<dim>::has_mixed_form() const
  {
    return parameters.linear_solver.type == Preconditioner::multigrid &&
           quick.strain_model.kinematics != Kinematics::plane_stress &&
           std::any_of(quick.materials.begin(),
                       quick.materials.end(),
                       is_nearly_incompressible);
  }



  template <int dim>
  typename JobPreview<dim>::Cost
  JobPreview<dim>::expected_cost() const
  {
    const std::vector<MeshSize> sizes   = meshes();
    double                      largest = sizes.back().unknowns;
    const double                limit   = parameters.refinement.max_unknowns;
    if (parameters.refinement.adaptation_interval > 0)
      largest = std::max(largest, limit);
    else if (limit > 0)
      largest = std::min(largest, limit);
    double n_solved = (n_steps() - 1.) * largest;
    for (const MeshSize &size : sizes)
      n_solved += size.unknowns;
    CostPerUnknown cost = cost_per_unknown(dim, fe.degree);
    if (has_mixed_form())
      cost.kilobytes += kilobytes_of_mixed_form;
    if (quick.strain_model.has_nominal_tangents())
      cost.kilobytes += kilobytes_of_nominal_tangents(dim);
    if (dim == 3 && (parameters.geometry.type != "box" ||
                     parameters.geometry.box.circle_radius > 0))
      cost.kilobytes += kilobytes_of_other_cells;
    if (quick.strain_model.is_finite())
      cost.microseconds *= time_of_finite_strain;
    return {cost.kilobytes * largest / 1024,
            1e-6 * cost.microseconds * n_solved};
  }



  template class JobPreview<2>;
  template class JobPreview<3>;
} // namespace ElastoPlastic
