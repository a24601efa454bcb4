#include "idiophone/instruments/outputs/ring.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace idiophone::outputs {

TEST(Ring, HandsItemsOverInOrderBetweenThreads) {
  constexpr int count = 20000;
  Ring<std::unique_ptr<int>> ring(16);
  std::thread putting([&] {
    for (int i = 0; i < count; ++i) {
      auto item = std::make_unique<int>(i);
      while (!ring.put(item)) {
        std::this_thread::yield();
      }
    }
  });
  for (int i = 0; i < count; ++i) {
    std::unique_ptr<int> item;
    while (!ring.take(item)) {
      std::this_thread::yield();
    }
    if (*item != i) {
      ADD_FAILURE() << *item << " instead of " << i;
      break;
    }
  }
  putting.join();
}

TEST(Ring, LeavesAnItemAloneWhenItIsFull) {
  Ring<std::unique_ptr<int>> ring(2);
  for (int i = 0; i < 2; ++i) {
    auto item = std::make_unique<int>(i);
    EXPECT_TRUE(ring.put(item));
  }
  auto third = std::make_unique<int>(2);
  if (ring.put(third)) {
    FAIL() << "a full ring takes nothing";
  }
  EXPECT_NE(third, nullptr);
  std::unique_ptr<int> first;
  EXPECT_TRUE(ring.take(first));
  EXPECT_EQ(*first, 0);
  EXPECT_TRUE(ring.put(third));
}

}  // namespace idiophone::outputs
