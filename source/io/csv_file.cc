// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include "base/exceptions.h"
#include "io/checked_write.h"
#include "io/csv_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  CsvFile::CsvFile(const MPI_Comm                  communicator,
                   const std::string              &name,
                   const std::vector<std::string> &columns)
    : communicator(communicator)
    , name(name)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        file.open(name);
        file.precision(15);
        for (unsigned int i = 0; i < columns.size(); ++i)
          file << (i > 0 ? "," : "") << columns[i];
        file << std::endl;
      }
    check_written(communicator, name, static_cast<bool>(file));
  }



  void
  CsvFile::add_row(const std::vector<double> &values)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (unsigned int i = 0; i < values.size(); ++i)
          file << (i > 0 ? "," : "") << values[i];
        file << std::endl;
      }
    check_written(communicator, name, static_cast<bool>(file));
  }
} // namespace ElastoPlastic
