// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/mesh/density_transfer.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A cell, and those that it is a part of, up to one of the coarsest mesh.
    std::vector<CellId>
    line_of_descent(const CellId &cell)
    {
      const auto          children = cell.get_child_indices();
      std::vector<CellId> result;
      for (unsigned int n = children.size() + 1; n-- > 0;)
        result.emplace_back(cell.get_coarse_cell_id(), n, children.data());
      return result;
    }
  } // namespace



  template <int dim>
  DensityTransfer<dim>::DensityTransfer(const SplitMesh<dim>      &mesh,
                                        const std::vector<double> &of_simplices)
  {
    Assert(of_simplices.empty() || of_simplices.size() == mesh.simplices.size(),
           ExcInternalError());
    if (of_simplices.empty())
      return;
    std::vector<Sum> of_cells(mesh.cells.size());
    for (unsigned int t = 0; t < of_simplices.size(); ++t)
      {
        const auto &simplex = mesh.simplices[t];
        of_cells[simplex.cell] +=
          {of_simplices[t], volume(mesh.corners(simplex))};
      }
    for (unsigned int c = 0; c < of_cells.size(); ++c)
      for (const CellId &cell : line_of_descent(mesh.cells[c].id))
        sums[cell] += of_cells[c];
  }



  template <int dim>
  std::vector<double>
  DensityTransfer<dim>::on(const SplitMesh<dim> &mesh) const
  {
    if (sums.empty())
      return {};
    std::vector<double> densities, result;
    for (const auto &cell : mesh.cells)
      for (const CellId &ancestor : line_of_descent(cell.id))
        if (const auto known = sums.find(ancestor); known != sums.end())
          {
            densities.push_back(known->second.value / known->second.volume);
            break;
          }
    AssertDimension(densities.size(), mesh.cells.size());
    for (const auto &simplex : mesh.simplices)
      result.push_back(densities[simplex.cell] * volume(mesh.corners(simplex)));
    return result;
  }



  template class DensityTransfer<2>;
  template class DensityTransfer<3>;
} // namespace ElastoPlastic
