#pragma once
// The readers of files that libFuzzer calls with made-up files.

#include <filesystem>
#include <string>
#include <vector>

#include "mutations.hpp"

namespace idiophone::fuzz {

struct Reader {
  std::string name;
  std::string extension;  ///< of its files
  /// Reads a file as the program does.
  void (*read)(const std::filesystem::path& file);
  /// Changes the bytes of a file as libFuzzer, which knows no format, would not.
  std::string (*mutated)(std::string bytes, mutants::Random& random);
  bool names_file = true;  ///< whether each of its errors names the file
};

/// Of decks, scores, trees and other texts.
[[nodiscard]] std::vector<Reader> text_readers();
/// Of sounds, MIDI, packets, meshes and heads.
[[nodiscard]] std::vector<Reader> binary_readers();
/// Of HDF5 files.
[[nodiscard]] std::vector<Reader> stored_readers();

}  // namespace idiophone::fuzz
