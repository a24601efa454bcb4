#include "idiophone/instruments/outputs/buffered_renderer.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace idiophone::outputs {
namespace {

/// Counts samples; after a number of buffers, the filling thread waits until it may go on.
struct Counter {
  double next = 0.0;
  std::atomic<int> allowed;

  void fill(std::span<double> sound, const std::atomic<bool>& ends) {
    while (allowed == 0 && !ends) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    --allowed;
    for (double& sample : sound) {
      sample = next++;
    }
  }
};

TEST(BufferedRenderer, PlaysWhatIsFilledInOrderAndCountsGaps) {
  std::atomic<bool> ends = false;
  Counter counter{.allowed = 4};
  BufferedRenderer renderer([&](std::span<double> sound) { counter.fill(sound, ends); }, 1000, 10, 4);
  std::vector<double> sound(7);
  double expected = 0.0;
  for (int block = 0; block < 5; ++block) {  // blocks need not be as long as buffers
    renderer.render(sound, 0);
    for (const double sample : sound) {
      EXPECT_EQ(sample, expected++);
    }
  }
  EXPECT_EQ(renderer.gaps(), 0);
  renderer.render(sound, 0);  // five samples are left
  EXPECT_EQ(sound, (std::vector<double>{35, 36, 37, 38, 39, 0, 0}));
  EXPECT_EQ(renderer.gaps(), 1);
  EXPECT_EQ(renderer.now(), 42);
  counter.allowed = 1;
  for (int tries = 0; tries < 10000 && sound.front() != 40.0; ++tries) {  // until the next buffer is full
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    renderer.render(sound, 0);
  }
  EXPECT_EQ(sound.front(), 40);
  ends = true;
}

}  // namespace
}  // namespace idiophone::outputs
