#include "files_of_folder.hpp"

#include <fmt/format.h>

#include <assimp/MemoryIOWrapper.h>
#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace idiophone::mesher {

namespace {

/// Whether a path that may not exist lies beneath a folder, if one follows its `..` by its text.
bool lies_beneath(const std::filesystem::path& folder, const std::filesystem::path& path) {
  const auto whole = (folder / path).lexically_normal();
  return std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end()).first == folder.end();
}

}  // namespace

bool FilesOfFolder::Exists(const char* path) const {
  return lies_beneath(folder_, path) && std::ifstream(path).good();
}

Assimp::IOStream* FilesOfFolder::Open(const char* path, const char* /*mode*/) {
  std::ifstream stream(path, std::ios::binary);
  const bool is_beneath = lies_beneath(folder_, path);
  if (!is_beneath || !stream) {
    if (complaint_.empty()) {
      complaint_ = is_beneath
                       ? fmt::format(
                             "it refers to {}, which isn't there. Put that file beside it, or export it as .glb, "
                             "which has everything in one file",
                             path)
                       : fmt::format("it refers to {}, which is outside its folder. Put that file beside it", path);
    }
    return nullptr;
  }
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  auto* copy = new std::uint8_t[std::max<std::size_t>(bytes.size(), 1)];  // the stream owns it
  std::memcpy(copy, bytes.data(), bytes.size());
  return new Assimp::MemoryIOStream(copy, bytes.size(), true);
}

}  // namespace idiophone::mesher
