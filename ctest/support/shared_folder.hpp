#pragma once
// What the tests of a module share: a folder all ranks use, ways to deal rows to ranks, and made-up values.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::support {

inline int rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int ranks() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

inline void barrier() {
  MPI_Barrier(MPI_COMM_WORLD);
}

/// A new empty folder, the same on all ranks; removed at the end.
class Folder {
 public:
  Folder() {
    auto number = static_cast<int>(getpid());
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    path_ = std::filesystem::temp_directory_path() / ("idiophone_store_" + std::to_string(number));
    if (rank() == 0) {
      std::filesystem::remove_all(path_);
      std::filesystem::create_directory(path_);
    }
    barrier();
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;
  ~Folder() {
    barrier();
    if (rank() == 0) {
      std::filesystem::remove_all(path_);
    }
    barrier();
  }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Rows dealt like cards, from a rank that depends on `first`, the last row also on every rank; descending numbers.
inline std::vector<std::int32_t> dealt(std::int32_t global_rows, int first) {
  std::vector<std::int32_t> numbers;
  for (auto row = global_rows - 1; row >= 0; --row) {
    if ((row + first) % ranks() == rank() || row == global_rows - 1) {
      numbers.push_back(row);
    }
  }
  return numbers;
}

/// All rows on the last rank, none elsewhere.
inline std::vector<std::int32_t> all_on_last(std::int32_t global_rows) {
  std::vector<std::int32_t> numbers;
  for (std::int32_t row = 0; rank() == ranks() - 1 && row < global_rows; ++row) {
    numbers.push_back(row);
  }
  return numbers;
}

/// A value that tells its row and place, with all its bits in use, and the same bits on every machine.
inline double value_of(std::int32_t row, int place) {
  return (place + 1) / (3.0 + row);
}

/// [width x rows]
inline std::vector<double> values_of(const std::vector<std::int32_t>& numbers, int width) {
  std::vector<double> values;
  for (const auto row : numbers) {
    for (int place = 0; place < width; ++place) {
      values.push_back(value_of(row, place));
    }
  }
  return values;
}

/// The message of the error that an action throws; empty when it throws none.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace idiophone::support
