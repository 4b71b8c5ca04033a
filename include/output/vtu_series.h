// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_vtu_series_h
#define output_vtu_series_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <utility>
#include <vector>

#include "output/checked_write.h"
#include "output/output_parameters.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Files name-*.vtu in the output directory, one for each mesh, and the list
  /// name.pvd of them that ParaView opens, written by one rank.
  class VtuSeries
  {
  public:
    VtuSeries(const OutputParameters &parameters, const std::string &name)
      : directory(parameters.directory)
      , units(parameters.units)
      , name(name)
    {}

    /// @p cycle numbers the file. @throws FileError
    template <int dim, int spacedim>
    void
    write(DataOutInterface<dim, spacedim> &data, const unsigned int cycle)
    {
      DataOutBase::VtkFlags flags;
      flags.compression_level = decltype(flags.compression_level)::best_speed;
      if (units.are_named())
        for (const std::string field : {"stress", "von_mises_stress"})
          flags.physical_units[field] = units.of("stress");
      data.set_flags(flags);

      const std::string file_name =
        name + "-" + Utilities::int_to_string(cycle, 3) + ".vtu";
      checked_write(MPI_COMM_SELF,
                    directory + "/" + file_name,
                    [&](std::ostream &file) { data.write_vtu(file); });
      records.emplace_back(cycle, file_name);
      checked_write(MPI_COMM_SELF,
                    directory + "/" + name + ".pvd",
                    [&](std::ostream &file) {
                      DataOutBase::write_pvd_record(file, records);
                    });
    }

  private:
    const std::string                           directory;
    const Units                                 units;
    const std::string                           name;
    std::vector<std::pair<double, std::string>> records;
  };
} // namespace ElastoPlastic

#endif
