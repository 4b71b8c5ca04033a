// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <memory>
#include <sstream>

#include "base/exceptions.h"
#include "base/expression.h"
#include "base/throw_together.h"
#include "mesh/material_ids.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    class MaterialIds
    {
    public:
      MaterialIds(const std::string &path,
                  const std::string &text,
                  const int          level)
        : path(path)
        , text(text)
        , expression(path, text)
        , level(level)
      {}

      /// Cells come level by level, so that a parent has its id before its
      /// children.
      void
      apply_to(Triangulation<dim> &triangulation) const
      {
        for (const auto &cell : triangulation.cell_iterators())
          cell->set_material_id(cell->level() <= level ?
                                  value(cell->center()) :
                                  cell->parent()->material_id());
      }

    private:
      types::material_id
      value(const Point<dim> &centre) const
      {
        const double rounded = std::round(expression.value(centre));
        if (rounded < 0 || rounded >= numbers::invalid_material_id)
          {
            std::ostringstream remedy;
            remedy << "at the centre (" << centre << ") of a cell its value "
                   << rounded << " is no number of a material. It must be "
                   << "0 for the first material, 1 for the second, and so on.";
            throw InputError(path, text, remedy.str());
          }
        return static_cast<types::material_id>(rounded);
      }

      const std::string     path;
      const std::string     text;
      const Expression<dim> expression;
      const int             level;
    };
  } // namespace



  template <int dim>
  void
  set_material_ids(const std::string  &path,
                   const std::string  &text,
                   const int           level,
                   Triangulation<dim> &triangulation)
  {
    const auto ids = std::make_shared<MaterialIds<dim>>(path, text, level);

    throw_together(triangulation.get_communicator(),
                   [&]() { ids->apply_to(triangulation); });
    triangulation.signals.post_refinement.connect(
      [ids, &triangulation]() { ids->apply_to(triangulation); });
  }



  template void
  set_material_ids(const std::string &,
                   const std::string &,
                   const int,
                   Triangulation<2> &);
  template void
  set_material_ids(const std::string &,
                   const std::string &,
                   const int,
                   Triangulation<3> &);
} // namespace ElastoPlastic
