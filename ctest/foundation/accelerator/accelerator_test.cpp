// Any OpenCL device will do; pocl-opencl-icd is one without hardware.

#include "idiophone/foundation/accelerator/accelerator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "idiophone/foundation/accelerator/background_read.hpp"
#include "idiophone/foundation/accelerator/kernel.hpp"

namespace idiophone::accelerator {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

class AcceleratorTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      accelerator_ = std::make_unique<Accelerator>("0");
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  std::unique_ptr<Accelerator> accelerator_;
};

TEST_F(AcceleratorTest, IsFoundByAPartOfItsName) {
  const std::string& name = accelerator_->name();
  std::string part = name.substr(0, name.find(' '));
  std::ranges::transform(part, part.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(Accelerator(part).name(), name);
}

TEST_F(AcceleratorTest, ThatIsNotThereIsRefusedWithTheNamesOfAll) {
  for (const char* wish : {"no such device", "999"}) {
    EXPECT_THAT([wish] { Accelerator{wish}; },
                ThrowsMessage<std::runtime_error>(HasSubstr("0: " + accelerator_->name())));
  }
}

TEST_F(AcceleratorTest, KeepsNumbersInOrder) {
  std::vector<int> numbers(1000), back(1000);
  Array<int> array(*accelerator_, numbers.size());
  array.read(back);
  EXPECT_EQ(back, numbers);                    // zeros
  for (int round = 0; round < 100; ++round) {  // more than may be on the way at once
    std::iota(numbers.begin(), numbers.end(), round);
    array.write(numbers);
  }
  array.write(std::vector{1, 2, 3}, 500);
  std::vector<int> some(5);
  array.read(some, 499);
  EXPECT_THAT(some, ElementsAre(598, 1, 2, 3, 602));
}

TEST_F(AcceleratorTest, ReadsNumbersInTheBackground) {
  const Program program(*accelerator_,
                        "kernel void turn(int times, global unsigned* numbers) {"
                        "  const int i = get_global_id(0);"
                        "  for (int n = 0; n < times; ++n) numbers[i] = numbers[i] * 1664525U + 1013904223U; }");
  Kernel turn(program, "turn");
  constexpr int times = 100'000;  // takes some milliseconds, in which nothing has arrived
  Array<unsigned> array(*accelerator_, 128);
  BackgroundRead<unsigned> all(*accelerator_, array.size()), first(*accelerator_, 3), none(*accelerator_, 0);
  EXPECT_THAT(none.finish(), IsEmpty());
  for (const unsigned begin : {0U, 1U}) {
    array.write(std::vector<unsigned>(array.size(), begin));
    turn({array.size(), 1, 1}, times, array);
    none.begin(array);
    all.begin(array);
    first.begin(array);
    array.write(std::vector<unsigned>(array.size(), 7U));  // after these reads
    unsigned expected = begin;
    for (int n = 0; n < times; ++n) {
      expected = expected * 1664525U + 1013904223U;
    }
    EXPECT_THAT(all.finish(), Each(expected));
    EXPECT_THAT(first.finish(), ElementsAre(expected, expected, expected));
  }
  turn({array.size(), 1, 1}, times, array);
  all.begin(array);  // on its way at the end
}

TEST_F(AcceleratorTest, CallsAKernelForEachNumberOfARange) {
  const Program program(*accelerator_,
                        "kernel void add(int width, int height, int depth, int more, global int* sums) {"
                        "  const int x = get_global_id(0), y = get_global_id(1), z = get_global_id(2);"
                        "  if (x < width && y < height && z < depth) sums[(z * height + y) * width + x] += more; }");
  Kernel add(program, "add");
  Array<int> sums(*accelerator_, 17 * 9 * 2 + 1);
  add({17, 9, 2}, 17, 9, 2, 3, sums);
  add({0, 9, 2}, 17, 9, 2, 3, sums);
  std::vector<int> expected(sums.size(), 3), found(sums.size());
  expected.back() = 0;
  sums.read(found);
  EXPECT_EQ(found, expected);
}

TEST_F(AcceleratorTest, AKernelKnowsNewArraysAndNumbersFromOldOnes) {
  const Program program(*accelerator_,
                        "kernel void set(int number, global int* numbers) { numbers[get_global_id(0)] = number; }");
  Kernel set(program, "set");
  std::uint64_t last = 0;
  for (const int number : {1, 1, 2}) {
    Array<int> numbers(*accelerator_, 128);  // where the last one was
    EXPECT_GT(numbers.memory().number(), last);
    last = numbers.memory().number();
    set({128, 1, 1}, number, numbers);
    std::vector<int> found(numbers.size());
    numbers.read(found);
    EXPECT_EQ(found, std::vector<int>(numbers.size(), number));
  }
}

TEST_F(AcceleratorTest, SaysWhatItsCompilerSays) {
  EXPECT_THAT([this] { Program(*accelerator_, "kernel void wrong() { unknown(); }"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("unknown")));
}

}  // namespace
}  // namespace idiophone::accelerator
