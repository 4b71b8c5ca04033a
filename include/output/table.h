// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_table_h
#define output_table_h

#include <functional>
#include <optional>

#include "output/csv_file.h"

namespace ElastoPlastic
{
  /// A column of a table whose rows are made of records. The lists of columns
  /// (columns.h) make the header and the rows of a file and its table in
  /// doc/lookup/tables.md.
  template <typename Record>
  struct Column
  {
    std::string                           name;
    std::string                           unit; ///< such as "force"; "1"
    std::string                           meaning;
    std::function<double(const Record &)> value;
  };

  template <typename Record>
  using Columns = std::vector<Column<Record>>;



  /// A CsvFile with a row for each record. All ranks call all functions.
  template <typename Record>
  class CsvTable : public CsvFile
  {
  public:
    /// @p columns must outlive this object. See CsvFile.
    CsvTable(const MPI_Comm         communicator,
             const std::string     &file_name,
             const Columns<Record> &columns,
             const unsigned int     n_rows = 0)
      : CsvFile(communicator, file_name, names(columns), n_rows)
      , columns(columns)
    {}

    /// @throws FileError, on all ranks, if the row cannot be written.
    void
    add(const Record &record)
    {
      add_rows({values(record)});
    }

    /// The same for several rows.
    void
    add_all(const std::vector<Record> &records)
    {
      std::vector<std::vector<double>> rows;
      for (const Record &record : records)
        rows.push_back(values(record));
      add_rows(rows);
    }

  private:
    static std::vector<std::string>
    names(const Columns<Record> &columns)
    {
      std::vector<std::string> result;
      for (const auto &column : columns)
        result.push_back(column.name);
      return result;
    }

    std::vector<double>
    values(const Record &record) const
    {
      std::vector<double> result;
      for (const auto &column : columns)
        result.push_back(column.value(record));
      return result;
    }

    const Columns<Record> &columns;
  };



  /// A CsvTable whose file is there if it has rows only.
  template <typename Record>
  class OptionalCsvTable
  {
  public:
    /// See CsvTable.
    OptionalCsvTable(const MPI_Comm         communicator,
                     const std::string     &file_name,
                     const Columns<Record> &columns,
                     const unsigned int     n_rows)
      : communicator(communicator)
      , file_name(file_name)
      , columns(columns)
    {
      if (n_rows > 0)
        table.emplace(communicator, file_name, columns, n_rows);
    }

    /// @throws FileError, on all ranks, if rows cannot be written.
    void
    add_all(const std::vector<Record> &records)
    {
      if (records.empty())
        return;
      if (!table)
        table.emplace(communicator, file_name, columns).open();
      table->add_all(records);
    }

    unsigned int
    n_rows() const
    {
      return table ? table->n_rows() : 0;
    }

    /// A null pointer without rows.
    CsvFile *
    file()
    {
      return table ? &*table : nullptr;
    }

  private:
    const MPI_Comm                  communicator;
    const std::string               file_name;
    const Columns<Record>          &columns;
    std::optional<CsvTable<Record>> table;
  };
} // namespace ElastoPlastic

#endif
