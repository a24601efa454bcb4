#pragma once
// An archive in memory.

#include <map>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"

namespace idiophone::support {

/// Keeps each rank's block of rows, and rank 0's values on every rank. Saves until restore() is called.
class MemoryArchive : public parallel::Archive {
 public:
  using Archive::Archive;
  [[nodiscard]] bool restoring() const override { return restoring_; }
  void restore() { restoring_ = true; }

  std::map<std::string, std::vector<double>> blocks, numbers;
  std::map<std::string, std::vector<std::int64_t>> integers;

 protected:
  void exchange_rows(const std::string& name, const parallel::Rows& rows, int width,
                     std::vector<double>& values) override {
    if (restoring_) {
      values = rows.from_blocks(std::span<const double>(blocks.at(name)), width);
    } else {
      blocks[name] = rows.to_blocks(std::span<const double>(values), width);
    }
  }
  void exchange_root(const std::string& name, std::vector<double>& values) override { exchange(numbers, name, values); }
  void exchange_root(const std::string& name, std::vector<std::int64_t>& values) override {
    exchange(integers, name, values);
  }

 private:
  template <class Value>
  void exchange(std::map<std::string, std::vector<Value>>& all, const std::string& name, std::vector<Value>& values) {
    if (restoring_) {
      values = all.at(name);
    } else {
      all[name] = parallel::from_root(values, communicator());
    }
  }

  bool restoring_ = false;
};

}  // namespace idiophone::support
