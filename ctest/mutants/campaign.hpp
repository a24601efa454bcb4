#pragma once
// Mutants of a valid file are read, each in a process of its own. A reader accepts a mutant or throws an error of the
// project that names the file. Crashes, reports of sanitizers, leaks, hangs and other exceptions are failures.
//
// IDIOPHONE_MUTANTS is the number of mutants of each type (default 25), IDIOPHONE_MUTANT the only one that is made.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mutations.hpp"

namespace idiophone::mutants {

/// A type of file.
struct Subject {
  std::string type;                              ///< for messages
  std::vector<std::filesystem::path> originals;  ///< valid files, in one folder
  /// Changes a copy of an original.
  std::function<void(const std::filesystem::path&, Random&)> mutate;
  /// Reads a file beside the originals, as the program does.
  std::function<void(const std::filesystem::path&)> read;
  std::string named = {};  ///< part of each message; the name of the mutant if omitted
  std::size_t share = 1;   ///< one in so many mutants is made: for readers that are slow
};

/// Reads the originals, which must succeed, and the mutants, and reports the failures to GoogleTest.
void expect_answers(const Subject& subject);

// Mutations of files.
void mutate_text(const std::filesystem::path& file, Random& random);
void mutate_bytes(const std::filesystem::path& file, Random& random);

}  // namespace idiophone::mutants
