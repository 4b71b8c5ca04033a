// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_table_h
#define tests_table_h

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// A row of a table: the numbers by the names of their columns.
using Row = std::map<std::string, double>;

inline std::vector<std::string>
split(const std::string &line)
{
  std::vector<std::string> cells;
  std::istringstream       stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(cell);
  return cells;
}



/// The rows of the file @p name; none if there is no such file.
inline std::vector<Row>
read_table(const std::string &name)
{
  std::ifstream file(name);
  std::string   line;
  std::getline(file, line);
  const auto       columns = split(line);
  std::vector<Row> rows;
  while (std::getline(file, line))
    {
      const auto cells = split(line);
      Row        row;
      for (unsigned int i = 0; i < cells.size(); ++i)
        row[columns.at(i)] = std::stod(cells[i]);
      rows.push_back(row);
    }
  return rows;
}

#endif
