#pragma once
// A file for a test.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace idiophone::support {

/// A place for a file of this process. The file goes with this object.
class TemporaryFile {
 public:
  /// @param name  after what makes the path one of this process; with the file's extension
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("idiophone_" + std::to_string(getpid()) + "_" + name)) {}
  TemporaryFile(const std::string& name, const std::string& text) : TemporaryFile(name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace idiophone::support
