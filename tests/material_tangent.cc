// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The consistent tangent against central differences of the stress, in space
// and in plane strain, for all laws, from virgin and loaded states; and that
// it is symmetric and positive semidefinite, also with another flow direction.
// The flow direction that is predicted from one strain for another. Where back
// stresses recover, the tangent is unsymmetric.

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include "base/tensors.h"
#include "sample_material.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Orthonormal basis of the symmetric tensors: an eigenvalue of a tangent
  /// does not depend on it, unlike in Voigt's notation.
  template <int dim>
  SymmetricTensor<2, dim>
  basis_tensor(const unsigned int i)
  {
    SymmetricTensor<2, dim> tensor;
    tensor.access_raw_entry(i) = (i < dim ? 1. : std::sqrt(0.5));
    return tensor;
  }



  /// A point with bulk modulus, whose strain lives in @p dim dimensions.
  template <int dim>
  class PointLaw
  {
  public:
    using Tensor = SymmetricTensor<2, dim>;

    PointLaw(const Material<double>      &material,
             const MaterialState<double> &old_state)
      : material(material)
      , old_state(old_state)
    {}

    Tensor
    stress(const Tensor &strain) const
    {
      return with_pressure(in_plane<dim>(at(strain).deviatoric_stress()),
                           strain);
    }

    SymmetricTensor<2, 3>
    flow_direction(const Tensor &strain) const
    {
      return at(strain).flow_direction();
    }

    SymmetricTensor<2, 3>
    predicted_flow(const Tensor &strain, const Tensor &increment) const
    {
      return at(strain).predicted_flow(flow_direction(strain),
                                       deviator_of(increment));
    }

    /// The stress increment that the tangent with the given flow direction
    /// promises.
    Tensor
    tangent_product(const Tensor                &strain,
                    const SymmetricTensor<2, 3> &flow,
                    const Tensor                &increment) const
    {
      return with_pressure(
        in_plane<dim>(in_plane_tangent(at(strain).tangent().with_flow(flow))
                        .product(in_space<dim>(increment, 0.), 0.5)),
        increment);
    }

    /// The same for an unsymmetric tangent.
    Tensor
    unsymmetric_product(const Tensor                &strain,
                        const SymmetricTensor<2, 3> &flow,
                        const Tensor                &increment) const
    {
      return with_pressure(
        in_plane<dim>(in_plane_tangent(at(strain).tangent().with_flow(flow))
                        .product(in_space<dim>(increment, 0.), 0.)),
        increment);
    }

    bool
    yields(const Tensor &strain) const
    {
      return at(strain).plastic(1.) > 0.;
    }

  private:
    RadialReturn<double>
    at(const Tensor &strain) const
    {
      return RadialReturn<double>(material, deviator_of(strain), old_state);
    }

    static DeviatoricTangent<dim, double>
    in_plane_tangent(const DeviatoricTangent<3, double> &tangent)
    {
      return {tangent.shear,
              in_plane<dim>(tangent.normal),
              in_plane<dim>(tangent.flow)};
    }

    static SymmetricTensor<2, 3>
    deviator_of(const Tensor &strain)
    {
      return strain_deviator(in_space<dim>(strain, 0.));
    }

    Tensor
    with_pressure(Tensor stress, const Tensor &strain) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        stress[d][d] += material.bulk_modulus * trace(strain);
      return stress;
    }

    const Material<double>      material;
    const MaterialState<double> old_state;
  };



  /// Compares product(direction) with differences of the stress.
  template <int dim, typename Product>
  double
  difference_error(const PointLaw<dim>           &law,
                   const SymmetricTensor<2, dim> &strain,
                   const Product                 &tangent_product)
  {
    const double step  = 1e-7;
    double       error = 0;
    for (unsigned int i = 0; i < strain.n_independent_components; ++i)
      {
        const auto direction = basis_tensor<dim>(i);
        const auto product   = tangent_product(direction);
        const auto quotient  = (law.stress(strain + step * direction) -
                               law.stress(strain - step * direction)) /
                              (2. * step);
        error = std::max(error, (quotient - product).norm() / product.norm());
      }
    return error;
  }



  /// The matrix of @p product.
  template <int dim, typename Product>
  LAPACKFullMatrix<double>
  matrix_of(const Product &product)
  {
    const unsigned int n = SymmetricTensor<2, dim>::n_independent_components;
    LAPACKFullMatrix<double> matrix(n, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        matrix(i, j) = basis_tensor<dim>(i) * product(basis_tensor<dim>(j));
    return matrix;
  }



  double
  asymmetry(const LAPACKFullMatrix<double> &matrix)
  {
    double error = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        error = std::max(error, std::abs(matrix(i, j) - matrix(j, i)));
    return error / matrix.frobenius_norm();
  }



  bool
  is_positive_semidefinite(LAPACKFullMatrix<double> matrix)
  {
    const double       scale = matrix.frobenius_norm();
    Vector<double>     eigenvalues;
    FullMatrix<double> eigenvectors;
    matrix.compute_eigenvalues_symmetric(
      -1e-13 * scale, 2. * scale, 0., eigenvalues, eigenvectors);
    return eigenvalues.size() == matrix.m();
  }



  /// The remainder of a first-order prediction falls with the square of the
  /// increment.
  template <int dim>
  bool
  predicts_flow_to_first_order(const PointLaw<dim>           &law,
                               const SymmetricTensor<2, dim> &strain)
  {
    const auto increment = 0.1 * strain.norm() * sample_tensor<dim>(6, 1.);
    const auto remainder = [&](const double factor) {
      return (law.predicted_flow(strain, factor * increment) -
              law.flow_direction(strain + factor * increment))
        .norm();
    };
    return remainder(0.) < 1e-14 &&
           remainder(1e-2) < 0.011 * remainder(1e-1) + 1e-14;
  }



  /// A flow direction that Newton's method may arrive at.
  SymmetricTensor<2, 3>
  other_flow(const SymmetricTensor<2, 3> &flow)
  {
    SymmetricTensor<2, 3> other = flow;
    other[0][0] -= 0.3;
    other[1][1] += 0.3;
    other[0][1] += 0.2;
    return other / std::max(1., other.norm());
  }



  template <int dim>
  void
  check_point(const PointLaw<dim>           &law,
              const SymmetricTensor<2, dim> &strain,
              const std::string             &state)
  {
    output() << "  " << dim << "D, " << state << ", "
             << (law.yields(strain) ? "plastic" : "elastic") << std::endl;
    const auto consistent_product = [&](const auto &increment) {
      return law.tangent_product(strain, law.flow_direction(strain), increment);
    };
    verify("    derivative of the stress",
           difference_error(law, strain, consistent_product),
           1e-6);
    verify("    flow predicted to first order",
           predicts_flow_to_first_order(law, strain));
    const auto flow = law.flow_direction(strain);
    for (const auto &q : {flow, other_flow(flow)})
      {
        const auto matrix = matrix_of<dim>([&](const auto &increment) {
          return law.tangent_product(strain, q, increment);
        });
        verify("    symmetric", asymmetry(matrix), 1e-14);
        verify("    positive semidefinite", is_positive_semidefinite(matrix));
      }
  }



  template <int dim>
  void
  check_nonlinear_point(const PointLaw<dim>           &law,
                        const SymmetricTensor<2, dim> &strain,
                        const std::string             &state)
  {
    const auto product = [&](const auto &increment) {
      return law.unsymmetric_product(strain,
                                     law.flow_direction(strain),
                                     increment);
    };
    output() << "  " << dim << "D, " << state << ", "
             << (law.yields(strain) ? "plastic" : "elastic") << ", "
             << (asymmetry(matrix_of<dim>(product)) > 1e-6 ? "unsymmetric" :
                                                             "symmetric")
             << std::endl;
    verify("    derivative of the stress",
           difference_error(law, strain, product),
           1e-6);
    verify("    flow predicted to first order",
           predicts_flow_to_first_order(law, strain));
  }



  /// Calls @p check with points of the material under several strains.
  template <int dim, typename Check>
  void
  check_law(const Material<double> &material, const Check &check_point)
  {
    const auto small = sample_tensor<dim>(5, 1e-4);
    const auto large = sample_tensor<dim>(5, 0.02);

    const PointLaw<dim> virgin(
      material, MaterialState<double>(material.back_stresses.size()));
    check_point(virgin, small, "virgin");
    check_point(virgin, large, "virgin");

    // in plane strain, a state that plane strain can have led to
    MaterialState<double> state = sample_state(material);
    if (dim == 2)
      {
        for (auto &tensor : state.back_stresses)
          tensor[0][2] = tensor[1][2] = 0.;
        state.plastic_strain[0][2] = state.plastic_strain[1][2] = 0.;
      }
    const PointLaw<dim> loaded(material, state);
    check_point(loaded, in_plane<dim>(state.plastic_strain) + small, "loaded");
    check_point(loaded, large, "loaded");
    check_point(loaded, -large, "loaded, reversed");
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto check_predicted = [](const auto &...arguments) {
    check_point(arguments...);
  };
  const auto check_nonlinear = [](const auto &...arguments) {
    check_nonlinear_point(arguments...);
  };
  std::vector<std::string> concave = all_laws;
  for (const std::string law : {"Voce", "power law", "table"})
    concave.push_back(law);
  for (const std::string &law : concave)
    {
      output() << law << std::endl;
      check_law<2>(sample_material(law), check_predicted);
      check_law<3>(sample_material(law), check_predicted);
    }
  output() << "Nonlinear laws, unsymmetric products" << std::endl;
  for (const std::string &law : nonlinear_laws)
    {
      output() << law << std::endl;
      check_law<2>(sample_material(law), check_nonlinear);
      check_law<3>(sample_material(law), check_nonlinear);
    }
}
