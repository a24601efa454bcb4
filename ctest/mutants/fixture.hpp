#pragma once
// A folder for originals and their mutants, and the small deck of the scene's tests.

#include "campaign.hpp"
#include "deck_fixture.hpp"

namespace idiophone::mutants {

class Mutants : public scene::DeckTest {
 protected:
  /// Writes an original.
  [[nodiscard]] std::filesystem::path made(const std::string& name, const std::string& text) const {
    write(name, text);
    return folder / name;
  }

  /// Copies of shipped files.
  /// @param names  below the source folder
  [[nodiscard]] std::vector<std::filesystem::path> shipped(const std::vector<std::string>& names) const {
    std::vector<std::filesystem::path> copies;
    for (const std::filesystem::path name : names) {
      copies.push_back(folder / name.filename());
      std::filesystem::copy_file(std::filesystem::path(IDIOPHONE_SOURCE_DIR) / name, copies.back());
    }
    return copies;
  }
};

}  // namespace idiophone::mutants
