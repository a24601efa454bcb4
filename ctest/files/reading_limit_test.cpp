// Reading that crashes or does not end is ended with a message.

#include "idiophone/files/reading_limit.hpp"

#include <ctime>

#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::files {
namespace {

int fall(int depth) {
  volatile int deeper = depth + 1;
  return deeper > 0 ? fall(deeper) + deeper : 0;
}

ON_RANKS(1);

TEST(ReadingLimit, EndsWhatDoesNotEnd) {
  if (support::rank() == 0) {
    const auto search_for_ever = [] {
      const ReadingLimit limit("plate.h5", 0.1);
      while (std::clock() != 0) {
      }
    };
    EXPECT_EXIT(search_for_ever(), testing::ExitedWithCode(1), "plate.h5 is damaged: reading it .* within 0.1 s");
  }
}

TEST(ReadingLimit, EndsWhatFillsTheStack) {
  if (support::rank() == 0) {
    const auto overflow = [] {
      const ReadingLimit limit("plate.h5");
      return fall(0);
    };
    EXPECT_EXIT(static_cast<void>(overflow()), testing::ExitedWithCode(1), "plate.h5 is damaged");
  }
}

TEST(ReadingLimit, LeavesNothingBehind) {
  { const ReadingLimit limit("plate.h5", 0.05); }
  const std::clock_t begin = std::clock();
  while (std::clock() - begin < CLOCKS_PER_SEC / 10) {
  }
}

}  // namespace
}  // namespace idiophone::files
