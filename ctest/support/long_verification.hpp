// Checks that take minutes belong to the long verification: ctest --preset verification.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

namespace idiophone::support {

/// Whether the long verification runs. Its tests set IDIOPHONE_LONG.
inline bool long_verification() {
  return std::getenv("IDIOPHONE_LONG") != nullptr;
}

}  // namespace idiophone::support

/// The first line of a test that only the long verification runs. ctest/CMakeLists.txt looks for this word.
#define LONG_VERIFICATION()                                                       \
  if (!idiophone::support::long_verification()) {                                 \
    GTEST_SKIP() << "part of the long verification: ctest --preset verification"; \
  }                                                                               \
  static_assert(true)
