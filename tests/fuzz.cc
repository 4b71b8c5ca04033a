// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// fuzz [NUMBER [SEED]]
//
// Damages good input at random, NUMBER times for each reader, and reads it: it
// must be accepted or refused with an Error. What this test does not see itself
// is seen by the sanitizers of scripts/fuzz.sh, and a reader that hangs by an
// alarm; the input that has done it is in the file 'input'. Same numbers, same
// inputs.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>

#include "base/expression.h"
#include "damage.h"
#include "indenter/height_file.h"
#include "indenter/indenter_parameters.h"
#include "input/parameters.h"
#include "loading/load_program.h"
#include "loads/boundary_conditions.h"
#include "material/material_lists.h"
#include "mesh/gmsh_file.h"
#include "output/csv_file.h"
#include "restart/checkpoint.h"
#include "verdict.h"

#include <unistd.h>

using namespace ElastoPlastic;

namespace
{
  const std::string  input_file      = "input";
  const std::string  png_reader      = "PNG image";
  const unsigned int seconds_to_read = 20;

  std::string
  content(const std::string &name)
  {
    std::ifstream stream(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }



  /// Good files beside the tests.
  std::vector<std::string>
  contents(const std::vector<std::string> &names)
  {
    std::vector<std::string> result;
    for (const std::string &name : names)
      result.push_back(content(SOURCE_DIR "/" + name));
    return result;
  }



  struct Reader
  {
    std::string                              name;
    std::vector<std::string>                 good;
    std::function<void(const std::string &)> read; ///< it is in the file, too
  };



  void
  read_mesh(const std::string &)
  {
    GmshFileParameters parameters;
    parameters.file = input_file;
    const auto read = [&](auto &&triangulation) {
      parameters.check(triangulation.dimension);
      make_mesh_from_gmsh_file(
        parameters, [](const std::string &) {}, triangulation);
    };
    try
      {
        read(Triangulation<2>());
      }
    catch (const Error &)
      {
        read(Triangulation<3>());
      }
  }



  template <int dim>
  BoundaryNames
  names_of_box()
  {
    BoundaryNames names = {{"left", 0},
                           {"right", 1},
                           {"bottom", 2},
                           {"top", 3}};
    if (dim == 3)
      names.insert({{"front", 4}, {"back", 5}});
    return names;
  }



  /// All that a model takes from the parameters but its mesh.
  template <int dim>
  void
  interpret(const Parameters &parameters)
  {
    BoundaryConditions<dim>(parameters.boundary_conditions,
                            names_of_box<dim>());
    parameters.material.materials();
    LoadProgram(parameters.loading);
    make_indenter<dim>(parameters.indenter);
  }



  void
  read_parameters(const std::string &)
  {
    CommandLine command_line;
    command_line.parameter_file = input_file;
    const Parameters parameters = Parameters::read(command_line);
    parameters.check();
    if (parameters.dimension == 2)
      interpret<2>(parameters);
    else
      interpret<3>(parameters);
  }



  /// One argument a line.
  void
  read_command_line(const std::string &text)
  {
    std::vector<std::string>  words;
    std::vector<const char *> arguments = {"elasto_plastic_contact"};
    std::istringstream        stream(text);
    for (std::string word; std::getline(stream, word);)
      words.push_back(word);
    for (const std::string &word : words)
      arguments.push_back(word.c_str());
    CommandLine::parse(arguments.size(), arguments.data());
  }



  void
  read_history(const std::string &text)
  {
    LoadingParameters parameters;
    parameters.history = text;
    const LoadProgram program(parameters);
    for (const double time : program.segment_ends())
      program.load(time);
  }



  void
  read_tractions(const std::string &text)
  {
    BoundaryConditionParameters parameters;
    parameters.free                   = {"left", "bottom"};
    parameters.traction               = text;
    const auto                  names = names_of_box<2>();
    const BoundaryConditions<2> conditions(parameters, names);
    for (const auto &[name, id] : names)
      conditions.largest_value(id, Point<2>(0.5, 2), 1);
  }



  /// One list a line.
  void
  read_hardening(const std::string &text)
  {
    std::istringstream stream(text);
    std::string        table, moduli, rates;
    std::getline(stream, table);
    std::getline(stream, moduli);
    std::getline(stream, rates);
    read_hardening_table(table, 100);
    read_back_stresses(moduli, rates);
  }



  std::vector<Reader>
  all_readers()
  {
    const Checkpoint checkpoint(MPI_COMM_SELF, ".", {{"Dimension", "2"}});
    checkpoint.save("state of the run", [](const std::string &file) {
      std::ofstream(file) << "mesh";
    });
    const std::string state           = content("checkpoint/state");
    const std::string index           = content("checkpoint/index");
    const auto        read_checkpoint = [=](const std::string &state,
                                     const std::string &index) {
      std::ofstream("checkpoint/state", std::ios::binary) << state;
      std::ofstream("checkpoint/index", std::ios::binary) << index;
      checkpoint.load();
    };
    const auto read_state = [=](const std::string &text) {
      read_checkpoint(text, index);
    };
    const auto read_index = [=](const std::string &text) {
      read_checkpoint(state, text);
    };
    const auto read_table = [](const std::string &) {
      CsvFile(MPI_COMM_SELF, input_file, {"time", "force"}, 2);
    };
    const auto read_image = [](const std::string &) {
      decode_image(HeightFile("Indenter/File", input_file));
    };
    const auto read_matrix = [](const std::string &) {
      decode_matrix(HeightFile("Indenter/File", input_file));
    };
    const auto read_stl = [](const std::string &) {
      IndenterParameters parameters;
      parameters.type = "STL surface";
      parameters.file = input_file;
      make_indenter<3>(parameters).shape->surface({0.1, 0.2});
    };
    const auto read_expression = [](const std::string &text) {
      Expression<2>("Indenter/Expression", text).value(Point<2>(0.5, 2), 1);
    };
    std::vector<std::string> png;
    for (const int format : std::vector<int>{PNG_FORMAT_GRAY,
                                             PNG_FORMAT_RGBA,
                                             PNG_FORMAT_LINEAR_Y})
      png.push_back(png_image_of(format));
    const std::string cases = "../parameter_files/";

    return {{"parameter file",
             contents({"bad_input/base.prm",
                       cases + "sphere_3d.prm",
                       cases + "material/chaboche_cycles.prm",
                       cases + "hardening_cycles/kinematic.prm",
                       cases + "error_bound/parabola.prm"}),
             read_parameters},
            {"command line",
             {"file.prm\n--set\nMaterial/Yield stress=1\n--overwrite\n",
              "file.prm\n--output-directory\nresults\n--resume\n--quiet\n"},
             read_command_line},
            {"expression",
             {"if(x < 0.5, sin(pi*x)*exp(-t), -y^2)",
              "0.1*max(x, y, t) + rint(3*x)/(t - 2)"},
             read_expression},
            {"load history",
             {"1: depth 0.01 | 2.5: force 0", "0.5: force 3e-1|2: depth -1"},
             read_history},
            {"tractions",
             {"right: 100*t; 0 | top: if(x < 1, 1, -y); -1",
              "right: 0; 1e3 | top: -x; 1/y"},
             read_tractions},
            {"hardening",
             {"0.01: 450 | 0.05: 500\n20000 | 5000\n100 | 0\n",
              "none\nnone\nnone\n"},
             read_hardening},
            {"mesh",
             contents({"fuzz_seeds/two_squares.msh",
                       "fuzz_seeds/one_square.msh",
                       "fuzz_seeds/cube.msh"}),
             read_mesh},
            {png_reader, png, read_image},
            {"PGM and PBM image",
             {"P2\n# grey\n3 2\n7\n0 1 2\n3 4 7\n",
              "P5 3 2 255\nabcdef",
              "P1\n3 2\n1 0 1 001",
              "P4\n9 2\nabcd"},
             read_image},
            {"height matrix",
             {"# heights\n1 2.5 3e-1\n4, 5, 6\n7 8 9\n", "1,2\n\n3,-4\n5,6"},
             read_matrix},
            {"STL surface",
             contents({"fuzz_seeds/tip.stl", "fuzz_seeds/tip_binary.stl"}),
             read_stl},
            {"table of an interrupted run",
             {"time,force\n0.5,-1e-3\n1,2.25\n1.5,7\n"},
             read_table},
            {"state of a checkpoint", {state}, read_state},
            {"index of a checkpoint", {index}, read_index}};
  }



  /// @return whether @p reader accepts @p text. Whatever but an Error gets
  /// through.
  bool
  accepts(const Reader &reader, const std::string &text)
  {
    std::ofstream(input_file, std::ios::binary) << text;
    alarm(seconds_to_read);
    bool accepted = true;
    try
      {
        reader.read(text);
      }
    catch (const Error &)
      {
        accepted = false;
      }
    alarm(0);
    return accepted;
  }



  /// @return how many of the inputs are accepted.
  unsigned int
  fuzz(const Reader &reader, const unsigned int n_inputs, Random &random)
  {
    unsigned int n_accepted = 0;
    for (unsigned int i = 0; i < n_inputs; ++i)
      {
        std::string text = reader.good[below(reader.good.size(), random)];
        for (unsigned int n = below(6, random) + 1; n > 0; --n)
          damage(text, reader.good, random);
        n_accepted += accepts(reader,
                              reader.name == png_reader && random() % 8 > 0 ?
                                with_checksums(text) :
                                text);
      }
    return n_accepted;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  deal_II_exceptions::disable_abort_on_exception();
  const unsigned int n_inputs = argc > 1 ? std::stoul(argv[1]) : 200;
  Random             random(argc > 2 ? std::stoul(argv[2]) : 1);

  bool all_good_accepted = true;
  for (const Reader &reader : all_readers())
    {
      for (const std::string &text : reader.good)
        if (!accepts(reader, text))
          {
            std::cout << "FAILED: " << reader.name << " refuses\n"
                      << text << std::endl;
            all_good_accepted = false;
          }
      std::cout << reader.name << std::flush;
      const auto         begin      = std::chrono::steady_clock::now();
      const unsigned int n_accepted = fuzz(reader, n_inputs, random);
      const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - begin;
      if (argc > 1)
        std::cout << ": " << n_accepted << " of " << n_inputs << " accepted, "
                  << seconds.count() << " s";
      std::cout << std::endl;
    }
  return all_good_accepted ? 0 : 1;
}
