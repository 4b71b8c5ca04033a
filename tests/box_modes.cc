// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces of a box of degree 1 or 2 whose stress is linear in the
// displacement gradient, mode by mode, against quadrature; with all of the
// gradient, and with the mean of its trace in place of the trace.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <cmath>

#include "mechanics/box_modes.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

namespace
{
  template <int dim, int degree>
  class Box
  {
  public:
    using Modes   = BoxModes<dim, degree, double>;
    using Entries = typename Modes::Entries;
    using Values  = std::array<double, dim * Modes::n_nodes>;

    Box()
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          reciprocals[d] = 1. / (0.3 + d * 0.5);
          volume /= reciprocals[d];
        }
    }

    /// Some linear law; @p trace contributes beside the gradient.
    static Entries
    stress(const Entries &gradient, const double trace)
    {
      Entries result{};
      for (unsigned int i = 0; i < dim * dim; ++i)
        {
          for (unsigned int j = 0; j < dim * dim; ++j)
            result[i] += std::sin(1. + 3. * i + 7. * j) * gradient[j];
          if (i % (dim + 1) == 0)
            result[i] += 5. * trace;
        }
      return result;
    }

    static double
    trace(const Entries &gradient)
    {
      double sum = 0;
      for (unsigned int d = 0; d < dim; ++d)
        sum += gradient[dim * d + d];
      return sum;
    }

    static Values
    some_displacements()
    {
      Values values;
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = std::cos(2. + 5. * i);
      return values;
    }

    /// The law may depend on its mode only by that, as B-bar's does.
    Values
    forces_by_modes(const bool takes_mean_of_trace) const
    {
      Values values = some_displacements();
      Modes(reciprocals, volume)
        .apply(values.data(), [&](const auto mode, const Entries &gradient) {
          const bool has_trace = mode.is_constant || !takes_mean_of_trace;
          return stress(gradient, has_trace ? trace(gradient) : 0.);
        });
      return values;
    }

    Values
    forces_by_quadrature(const bool takes_mean_of_trace) const
    {
      const QGauss<dim> points(degree + 1);
      const FE_Q<dim>   fe(degree);
      const auto        numbers =
        FETools::lexicographic_to_hierarchic_numbering<dim>(degree);
      const Values         values = some_displacements();
      std::vector<Entries> gradients(points.size());
      double               mean = 0;
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          for (unsigned int i = 0; i < values.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              gradients[q][dim * (i / Modes::n_nodes) + d] +=
                slope(fe, numbers[i % Modes::n_nodes], d, points.point(q)) *
                values[i];
          mean += points.weight(q) * trace(gradients[q]);
        }

      Values forces;
      forces.fill(0.);
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const Entries of_point =
            stress(gradients[q],
                   takes_mean_of_trace ? mean : trace(gradients[q]));
          for (unsigned int i = 0; i < forces.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              forces[i] +=
                points.weight(q) * volume *
                slope(fe, numbers[i % Modes::n_nodes], d, points.point(q)) *
                of_point[dim * (i / Modes::n_nodes) + d];
        }
      return forces;
    }

  private:
    double
    slope(const FE_Q<dim>   &fe,
          const unsigned int node,
          const unsigned int d,
          const Point<dim>  &point) const
    {
      return reciprocals[d] * fe.shape_grad(node, point)[d];
    }

    std::array<double, dim> reciprocals;
    double                  volume = 1;
  };



  template <int dim, int degree>
  void
  check()
  {
    for (const bool takes_mean_of_trace : {false, true})
      {
        const Box<dim, degree> box;
        const auto by_modes = box.forces_by_modes(takes_mean_of_trace);
        const auto by_quadrature =
          box.forces_by_quadrature(takes_mean_of_trace);
        double largest = 0, difference = 0;
        for (unsigned int i = 0; i < by_modes.size(); ++i)
          {
            largest = std::max(largest, std::abs(by_quadrature[i]));
            difference =
              std::max(difference, std::abs(by_modes[i] - by_quadrature[i]));
          }
        verify(std::to_string(dim) + "D, degree " + std::to_string(degree) +
                 ", " + (takes_mean_of_trace ? "mean trace" : "whole gradient"),
               difference / largest,
               1e-13);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2, 1>();
  check<2, 2>();
  check<3, 1>();
  check<3, 2>();
}
