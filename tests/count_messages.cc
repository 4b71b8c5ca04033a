// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A library that counts what a program sends, for LD_PRELOAD: it takes MPI's
// functions and hands them on to the same ones of the profiling interface
// (MPI standard, "Profiling Interface"). At the end, rank 0 writes into the
// file that the environment variable MESSAGE_COUNTS names: the most messages
// and bytes that any rank has sent to others, the global sums, and all other
// collective calls.

#include <array>
#include <cstdlib>
#include <fstream>

#include <mpi.h>

namespace
{
  enum Kind
  {
    messages,
    bytes,
    sums,
    others,
    n_kinds
  };

  std::array<double, n_kinds> counts = {};

  void
  count_message(const int count, const MPI_Datatype type)
  {
    int size = 0;
    PMPI_Type_size(type, &size);
    counts[messages] += 1;
    counts[bytes] += static_cast<double>(count) * size;
  }
} // namespace



extern "C"
{
  int
  MPI_Isend(const void  *data,
            int          count,
            MPI_Datatype type,
            int          to,
            int          tag,
            MPI_Comm     communicator,
            MPI_Request *request)
  {
    count_message(count, type);
    return PMPI_Isend(data, count, type, to, tag, communicator, request);
  }

  int
  MPI_Send(const void  *data,
           int          count,
           MPI_Datatype type,
           int          to,
           int          tag,
           MPI_Comm     communicator)
  {
    count_message(count, type);
    return PMPI_Send(data, count, type, to, tag, communicator);
  }

  int
  MPI_Allreduce(const void  *from,
                void        *to,
                int          count,
                MPI_Datatype type,
                MPI_Op       operation,
                MPI_Comm     communicator)
  {
    counts[sums] += 1;
    return PMPI_Allreduce(from, to, count, type, operation, communicator);
  }

  int
  MPI_Bcast(
    void *data, int count, MPI_Datatype type, int root, MPI_Comm communicator)
  {
    counts[others] += 1;
    return PMPI_Bcast(data, count, type, root, communicator);
  }

  int
  MPI_Gatherv(const void  *from,
              int          n_from,
              MPI_Datatype from_type,
              void        *to,
              const int   *n_to,
              const int   *places,
              MPI_Datatype to_type,
              int          root,
              MPI_Comm     communicator)
  {
    counts[others] += 1;
    return PMPI_Gatherv(
      from, n_from, from_type, to, n_to, places, to_type, root, communicator);
  }

  int
  MPI_Scatterv(const void  *from,
               const int   *n_from,
               const int   *places,
               MPI_Datatype from_type,
               void        *to,
               int          n_to,
               MPI_Datatype to_type,
               int          root,
               MPI_Comm     communicator)
  {
    counts[others] += 1;
    return PMPI_Scatterv(
      from, n_from, places, from_type, to, n_to, to_type, root, communicator);
  }

  int
  MPI_Finalize()
  {
    std::array<double, n_kinds> most;
    PMPI_Reduce(counts.data(),
                most.data(),
                n_kinds,
                MPI_DOUBLE,
                MPI_MAX,
                0,
                MPI_COMM_WORLD);
    int rank = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (const char *const name = std::getenv("MESSAGE_COUNTS");
        rank == 0 && name != nullptr)
      {
        std::ofstream file(name);
        file << "messages,bytes,sums,others\n";
        for (unsigned int i = 0; i < n_kinds; ++i)
          file << (i > 0 ? "," : "") << most[i];
        file << '\n';
      }
    return PMPI_Finalize();
  }
}
