// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "app/bounds.h"
#include "app/job_preview.h"
#include "app/program.h"
#include "base/exceptions.h"
#include "base/process.h"
#include "contact_run/elasto_plastic_contact.h"
#include "input/command_line.h"
#include "input/entry_effects.h"
#include "input/parameters.h"
#include "output/log.h"
#include "problem/model.h"
#include "restart/output_directory.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What a rank needs without any unknowns: shared libraries, mostly.
    constexpr double megabytes_of_rank = 170.;



    void
    print_line(const std::string &title,
               const std::string &text,
               std::ostream      &out)
    {
      out << std::left << std::setw(16) << title << text << '\n';
    }



    std::string
    whole(const double value)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(0) << value;
      return text.str();
    }



    /// @p value to so many digits, without an exponent if it is large.
    std::string
    rounded(const double value, const unsigned int digits)
    {
      const double unit =
        std::pow(10., std::floor(std::log10(std::max(value, 1.))) + 1 - digits);
      if (unit >= 1.)
        return whole(std::round(value / unit) * unit);
      std::ostringstream text;
      text << std::setprecision(digits) << value;
      return text.str();
    }



    /// What has been estimated.
    std::string
    about(const double value)
    {
      return "about " + rounded(value, 3);
    }



    std::string
    duration(const double seconds)
    {
      if (seconds < 100.)
        return rounded(std::max(seconds, 1.), 1) + " s";
      if (seconds < 100. * 60.)
        return rounded(seconds / 60., 1) + " min";
      return rounded(seconds / 3600., 2) + " h";
    }



    template <int dim>
    void
    print_meshes(const JobPreview<dim> &preview,
                 const unsigned int     n_over_radius,
                 std::ostream          &out)
    {
      const auto meshes = preview.meshes();
      print_line("First mesh",
                 whole(meshes.front().cells) + " cells, " +
                   whole(meshes.front().unknowns) + " unknowns" +
                   (preview.is_first_mesh() ?
                      "" :
                      "; it has not been made: what follows is from a mesh "
                      "with fewer initial refinements"),
                 out);
      if (meshes.size() > 1)
        print_line("Last mesh",
                   (n_over_radius > 0 ?
                      "" :
                      "number " + std::to_string(meshes.size()) + ", ") +
                     about(meshes.back().cells) + " cells, " +
                     about(meshes.back().unknowns) + " unknowns",
                   out);
    }



    template <int dim>
    void
    print_materials(const JobPreview<dim> &preview, std::ostream &out)
    {
      for (const auto &[id, share] : preview.materials())
        print_line("Material " + std::to_string(id),
                   rounded(100. * share.cells, 3) + " % of the cells, " +
                     rounded(100. * share.volume, 3) + " % of the volume",
                   out);
    }



    template <int dim>
    void
    print_contact(const JobPreview<dim> &preview,
                  const Units           &units,
                  const unsigned int     n_over_radius,
                  std::ostream          &out)
    {
      const double n = preview.n_candidates();
      print_line("Contact",
                 (preview.is_first_mesh() ? whole(n) : about(n)) +
                   " nodes within reach of the indenter",
                 out);
      const auto contact = preview.expected_contact();
      if (!contact)
        return;
      const auto length = [&](const double value) {
        return rounded(value, 3) +
               (units.length.empty() ? "" : " " + units.length);
      };
      print_line("Contact radius",
                 "about " + length(contact->radius) +
                   ", where the indenter cuts the surface at the depth " +
                   length(contact->depth) + ": " +
                   rounded(contact->n_elements, 2) +
                   " elements of the first mesh" +
                   (n_over_radius > 0 ? "; the mesh will follow it with " +
                                          std::to_string(n_over_radius) :
                                        ""),
                 out);
      constexpr double limit = SmallStrainGuard<dim>::largest_slope;
      if (contact->slope > limit)
        print_line("Slope",
                   "of the indenter there: " + rounded(*contact->slope, 3) +
                     "; small strains reach to about " + rounded(limit, 3),
                   out);
    }



    template <int dim>
    double
    expected_megabytes(const JobPreview<dim> &preview,
                       const unsigned int     n_ranks)
    {
      return preview.expected_cost().megabytes + n_ranks * megabytes_of_rank;
    }



    template <int dim>
    void
    print_cost(const JobPreview<dim> &preview,
               const StepControl      control,
               const unsigned int     n_ranks,
               std::ostream          &out)
    {
      print_line("Load steps",
                 std::to_string(preview.n_steps()) +
                   (control != StepControl::fixed ? ", which adapt" : ""),
                 out);
      print_line("Memory",
                 about(expected_megabytes(preview, n_ranks)) + " MB on " +
                   std::to_string(n_ranks) + " rank(s)",
                 out);
      print_line("Time",
                 "about " +
                   duration(preview.expected_cost().processor_seconds) +
                   " of one processor, give or take a factor of three",
                 out);
    }



    /// The limits that the run is expected to meet. Collective.
    template <int dim>
    void
    warn_of_limits(const JobPreview<dim>      &preview,
                   const RefinementParameters &refinement,
                   const MPI_Comm              communicator)
    {
      Log          log(communicator, Verbosity::quiet);
      const double unknowns = preview.meshes().back().unknowns;
      if (refinement.n_over_contact_radius > 0 && !refinement.allows(unknowns))
        log.warn(
          "The mesh is expected to stop following the contact at some "
          "step: it would have " +
          about(unknowns) +
          " unknowns in the end, more than 'Refinement/Maximum number of "
          "unknowns' allows. Raise that, or reduce 'Refinement/Elements "
          "over contact radius'.");
      const double needed =
        expected_megabytes(preview,
                           Utilities::MPI::n_mpi_processes(communicator));
      const double present = machine_memory(communicator) / 1048576.;
      if (needed > present)
        log.warn("The run is expected to need " + about(needed) +
                 " MB of memory, and there are " + rounded(present, 3) +
                 " MB here. Choose a coarser mesh, or more processes on more "
                 "machines.");
    }



    /// Sentences in one, with what is said before and after them.
    void
    warn_of(const std::string              &before,
            const std::vector<std::string> &sentences,
            const std::string              &after,
            Log                            &log)
    {
      if (sentences.empty())
        return;
      std::string text = before;
      for (const std::string &sentence : sentences)
        text += (&sentence == &sentences.front() ? "" : "; ") + sentence;
      log.warn(text + after);
    }



    /// Entries that are set in vain, and those that do not fit each other.
    /// Collective.
    void
    warn_of_entries(const CommandLine &command_line,
                    const Parameters  &parameters,
                    const MPI_Comm     communicator)
    {
      Log log(communicator, Verbosity::quiet);
      on_first_rank(communicator, [&]() {
        std::set<std::string> set =
          parameters.entries_changed_in(command_line.parameter_file);
        for (const auto &[path, value] : command_line.overrides)
          set.insert(path);
        warn_of("Entries that are set and have no effect: ",
                entries_without_effect(set, parameters.entries),
                ". Leave them out, or change what they depend on.",
                log);
        warn_of("",
                doubtful_units(parameters.entries),
                ". Are all stresses in the same unit, such as MPa?",
                log);
      });
    }



    /// What the run does with earlier results in its folder.
    std::string
    use_of_results(const CommandLine &command_line)
    {
      if (command_line.resume)
        return "the run goes on from their checkpoint";
      return command_line.overwrite ? "the run replaces them" :
                                      "a run needs --overwrite, or --resume";
    }



    /// Collective.
    void
    print_output_directory(const CommandLine &command_line,
                           const Parameters  &parameters,
                           const MPI_Comm     communicator,
                           std::ostream      &out)
    {
      const std::string &name = parameters.output.directory;
      print_line("Results",
                 name + (OutputDirectory(communicator, name).holds_results() ?
                           ", which holds results already: " +
                             use_of_results(command_line) :
                           ""),
                 out);
    }



    template <int dim>
    void
    validate_contact(const Model<dim>  &model,
                     const CommandLine &command_line,
                     const Parameters  &parameters,
                     const MPI_Comm     communicator,
                     std::ostream      &out)
    {
      model.geometry.check_size(communicator);
      const JobPreview<dim> preview(model, parameters);
      parameters.refinement.check_first_mesh(preview.meshes().front().unknowns);

      ElastoPlasticContact<dim> problem(preview.quick_model(),
                                        parameters,
                                        communicator,
                                        StrictBounds<dim>::make_error_bound);
      if (preview.is_first_mesh())
        problem.check_contact();
      if (command_line.resume)
        problem.check_checkpoint();

      const unsigned int n_over_radius =
        parameters.refinement.n_over_contact_radius;
      print_meshes(preview, n_over_radius, out);
      print_materials(preview, out);
      if (model.indenter.shape)
        print_contact(preview, parameters.output.units, n_over_radius, out);
      print_cost(preview,
                 parameters.loading.step_control,
                 Utilities::MPI::n_mpi_processes(communicator),
                 out);
      print_output_directory(command_line, parameters, communicator, out);
      out << std::flush;
      warn_of_entries(command_line, parameters, communicator);
      warn_of_limits(preview, parameters.refinement, communicator);
      if (const std::string safety = StrictBounds<dim>::first_look_at_load(
            model, parameters, communicator);
          !safety.empty())
        print_line("Limit load", safety, out);
    }



    template <int dim>
    void
    validate_limit_load(const Model<dim>  &model,
                        const CommandLine &command_line,
                        const Parameters  &parameters,
                        const MPI_Comm     communicator,
                        std::ostream      &out)
    {
      print_line("First mesh",
                 std::to_string(StrictBounds<dim>::check_limit_load(
                   model, parameters, communicator)) +
                   " cells" +
                   (dim == 3 ? ", each cut into 24 tetrahedra or more" : ""),
                 out);
      print_line("Meshes", std::to_string(parameters.refinement.n_cycles), out);
      print_output_directory(command_line, parameters, communicator, out);
      out << std::flush;
      warn_of_entries(command_line, parameters, communicator);
    }
  } // namespace



  template <int dim>
  void
  validate(const Model<dim>  &model,
           const CommandLine &command_line,
           const Parameters  &parameters,
           const MPI_Comm     communicator,
           std::ostream      &out)
  {
    if (parameters.analysis == Analysis::limit_load)
      validate_limit_load(model, command_line, parameters, communicator, out);
    else
      validate_contact(model, command_line, parameters, communicator, out);
  }



  template void
  validate(const Model<2> &,
           const CommandLine &,
           const Parameters &,
           const MPI_Comm,
           std::ostream &);
  template void
  validate(const Model<3> &,
           const CommandLine &,
           const Parameters &,
           const MPI_Comm,
           std::ostream &);
} // namespace ElastoPlastic
