// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_element_tractions_h
#define tests_element_tractions_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "bounds/stress/johnson_mercier.h"

/// Stresses of JohnsonMercier and their tractions on the faces of a simplex,
/// which the program takes from fields.
template <int dim>
struct ElementTractions
{
  using Element = ElastoPlastic::JohnsonMercier<dim>;

  /// Coefficients of the tractions on all faces.
  static constexpr unsigned int
  size(const unsigned int degree)
  {
    return Element::n_parts * dim * Element::n_face_points(degree);
  }

  /// A @p component of coefficient @p i of the traction on a @p face, whose
  /// corners are in the order of corner_of_face().
  static constexpr unsigned int
  index(const unsigned int degree,
        const unsigned int face,
        const unsigned int i,
        const unsigned int component)
  {
    return dim * (Element::n_face_points(degree) * face + i) + component;
  }

  /// What turns values into these coefficients; the normals point outwards.
  static dealii::FullMatrix<double>
  matrix(const ElastoPlastic::Corners<dim> &corners, const unsigned int degree)
  {
    using namespace ElastoPlastic;
    dealii::FullMatrix<double> result(size(degree), Element::n_values(degree));
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      {
        std::array<unsigned int, dim> places; // of the corners in part k
        for (unsigned int j = 0; j < dim; ++j)
          places[j] = place_in_part<dim>(k, corner_of_face<dim>(k, j));
        dealii::Tensor<1, dim> normal =
          -gradients(corners)[opposite_corner<dim>(k)];
        normal /= normal.norm();
        for (unsigned int i = 0; i < Element::n_face_points(degree); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              result(
                index(degree, k, i, d),
                Element::value_index(
                  degree, k, Element::number_on_face(degree, places, i)) +
                  dealii::SymmetricTensor<2, dim>::component_to_unrolled_index(
                    dealii::TableIndices<2>(d, e))) += normal[e];
      }
    return result;
  }

  /// The coefficient number @p i on a @p part of a stress of any degree.
  static dealii::SymmetricTensor<2, dim>
  coefficient(const dealii::Vector<double> &values,
              const unsigned int            part,
              const unsigned int            i)
  {
    const unsigned int first =
      values.size() / Element::n_parts * part + Element::n_components * i;
    dealii::SymmetricTensor<2, dim> stress;
    for (unsigned int c = 0; c < Element::n_components; ++c)
      stress.access_raw_entry(c) = values[first + c];
    return stress;
  }
};

#endif
