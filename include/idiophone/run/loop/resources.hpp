#pragma once
// What the machines of a job offer, what this process uses, and warnings where a run needs more.

#include <mpi.h>

#include <filesystem>

namespace idiophone::loop {

/// Bytes of main memory of all machines that the ranks run on. Collective; the same on all ranks.
[[nodiscard]] double memory_of_machines(MPI_Comm communicator);

/// The most main memory that this process held so far, bytes.
[[nodiscard]] double peak_memory();

/// Warns when the run needs more memory than there is.
/// @param needed, present  bytes
void compare_memory(double needed, double present);

/// Warns when the files are larger than the free space where they will be written.
/// @param needed  bytes
void compare_disk(double needed, const std::filesystem::path& directory);

/// Warns on rank 0 when ranks of a machine may only use fewer of its processors than they are, e.g. because two ranks
/// are bound to one core: they would wait for each other in every step. Collective.
void warn_of_bound_ranks(MPI_Comm communicator);

}  // namespace idiophone::loop
