// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef app_job_preview_h
#define app_job_preview_h

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <map>
#include <optional>
#include <vector>

#include "contact/gap_function.h"
#include "evaluation/nominal_contact.h"
#include "input/parameters.h"
#include "problem/model.h"

namespace ElastoPlastic
{
  /// What a contact problem will be, found before its meshes are made: on its
  /// first mesh if that is small, and otherwise on one with fewer initial
  /// refinements, from which the numbers of the first one follow (exactly, if
  /// there are no local refinements). Each rank finds the same for itself.
  template <int dim>
  class JobPreview
  {
  public:
    /// @throws InputError for what is wrong with the mesh.
    JobPreview(const Model<dim> &model, const Parameters &parameters);

    /// The problem on the mesh that has been looked at.
    const Model<dim> &
    quick_model() const
    {
      return quick;
    }

    /// Whether that is the first mesh of the problem.
    bool
    is_first_mesh() const
    {
      return n_refinements_left_out == 0;
    }

    struct MeshSize
    {
      double cells, unknowns;
    };

    /// The meshes of the first load step. They are known exactly as long as all
    /// cells are refined; an adaptive mesh is taken to grow by what the
    /// refinement fractions say.
    std::vector<MeshSize>
    meshes() const;

    /// The nodes of the first mesh that the indenter may touch.
    double
    n_candidates() const;

    struct Share
    {
      double cells, volume; ///< fractions of the whole
    };

    /// By material id.
    std::map<types::material_id, Share>
    materials() const;

    unsigned int
    n_steps() const;

    struct Contact
    {
      double                depth;
      double                radius;
      double                n_elements; ///< of the first mesh, over the radius
      std::optional<double> slope;      ///< of the indenter there
    };

    /// The contact at the largest depth that is prescribed, if the indenter
    /// has a single tip: where it cuts the undeformed surface.
    std::optional<Contact>
    expected_contact() const;

    struct Cost
    {
      double megabytes;         ///< of all ranks, without what each needs alone
      double processor_seconds; ///< of all ranks
    };

    /// By what has been measured per unknown (doc/trust, "What
    /// --validate expects").
    Cost
    expected_cost() const;

  private:
    double
    size_of_elements_within(const double radius) const;

    /// Whether linear systems have pressures as well (SolidOperator).
    bool
    has_mixed_form() const;

    const Parameters  &parameters;
    const Model<dim>   quick;
    const unsigned int n_refinements_left_out;

    parallel::distributed::Triangulation<dim> triangulation;
    const GapFunction<dim>                    gap_function;
    const NominalContact<dim>                 contact;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
  };
} // namespace ElastoPlastic

#endif
