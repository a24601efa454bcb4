// Convolution with long responses.

#include <gtest/gtest.h>

#include "convolver.hpp"
#include "idiophone/timbre/nodes/random.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Convolution, IsThatOfPlainSums) {
  const Random random(3);
  std::vector<double> taps(700), input(3000);
  for (std::size_t i = 0; i < input.size(); ++i) {
    input[i] = random.uniform(static_cast<std::int64_t>(i));
    taps[i % taps.size()] = random.uniform(-1 - static_cast<std::int64_t>(i % taps.size()));
  }
  Convolver convolver(taps);
  for (std::size_t i = 0; i < input.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= i && k < taps.size(); ++k) {
      sum += taps[k] * input[i - k];
    }
    ASSERT_NEAR(convolver.step(input[i]), sum, 1e-10);
  }
}

TEST(Convolution, OfAnImpulseIsTheTapsWithoutLatency) {
  for (const std::size_t length : {1U, 127U, 128U, 129U, 256U, 257U, 1000U}) {  // a piece has 128 taps
    const Random random(5);
    std::vector<double> taps(length);
    for (std::size_t i = 0; i < length; ++i) {
      taps[i] = random.normal(static_cast<std::int64_t>(i));
    }
    Convolver convolver(taps);
    for (std::size_t i = 0; i < length + 300; ++i) {
      ASSERT_NEAR(convolver.step(i == 0 ? 1.0 : 0.0), i < length ? taps[i] : 0.0, 1e-14) << length << " " << i;
    }
  }
}

TEST(Convolution, WithoutTapsIsSilence) {
  Convolver convolver({});
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(convolver.step(1.0), 0.0);
  }
}

}  // namespace idiophone::timbre
