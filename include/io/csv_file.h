// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_csv_file_h
#define io_csv_file_h

#include <fstream>
#include <string>
#include <vector>

#include <mpi.h>

namespace ElastoPlastic
{
  /// A table that grows row by row: comma separated, a header line, 15
  /// significant digits, every row on disk before the program goes on. Written
  /// by the first rank; all ranks call all functions.
  class CsvFile
  {
  public:
    /// Creates the file with the names of its columns.
    /// @throws FileError, on all ranks, if that is not possible.
    CsvFile(const MPI_Comm                  communicator,
            const std::string              &name,
            const std::vector<std::string> &columns);

    /// Appends one row. @throws FileError, on all ranks, if it cannot be
    /// written.
    void
    add_row(const std::vector<double> &values);

  private:
    const MPI_Comm    communicator;
    const std::string name;
    std::ofstream     file;
  };
} // namespace ElastoPlastic

#endif
