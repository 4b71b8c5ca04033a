// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables keep 15 digits, and a file that cannot be written completely is an
// error on all ranks, whichever of them was writing.

#include <filesystem>
#include <fstream>
#include <limits>

#include "output/checked_write.h"
#include "output/csv_file.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  void
  write_table()
  {
    const std::string name = "table.csv";
    CsvFile           table(MPI_COMM_WORLD, name, {"step", "force", "depth"});
    table.open();
    table.add_rows({{1, 1. / 3., 1.5e-20}});
    table.add_rows({{2, -12345678.9012345, 1e300},
                    {100000000, 0, std::numeric_limits<double>::infinity()}});

    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      output() << std::ifstream(name).rdbuf();
  }



  /// Prints the common message of all ranks, or what is wrong with that.
  template <typename Action>
  void
  print_error_of_all_ranks(const std::string &title, const Action &action)
  {
    std::string message = "none";
    try
      {
        action();
      }
    catch (const Error &error)
      {
        message = error.what();
      }
    const auto messages =
      dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, message);
    for (const std::string &other : messages)
      if (other != message)
        message = "FAILED, the ranks disagree: " + message + " / " + other;
    output() << title << ": " << message << std::endl;
  }



  /// Goes on after two rows of a table that holds @p text.
  void
  go_on(const std::string &title, const std::string &text)
  {
    const std::string name = "continued.csv";
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::ofstream(name) << text;
    MPI_Barrier(MPI_COMM_WORLD);
    print_error_of_all_ranks(title, [&] {
      CsvFile table(MPI_COMM_WORLD, name, {"step", "force"}, 2);
      table.open();
      table.add_rows({{3, 0.75}});
    });
  }



  void
  write_on_rank(const unsigned int rank, const std::string &name)
  {
    const bool writes =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == rank;
    checked_write(MPI_COMM_WORLD, writes ? name : "", [](std::ostream &out) {
      out << "some text";
    });
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int                       last_rank =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;

  write_table();

  print_error_of_all_ranks("table on a full disk", [] {
    CsvFile(MPI_COMM_WORLD, "/dev/full", {"step"}).open();
  });
  print_error_of_all_ranks("table in a missing directory", [] {
    CsvFile(MPI_COMM_WORLD, "no/such/directory.csv", {"step"}).open();
  });
  print_error_of_all_ranks("table in a directory that is removed", [] {
    on_first_rank([] { std::filesystem::create_directory("removed"); });
    CsvFile table(MPI_COMM_WORLD, "removed/table.csv", {"step"});
    table.open();
    on_first_rank([] { std::filesystem::remove_all("removed"); });
    table.add_rows({{1}});
    table.write_to_disk();
  });
  print_error_of_all_ranks("text on a full disk",
                           [&] { write_on_rank(0, "/dev/full"); });
  print_error_of_all_ranks("text of the last rank on a full disk",
                           [&] { write_on_rank(last_rank, "/dev/full"); });
  print_error_of_all_ranks("text on a disk with room",
                           [&] { write_on_rank(last_rank, "text.txt"); });

  const std::string header = "step,force\n";
  go_on("continued", header + "1,0.25\n2,inf\n3,1\n4,1\n");
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    output() << std::ifstream("continued.csv").rdbuf();
  MPI_Barrier(MPI_COMM_WORLD);
  go_on("from Windows", "step,force\r\n1,0.25\r\n2,0.5\r\n");
  go_on("with a mark", "\xEF\xBB\xBF" + header + "1,0.25\n2,0.5\n");
  go_on("too few rows", header + "1,0.25\n");
  go_on("cut in the last number", header + "1,0.25\n2,0.");
  go_on("cut in the last row", header + "1,0.25\n2,\n");
  go_on("one number too many", header + "1,0.25,3\n2,0.5\n");
  go_on("zeroed", header + "1,0.25\n" + std::string(6, '\0') + "\n");
  go_on("another header", "step,depth\n1,0.25\n2,0.5\n");
  go_on("empty", "");
}
