// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_patches_h
#define output_patches_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Lines, triangles or tetrahedra with fields of their own, which deal.II's
  /// DataOutInterface writes as they are: nothing is smoothed.
  template <int dim, int spacedim = dim>
  class Patches : public DataOutInterface<dim, spacedim>
  {
  public:
    using Patch = DataOutBase::Patch<dim, spacedim>;

    /// A scalar, a vector, or a tensor with nine components.
    struct Field
    {
      std::string  name;
      unsigned int n_components;
    };

    /// The data of all patches are the components of these @p fields.
    explicit Patches(const std::vector<Field> &fields)
      : fields(fields)
    {}

    void
    add(Patch patch)
    {
      patch.patch_index = patches.size();
      patches.push_back(std::move(patch));
    }

    /// The number of components of all fields together.
    unsigned int
    n_components() const
    {
      unsigned int sum = 0;
      for (const Field &field : fields)
        sum += field.n_components;
      return sum;
    }

    bool
    empty() const
    {
      return patches.empty();
    }

  private:
    const std::vector<Patch> &
    get_patches() const override
    {
      return patches;
    }

    std::vector<std::string>
    get_dataset_names() const override
    {
      std::vector<std::string> names;
      for (const Field &field : fields)
        names.insert(names.end(), field.n_components, field.name);
      return names;
    }

    std::vector<
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override
    {
      using namespace DataComponentInterpretation;
      decltype(this->get_nonscalar_data_ranges()) ranges;
      unsigned int                                first = 0;
      for (const auto &[name, n] : fields)
        {
          if (n > 1)
            ranges.emplace_back(first,
                                first + n - 1,
                                name,
                                n == 9 ? component_is_part_of_tensor :
                                         component_is_part_of_vector);
          first += n;
        }
      return ranges;
    }

    const std::vector<Field> fields;
    std::vector<Patch>       patches;
  };
} // namespace ElastoPlastic

#endif
