// MPI's profiling interface: HDF5 calls these functions, which call MPI's own ones. After an error on one rank alone,
// HDF5's ranks part ways and wait for each other in different calls. So an error ends a job of several ranks here. One
// rank alone gets it back.

#include <fmt/format.h>
#include <mpi.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <system_error>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/end_job.hpp"

namespace idiophone::files {

namespace {

// How long a rank waits for others that open or close a file with it. As they close it, a slow disk may still write.
constexpr auto patience_to_open = std::chrono::seconds(30);
constexpr auto patience_to_close = std::chrono::minutes(5);

struct OpenedFile {
  std::string name;
  int ranks = 1;  ///< that opened it together
};

/// The files that were opened, by MPI's number for them.
std::map<MPI_Fint, OpenedFile>& opened_files() {
  static std::map<MPI_Fint, OpenedFile> files;
  return files;
}

/// Where MPI fails to open or to close a file on one rank, the others may wait for this rank forever.
/// @param did  "opened" or "closed"
std::optional<parallel::Deadline> deadline_of(const OpenedFile& file, const std::string& action, const std::string& did,
                                              std::chrono::seconds patience) {
  std::optional<parallel::Deadline> deadline;
  if (file.ranks > 1) {
    deadline.emplace(patience, fmt::format("can't {} {}: not all ranks have {} it within {} s", action, file.name, did,
                                           patience.count()));
  }
  return deadline;
}

std::string text_of_error(int error) {
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(error, text.data(), &length);
  return text.data();
}

/// @param action  what the call does
int judged(int error, MPI_File file, const std::string& action) {
  if (error != MPI_SUCCESS && parallel::size_of(MPI_COMM_WORLD) > 1) {
    const int reason = errno;
    parallel::end_job(fmt::format("can't {} {}: {}", action, opened_files()[MPI_File_c2f(file)].name,
                                  reason == 0 ? text_of_error(error) : std::system_category().message(reason)));
  }
  return error;
}

/// Some components of MPI tell by the number of bytes alone that the disk is full.
int judged_write(int error, MPI_File file, int count, MPI_Datatype type, const MPI_Status* status) {
  MPI_Count wanted = 0, written = 0;
  PMPI_Type_size_x(type, &wanted);
  wanted *= count;
  if (error == MPI_SUCCESS && status != MPI_STATUS_IGNORE) {
    PMPI_Get_elements_x(status, MPI_BYTE, &written);
    error = written < wanted ? MPI_ERR_NO_SPACE : MPI_SUCCESS;
  }
  return judged(error, file, "write");
}

}  // namespace

}  // namespace idiophone::files

#pragma GCC visibility push(default)

extern "C" int MPI_File_open(MPI_Comm communicator, const char* path, int mode, MPI_Info info, MPI_File* file) {
  using namespace idiophone;
  const files::OpenedFile opened{path, parallel::size_of(communicator)};
  const auto deadline = files::deadline_of(opened, "open", "opened", files::patience_to_open);
  errno = 0;
  const int error = PMPI_File_open(communicator, path, mode, info, file);
  files::opened_files()[MPI_File_c2f(*file)] = opened;
  return files::judged(error, *file, "open");
}

extern "C" int MPI_File_close(MPI_File* file) {
  using namespace idiophone;
  const auto deadline =
      files::deadline_of(files::opened_files()[MPI_File_c2f(*file)], "close", "closed", files::patience_to_close);
  return PMPI_File_close(file);
}

extern "C" int MPI_File_set_size(MPI_File file, MPI_Offset size) {
  errno = 0;
  return idiophone::files::judged(PMPI_File_set_size(file, size), file, "change the size of");
}

extern "C" int MPI_File_sync(MPI_File file) {
  errno = 0;
  return idiophone::files::judged(PMPI_File_sync(file), file, "write");
}

extern "C" int MPI_File_write_at(MPI_File file, MPI_Offset at, const void* data, int count, MPI_Datatype type,
                                 MPI_Status* status) {
  errno = 0;
  const int error = PMPI_File_write_at(file, at, data, count, type, status);
  return idiophone::files::judged_write(error, file, count, type, status);
}

extern "C" int MPI_File_write_at_all(MPI_File file, MPI_Offset at, const void* data, int count, MPI_Datatype type,
                                     MPI_Status* status) {
  errno = 0;
  const int error = PMPI_File_write_at_all(file, at, data, count, type, status);
  return idiophone::files::judged_write(error, file, count, type, status);
}

#pragma GCC visibility pop
