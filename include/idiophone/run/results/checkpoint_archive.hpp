#pragma once
// Archives that save to a checkpoint and restore from one.

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/run/results/checkpoint.hpp"

namespace idiophone::results {

/// Writes the state to a checkpoint.
class SavingArchive : public parallel::Archive {
 public:
  /// @param writer  must outlive this object
  SavingArchive(CheckpointWriter& writer, MPI_Comm communicator) : Archive(communicator), writer_(writer) {}
  [[nodiscard]] bool restoring() const override { return false; }

 protected:
  void exchange_rows(const std::string& name, const parallel::Rows& rows, int width,
                     std::vector<double>& values) override {
    writer_.add_rows(name, rows, width, values);
  }
  void exchange_root(const std::string& name, std::vector<double>& values) override {
    writer_.add_root(name, std::span<const double>(values));
  }
  void exchange_root(const std::string& name, std::vector<std::int64_t>& values) override {
    writer_.add_root(name, std::span<const std::int64_t>(values));
  }

 private:
  CheckpointWriter& writer_;
};

/// Reads the state from a checkpoint.
class RestoringArchive : public parallel::Archive {
 public:
  /// @param reader  must outlive this object
  RestoringArchive(const CheckpointReader& reader, MPI_Comm communicator) : Archive(communicator), reader_(reader) {}
  [[nodiscard]] bool restoring() const override { return true; }

 protected:
  void exchange_rows(const std::string& name, const parallel::Rows& rows, int width,
                     std::vector<double>& values) override {
    values = reader_.read_rows(name, rows, width);
  }
  void exchange_root(const std::string& name, std::vector<double>& values) override {
    values = reader_.read_root(name);
  }
  void exchange_root(const std::string& name, std::vector<std::int64_t>& values) override {
    values = reader_.read_integer_root(name);
  }

 private:
  const CheckpointReader& reader_;
};

}  // namespace idiophone::results
