// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cstdio>

#include "io/checked_write.h"
#include "io/csv_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    /// The first @p n_rows lines after the first one of the file @p name.
    std::string
    first_rows(const std::string &name, const unsigned int n_rows)
    {
      if (n_rows == 0)
        return "";
      std::ifstream file(name);
      std::string   line, rows;
      std::getline(file, line);
      for (unsigned int i = 0; i < n_rows && std::getline(file, line); ++i)
        rows += line + '\n';
      return rows;
    }
  } // namespace



  // The shortened table takes the place of the old one at once: nothing is lost
  // if the program is stopped meanwhile.
  CsvFile::CsvFile(const MPI_Comm                  communicator,
                   const std::string              &name,
                   const std::vector<std::string> &columns,
                   const unsigned int              n_rows)
    : communicator(communicator)
    , name(name)
    , row_count(n_rows)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const std::string rows      = first_rows(name, n_rows);
        const std::string temporary = name + ".new";
        file.open(n_rows > 0 ? temporary : name);
        file.precision(15);
        for (unsigned int i = 0; i < columns.size(); ++i)
          file << (i > 0 ? "," : "") << columns[i];
        file << '\n' << rows << std::flush;
        if (file && n_rows > 0 &&
            std::rename(temporary.c_str(), name.c_str()) != 0)
          file.setstate(std::ios::failbit);
      }
    check_written(communicator, name, static_cast<bool>(file));
  }



  void
  CsvFile::add_row(const std::vector<double> &values)
  {
    ++row_count;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (unsigned int i = 0; i < values.size(); ++i)
          file << (i > 0 ? "," : "") << values[i];
        file << std::endl;
      }
    check_written(communicator, name, static_cast<bool>(file));
  }
} // namespace ElastoPlastic
