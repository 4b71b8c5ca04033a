// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_csv_file_h
#define output_csv_file_h

#include <fstream>
#include <string>
#include <vector>

#include <mpi.h>

namespace ElastoPlastic
{
  /// A table that grows row by row: comma separated, a header line, 15
  /// significant digits, all rows handed to the system before the program goes
  /// on. Written by the first rank; all ranks call all functions.
  ///
  /// (deal.II's TableHandler keeps all rows and writes them at the end: what a
  /// run has found would be lost with it, and it cannot go on with a file.)
  class CsvFile
  {
  public:
    /// Reads the first @p n_rows rows of the file, if these are not 0.
    /// @throws InputError, on all ranks, if there are not as many rows,
    /// complete and of these columns.
    CsvFile(const MPI_Comm                  communicator,
            const std::string              &name,
            const std::vector<std::string> &columns,
            const unsigned int              n_rows = 0);

    /// Creates the file with the names of its columns, or cuts the one that is
    /// there after the rows that have been read.
    /// @throws FileError, on all ranks, if that is not possible.
    void
    open();

    /// Appends rows; after open(). @throws FileError, on all ranks, if they
    /// cannot be written.
    void
    add_rows(const std::vector<std::vector<double>> &rows);

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
    std::string       contents; ///< of the file, before open()
    std::ofstream     file;
  };
} // namespace ElastoPlastic

#endif
