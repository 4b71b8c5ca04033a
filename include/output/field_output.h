// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_field_output_h
#define output_field_output_h

#include <deal.II/numerics/data_out.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "contact/contact_set.h"
#include "mechanics/solid_operator.h"
#include "output/output_parameters.h"

namespace ElastoPlastic
{
  /// Writes what ParaView shows: solution-*.pvtu with the fields of the body,
  /// surface-*.pvtu with those of the contact surface, each with a .pvd file
  /// that lists them over time.
  template <int dim>
  class FieldOutput
  {
  public:
    /// A solution and everything needed to evaluate it.
    struct Solution
    {
      const DoFHandler<dim>             &dof_handler;
      const AffineConstraints<double>   &constraints;
      const SolidOperator<dim>          &solid;
      const ContactSet<dim>             &contact;
      const std::set<types::boundary_id> contact_boundaries;
      const VectorType                  &displacement;
      const VectorType                  &residual;
      const VectorType                  &slip;
      const Vector<float>               &error_indicators;
    };

    /// @p parameters say where the files go, which fields they hold and what
    /// their units are called; they must outlive this object.
    explicit FieldOutput(const OutputParameters &parameters)
      : parameters(parameters)
    {}


    /// Writes both files for @p solution. @p name distinguishes them from
    /// others (the same name as before replaces them), @p time is their place
    /// in the .pvd file.
    /// @throws FileError
    void
    write(const Solution &solution, const std::string &name, const double time);

    /// Waits until what this rank has written is on the disk. Collective.
    /// @throws FileError
    void
    write_to_disk(const MPI_Comm communicator);

    /// The list of what has been written, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &records;
    }

  private:
    void
    write_body(const Solution    &solution,
               const std::string &name,
               const double       time);

    void
    write_surface(const Solution    &solution,
                  const std::string &name,
                  const double       time);

    /// A file of this rank, if @p name is not empty. Collective.
    void
    write_file(const MPI_Comm                             communicator,
               const std::string                         &name,
               const std::function<void(std::ostream &)> &write);

    /// Writes one .vtu per rank, the .pvtu and the .pvd with the record so far.
    template <typename Output>
    void
    write_files(const Output      &output,
                const MPI_Comm     communicator,
                const std::string &kind,
                const std::string &name,
                const double       time);

    const OutputParameters &parameters;

    /// For each kind of file: the times and file names written so far.
    std::map<std::string, std::vector<std::pair<double, std::string>>> records;

    /// The files of this rank since the last call of write_to_disk().
    std::set<std::string> written;
  };
} // namespace ElastoPlastic

#endif
