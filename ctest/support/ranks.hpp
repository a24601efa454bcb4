#pragma once
// On how many ranks the tests of a program run under mpirun. CMake reads the same declarations.

#include <initializer_list>
#include <string>
#include <vector>

namespace idiophone::support {

/// The tests after a line of a file, up to the next declaration there, run on each of these numbers of ranks.
struct RanksDeclaration {
  std::string file;
  int line = 0;
  std::vector<int> ranks;
};

/// All declarations of the program.
inline std::vector<RanksDeclaration>& ranks_declarations() {
  static std::vector<RanksDeclaration> all;
  return all;
}

inline bool declare_ranks(const char* file, int line, std::initializer_list<int> ranks) {
  ranks_declarations().push_back({file, line, ranks});
  return true;
}

}  // namespace idiophone::support

#define IDIOPHONE_JOINED(first, second) first##second
#define IDIOPHONE_NAMED(first, second) IDIOPHONE_JOINED(first, second)

/// ON_RANKS(1, 3); stands above the tests that run on 1 and on 3 ranks, at the beginning of a line. It holds up to
/// the next one in the file.
#define ON_RANKS(...)                                                          \
  [[maybe_unused]] static const bool IDIOPHONE_NAMED(on_ranks_, __COUNTER__) = \
      ::idiophone::support::declare_ranks(__FILE__, __LINE__, {__VA_ARGS__})
