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
  /// significant digits, every row handed to the system before the program goes
  /// on. Written by the first rank; all ranks call all functions.
  class CsvFile
  {
  public:
    /// Creates the file with the names of its columns, or goes on after the
    /// first @p n_rows rows of the one that is there.
    /// @throws FileError, on all ranks, if that is not possible; InputError,
    /// likewise, if there are not as many rows, complete and of these columns.
    CsvFile(const MPI_Comm                  communicator,
            const std::string              &name,
            const std::vector<std::string> &columns,
            const unsigned int              n_rows = 0);

    /// Appends one row. @throws FileError, on all ranks, if it cannot be
    /// written.
    void
    add_row(const std::vector<double> &values);

    /// Waits until all rows are on the disk. @throws FileError, on all ranks,
    /// if that is not possible.
    void
    write_to_disk() const;

    /// The number of rows so far.
    unsigned int
    n_rows() const
    {
      return row_count;
    }

  private:
    const MPI_Comm    communicator;
    const std::string name;
    unsigned int      row_count;
    std::ofstream     file;
  };
} // namespace ElastoPlastic

#endif
