#pragma once
// One run per name and directory: two runs that write the same files would mix them.

#include <mpi.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>

namespace idiophone::loop {

/// Holds DIRECTORY/NAME.lock while it lives. The lock is one of POSIX's record locks (fcntl), which the kernel, or the
/// server of a network file system, drops when the process ends in whatever way. The file's text says who holds it. If
/// somebody removes the file, it is made again within a second.
class OutputLock {
 public:
  /// Makes the directory, and locks the name on rank 0. Collective.
  /// @throws std::runtime_error on all ranks, saying who holds the lock and since when, that the system refuses, or
  ///         which rank does not see the directory, e.g. because each machine has one of its own
  OutputLock(std::filesystem::path directory, const std::string& name, MPI_Comm communicator);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  OutputLock(OutputLock&&) = delete;
  OutputLock& operator=(OutputLock&&) = delete;
  /// Removes the lock's file, and the directory if nothing was written into it.
  ~OutputLock();

 private:
  void take();
  void require_one_folder(MPI_Comm communicator) const;
  /// Makes the file again when somebody removed it, once a second.
  void keep(const std::stop_token& stop);
  void release();

  std::filesystem::path directory_, path_;
  bool made_directory_ = false;
  int file_ = -1;        ///< on rank 0
  std::string holder_;   ///< text of the lock's file, on rank 0
  std::jthread keeper_;  ///< on rank 0
};

}  // namespace idiophone::loop
