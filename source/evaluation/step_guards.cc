// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/compatibility.h"
#include "base/ghost_values.h"
#include "evaluation/step_guards.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The largest stress at which the material yields in one direction, its
    /// back stresses included, at this equivalent plastic strain.
    double
    largest_yield_stress(const Material<double> &material, const double strain)
    {
      double stress = std::sqrt(1.5) * material.yield_radius +
                      1.5 * material.isotropic_modulus * strain;
      if (material.curves[0])
        stress += material.curves[0]->value(strain);
      for (const auto &[modulus, recovery] : material.back_stresses)
        {
          const double growth = 1.5 * modulus * strain;
          stress += recovery > 0. ?
                      std::min(growth, std::sqrt(1.5) * modulus / recovery) :
                      growth;
        }
      return stress;
    }
  } // namespace



  double
  largest_indentation_pressure(const Material<double> &material,
                               const double            plastic_strain)
  {
    const double yield_stress = largest_yield_stress(material, plastic_strain);
    if (!(yield_stress < std::numeric_limits<double>::infinity()) ||
        is_rate_dependent(material) || has_general_criterion(material))
      return std::numeric_limits<double>::infinity();
    const double K = material.bulk_modulus, G = material.shear_modulus;
    const double E      = 9. * K * G / (3. * K + G);
    const double nu     = E / (2. * G) - 1.;
    const double cavity = 2. / 3. * yield_stress *
                          (1. + std::log(E / (3. * (1. - nu) * yield_stress)));
    return std::max(3. * yield_stress, cavity);
  }



  double
  PressureGuard::limit(const double plastic_strain) const
  {
    double largest = 0;
    for (const Material<double> &material : materials)
      largest =
        std::max(largest,
                 largest_indentation_pressure(material, plastic_strain));
    return factor * largest;
  }



  bool
  PressureGuard::is_exceeded(const double pressure, const double plastic_strain)
  {
    if (was_exceeded || !(pressure > limit(plastic_strain)))
      return false;
    was_exceeded = true;
    return true;
  }



  template <int dim>
  void
  SmallStrainGuard<dim>::compare(const std::string &what,
                                 const double       value,
                                 const double       limit,
                                 std::string       &text)
  {
    if (!(value > limit) || !exceeded.insert(what).second)
      return;
    std::ostringstream comparison;
    comparison.precision(3);
    comparison << what << " is " << value << " (limit: " << limit << ")";
    text += (text.empty() ? "" : ", ") + comparison.str();
  }



  template <int dim>
  std::string
  SmallStrainGuard<dim>::warning(const SolveResult &result)
  {
    std::string text;
    compare("the largest equivalent plastic strain",
            result.max_equivalent_plastic_strain,
            largest_plastic_strain,
            text);
    if (contact.is_single() && contact.radius_at_surface(result.depth) &&
        result.contact_area > 0.)
      {
        const double touched = contact.radius(result.contact_area);
        const auto   slope   = contact.slope(touched);
        if (slope)
          compare("the slope of the indenter at the edge of the contact",
                  *slope,
                  largest_slope,
                  text);
        else if (!contact.is_strip())
          compare("the depth over the contact radius",
                  contact.depth_of_tip(result.depth) / touched,
                  largest_relative_depth,
                  text);
      }
    if (text.empty())
      return text;
    return "Step " + std::to_string(result.step) +
           " leaves the theory of small strains: " + text +
           ". What follows is approximate, most of all at the edge of the "
           "contact; see doc/trust/small_strains.md. "
           "This is not said again.";
  }



  template class SmallStrainGuard<2>;
  template class SmallStrainGuard<3>;



  namespace
  {
    template <int dim>
    using Corners =
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell>;



    /// (The neighbours of a vertex differ from it in one bit of its number.)
    template <int dim>
    double
    scaled_jacobian(const Corners<dim> &corners, const unsigned int v)
    {
      Tensor<2, dim> edges;
      double         lengths = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          edges[d] = corners[v | (1U << d)] - corners[v & ~(1U << d)];
          lengths *= edges[d].norm();
        }
      return lengths > 0 ? determinant(edges) / lengths : 0.;
    }
  } // namespace



  template <int dim>
  ElementQuality<dim>
  worst_element(const DoFHandler<dim>                            &dof_handler,
                const LinearAlgebra::distributed::Vector<double> &displacement)
  {
    const auto          ghosted_u    = ghosted_copy(displacement, dof_handler);
    const MPI_Comm      communicator = communicator_of(dof_handler);
    ElementQuality<dim> worst        = {std::numeric_limits<double>::max(), {}};
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          Corners<dim> corners;
          for (const unsigned int v : cell->vertex_indices())
            {
              corners[v] = cell->vertex(v);
              for (unsigned int d = 0; d < dim; ++d)
                corners[v][d] += ghosted_u(cell->vertex_dof_index(v, d));
            }
          for (const unsigned int v : cell->vertex_indices())
            if (const double value = scaled_jacobian<dim>(corners, v);
                value < worst.scaled_jacobian)
              worst = {value, corners[v]};
        }
    const auto least =
      Utilities::MPI::min_max_avg(worst.scaled_jacobian, communicator);
    return {least.min,
            Utilities::MPI::broadcast(communicator,
                                      worst.place,
                                      least.min_index)};
  }



  template ElementQuality<2>
  worst_element(const DoFHandler<2> &,
                const LinearAlgebra::distributed::Vector<double> &);
  template ElementQuality<3>
  worst_element(const DoFHandler<3> &,
                const LinearAlgebra::distributed::Vector<double> &);
} // namespace ElastoPlastic
