#pragma once
// The files that assimp opens.

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <string>

namespace idiophone::mesher {

/// Opens files for reading, none of them outside the folder of the first one, and remembers the first that it could not
/// open. What it opens lies in memory.
class FilesOfFolder : public Assimp::IOSystem {
 public:
  explicit FilesOfFolder(const std::filesystem::path& folder) : folder_(folder) {}

  [[nodiscard]] bool Exists(const char* path) const override;
  [[nodiscard]] char getOsSeparator() const override { return '/'; }
  [[nodiscard]] Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* stream) override { delete stream; }

  /// What is wrong with the first file that could not be opened, and what to do; empty: nothing.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

 private:
  std::filesystem::path folder_;
  std::string complaint_;
};

}  // namespace idiophone::mesher
