#pragma once
// Files that take long to read.

#include <filesystem>
#include <map>
#include <memory>

namespace idiophone::timbre {

/// What is read from a file, once while the program runs: every start of a sound makes its nodes anew.
/// @param read  read(file) gives the content
template <class Content, class Read>
[[nodiscard]] std::shared_ptr<const Content> read_once(const std::filesystem::path& file, const Read& read) {
  static std::map<std::filesystem::path, std::shared_ptr<const Content>> known;
  std::shared_ptr<const Content>& content = known[std::filesystem::absolute(file).lexically_normal()];
  if (!content) {
    content = std::make_shared<const Content>(read(file));
  }
  return content;
}

}  // namespace idiophone::timbre
