// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "base/exceptions.h"
#include "base/text.h"
#include "output/checked_write.h"
#include "output/csv_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    /// Whether @p line consists of @p n_columns numbers.
    bool
    is_row(const std::string &line, const std::size_t n_columns)
    {
      const auto cells = Utilities::split_string_list(line, ',');
      return cells.size() == n_columns &&
             std::all_of(cells.begin(), cells.end(), as_number);
    }



    /// The lines of the first @p n_rows rows of the file @p name.
    /// @throws InputError if they are not there.
    std::string
    first_rows(const std::string              &name,
               const std::vector<std::string> &columns,
               const unsigned int              n_rows)
    {
      std::ifstream      file(name, std::ios::binary);
      std::istringstream text(
        plain_text({std::istreambuf_iterator<char>(file), {}},
                   [&name](const std::string &what) {
                     throw InputError("The table '" + name + "' " + what);
                   }));
      std::string line, rows;
      // (A line without an end, which is cut, sets the end of the text.)
      bool intact = std::getline(text, line) &&
                    line == boost::algorithm::join(columns, ",");
      unsigned int row = 0;
      for (; intact && row < n_rows; ++row)
        {
          intact = std::getline(text, line) && !text.eof() &&
                   is_row(line, columns.size());
          rows += line + '\n';
        }
      if (!intact)
        throw InputError(
          "The table '" + name +
          "' is not what the interrupted run has left: " +
          (row == 0 ?
             "its header" :
             "row " + std::to_string(row) + " of " + std::to_string(n_rows)) +
          " is missing or damaged. Put the table back, or begin anew with the "
          "option --overwrite instead of --resume.");
      return rows;
    }
  } // namespace



  CsvFile::CsvFile(const MPI_Comm                  communicator,
                   const std::string              &name,
                   const std::vector<std::string> &columns,
                   const unsigned int              n_rows)
    : communicator(communicator)
    , name(name)
    , row_count(n_rows)
    , contents(boost::algorithm::join(columns, ",") + '\n')
  {
    rethrow_collectively(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0 && n_rows > 0)
        contents += first_rows(name, columns, n_rows);
    });
  }



  // The shortened table takes the place of the old one at once: nothing is lost
  // if the program is stopped meanwhile.
  void
  CsvFile::open()
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const std::string temporary = name + ".new";
        file.open(row_count > 0 ? temporary : name);
        file.precision(15);
        file << contents << std::flush;
        if (file && row_count > 0 &&
            std::rename(temporary.c_str(), name.c_str()) != 0)
          file.setstate(std::ios::failbit);
      }
    contents.clear();
    check_written(communicator, name, static_cast<bool>(file));
  }



  void
  CsvFile::add_rows(const std::vector<std::vector<double>> &rows)
  {
    row_count += rows.size();
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (const std::vector<double> &row : rows)
          for (unsigned int i = 0; i < row.size(); ++i)
            file << row[i] << (i + 1 < row.size() ? ',' : '\n');
        file << std::flush;
      }
    check_written(communicator, name, static_cast<bool>(file));
  }



  void
  CsvFile::write_to_disk() const
  {
    const bool first_rank = Utilities::MPI::this_mpi_process(communicator) == 0;
    check_written(communicator,
                  name,
                  !first_rank || ElastoPlastic::write_to_disk(name));
  }
} // namespace ElastoPlastic
