// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/p4est_wrappers.h>
#include <deal.II/grid/grid_tools.h>

#include "base/compatibility.h"
#include "multigrid/level_hierarchy.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using P4est = internal::p4est::functions<dim>;

    template <int dim>
    using Forest = typename internal::p4est::types<dim>::forest;



    /// For p4est: to replace all siblings by their parent.
    template <int dim>
    int
    always(Forest<dim> *,
           typename internal::p4est::types<dim>::topidx,
           typename internal::p4est::types<dim>::quadrant **)
    {
      return 1;
    }



    /// Coarsens every cell that can be, but for those that keep neighbours from
    /// differing by more than one level.
    template <int dim>
    void
    coarsen(Forest<dim> &forest)
    {
      P4est<dim>::reset_data(&forest, 0, nullptr, nullptr);
      P4est<dim>::coarsen(&forest,
                          /* recursive = */ 0,
                          always<dim>,
                          nullptr);
      if constexpr (dim == 2)
        P4est<dim>::balance(&forest, P4EST_CONNECT_FULL, nullptr);
      else
        P4est<dim>::balance(&forest, P8EST_CONNECT_FULL, nullptr);
      P4est<dim>::partition(&forest, /* families together = */ 1, nullptr);
    }



    template <int dim>
    std::shared_ptr<const Triangulation<dim>>
    make_mesh(const parallel::distributed::Triangulation<dim> &original,
              const std::vector<types::manifold_id>           &manifolds,
              const Forest<dim>                               &forest)
    {
      auto mesh = std::make_shared<parallel::distributed::Triangulation<dim>>(
        communicator_of(original), original.get_mesh_smoothing());
      const auto [vertices, cells, boundary] =
        GridTools::get_coarse_mesh_description(original);
      mesh->create_triangulation(vertices, cells, boundary);
      for (const auto id : manifolds)
        if (id != numbers::flat_manifold_id)
          mesh->set_manifold(id, original.get_manifold(id));
      mesh->load(&forest);
      return mesh;
    }
  } // namespace



  template <int dim>
  std::vector<std::shared_ptr<const Triangulation<dim>>>
  mesh_sequence(const parallel::distributed::Triangulation<dim> &mesh,
                const unsigned int                               n_coarse_cells)
  {
    std::vector<std::shared_ptr<const Triangulation<dim>>> meshes = {
      {&mesh, [](const auto *) {
       }}};
    const auto manifolds = mesh.get_manifold_ids(); // looks at all faces
    auto      &forest =
      *P4est<dim>::copy_forest(const_cast<Forest<dim> *>(mesh.get_p4est()),
                               /* copy data = */ 0);
    for (unsigned int level = mesh.n_global_levels() - 1;
         level > 0 && forest.global_num_quadrants > n_coarse_cells;
         --level)
      {
        coarsen<dim>(forest);
        meshes.push_back(make_mesh(mesh, manifolds, forest));
      }
    P4est<dim>::destroy(&forest);
    std::reverse(meshes.begin(), meshes.end());
    return meshes;
  }



  template std::vector<std::shared_ptr<const Triangulation<2>>>
  mesh_sequence(const parallel::distributed::Triangulation<2> &,
                const unsigned int);
  template std::vector<std::shared_ptr<const Triangulation<3>>>
  mesh_sequence(const parallel::distributed::Triangulation<3> &,
                const unsigned int);
} // namespace ElastoPlastic
