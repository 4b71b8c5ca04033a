// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The matrices by which programs know Hill's criterion against what checks ask
// the criterion itself: norms of stresses, and the work of rates and of slips;
// and that of von Mises, whose norms are those of deviators.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "bounds/body/yield_matrices.h"
#include "bounds/body/yield_norms.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double rounding = 1e-12;



  Tensor<2, 3>
  rotation(const double angle, const unsigned int axis)
  {
    const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Tensor<2, 3>       result;
    result[axis][axis] = 1.;
    result[i][i] = result[j][j] = std::cos(angle);
    result[j][i]                = std::sin(angle);
    result[i][j]                = -std::sin(angle);
    return result;
  }



  Material<double>
  material(const HillRatios &ratios, const Tensor<2, 3> &axes)
  {
    Material<double> result;
    result.bulk_modulus      = 800.;
    result.shear_modulus     = 400.;
    result.yield_radius      = std::sqrt(2. / 3.);
    result.isotropic_modulus = 0.;
    result.criteria[0] =
      std::make_shared<GeneralCriterion>(HillCriterion(ratios, axes));
    return result;
  }



  /// Stresses or rates, of which in the plane there is no shear out of it.
  template <int dim>
  std::vector<SymmetricTensor<2, 3>>
  samples()
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> number(-1., 1.);
    std::vector<SymmetricTensor<2, 3>>     result(50);
    for (auto &tensor : result)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          if (dim == 3 || j < 2 || i == j)
            tensor[i][j] = number(generator);
    return result;
  }



  /// The norm of what a matrix makes of the components, each counting once.
  template <int dim>
  double
  norm(const FullMatrix<double> &matrix, const SymmetricTensor<2, 3> &tensor)
  {
    Vector<double> components(matrix.n()), product(matrix.m());
    for (unsigned int c = 0; c < (dim == 2 ? 2 : 3); ++c)
      components[c] = tensor[c][c];
    components[dim == 2 ? 2 : 3] = tensor[0][1];
    if (dim == 2)
      components[3] = tensor[2][2];
    else
      {
        components[4] = tensor[0][2];
        components[5] = tensor[1][2];
      }
    matrix.vmult(product, components);
    return product.l2_norm();
  }



  template <int dim>
  void
  test_norms(const Material<double> &material)
  {
    const RateNorm rate_norm(material);
    double         of_stresses = 0., of_rates = 0., duality = 0.;
    for (const auto &tensor : samples<dim>())
      {
        const double q = stress_norm(material, tensor);
        of_stresses =
          std::max(of_stresses,
                   std::abs(norm<dim>(stress_matrix<dim>(material), tensor) -
                            q));
        const auto   rate = deviator(tensor);
        const double work = rate_norm(rate);
        of_rates =
          std::max(of_rates,
                   std::abs(norm<dim>(rate_matrix<dim>(material), rate) -
                            work));
        for (const auto &stress : samples<dim>())
          duality =
            std::max(duality,
                     stress * rate / stress_norm(material, stress) - work);
      }
    verify("stresses", of_stresses, rounding);
    verify("rates", of_rates, rounding);
    verify("no stress does more work", duality, rounding);
  }



  // Any other stress out of plane makes the norm larger.
  void
  test_plane_strain(const Material<double> &material)
  {
    const auto weights = weights_out_of_plane(material);
    bool       is_less = true;
    for (auto stress : samples<2>())
      {
        stress[2][2] = weights[0] * stress[0][0] + weights[1] * stress[1][1] +
                       weights[2] * stress[0][1];
        const double least = stress_norm(material, stress);
        for (const double change : {-0.01, 0.01})
          {
            auto other = stress;
            other[2][2] += change;
            is_less = is_less && least < stress_norm(material, other);
          }
      }
    verify("stress out of plane", is_less);
  }



  template <int dim>
  SplitBody<dim>
  body_of(const std::vector<Material<double>> &materials)
  {
    Triangulation<dim> block;
    GridGenerator::subdivided_hyper_cube(
      block, 2, 0., 1., /* colorize = */ true);
    for (const auto &cell : block.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 0.5 ? 0 : 1);
    SplitBody<dim> body;
    body.mesh = make_split_mesh(block);
    for (const auto &simplex : body.mesh.simplices)
      body.materials.push_back(
        materials[body.mesh.cells[simplex.cell].material_id]);
    return body;
  }



  // The check takes the neighbour that asks for less work of each slip, the
  // program in space that whose form is smaller on an average.
  template <int dim>
  void
  test_slips(const std::vector<Material<double>> &materials)
  {
    const auto body = body_of<dim>(materials);
    double     same = 0., less = 0.;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      {
        const SlipNorm<dim> slip_norm(body, f);
        const auto          directions = tangents(body.corners_of_face(f));
        for (const double angle : {0., 0.5, 1., 2., 3.})
          {
            Vector<double> components(dim - 1), product(dim - 1);
            components[0]       = dim == 2 ? 1. : std::cos(angle);
            components[dim - 2] = dim == 2 ? 1. : std::sin(angle);
            Tensor<1, dim> slip;
            for (unsigned int d = 0; d < dim - 1; ++d)
              slip += components[d] * directions[d];
            const double work  = slip_norm(slip);
            double       least = 1e9;
            for (unsigned int i = 0; i < body.mesh.faces[f].n_neighbors(); ++i)
              {
                const unsigned int t = body.mesh.faces[f].neighbors[i];
                slip_factor(body, f, t).vmult(product, components);
                least =
                  std::min(least,
                           std::sqrt(0.5) * body.materials[t].yield_radius /
                             body.shear_strength(f) * product.l2_norm());
              }
            same = std::max(same, std::abs(least - work));
            if constexpr (dim == 3)
              {
                slip_factor(body, f).vmult(product, components);
                less = std::max(less, work - product.l2_norm());
              }
          }
      }
    verify("slips", same, rounding);
    if (dim == 3)
      verify("not more than with one of the forms", less, rounding);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const HillRatios   ratios = {{0.9, 1.2, 1.05, 0.7, 0.95, 1.3}};
  const Tensor<2, 3> turned = rotation(0.5, 2);
  const Tensor<2, 3> askew  = turned * rotation(0.8, 0) * rotation(0.2, 2);
  const Tensor<2, 3> none   = rotation(0., 2);
  const HillRatios   ones   = {{1., 1., 1., 1., 1., 1.}};

  output() << "Plane" << std::endl;
  for (const auto &sheet : {material(ratios, turned), material(ones, none)})
    {
      test_norms<2>(sheet);
      test_plane_strain(sheet);
    }
  test_slips<2>({material(ratios, turned), material(ratios, none)});
  output() << "Space" << std::endl;
  test_norms<3>(material(ratios, askew));
  test_slips<3>({material(ratios, askew), material(ratios, none)});

  output() << "Von Mises" << std::endl;
  auto plain        = material(ones, none);
  plain.criteria[0] = nullptr;
  test_norms<2>(plain);
  test_norms<3>(plain);
  test_plane_strain(plain);
  test_slips<2>({plain, plain});
  test_slips<3>({plain, plain});

  // Von Mises resists less in some directions of slip, and Hill in others.
  output() << "Von Mises beside Hill" << std::endl;
  test_slips<2>({material(ratios, turned), plain});
  test_slips<3>({material(ratios, askew), plain});
}
