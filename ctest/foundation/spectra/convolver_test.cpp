// Convolution with long responses.

#include <gtest/gtest.h>

#include <random>

#include "idiophone/foundation/spectra/convolver.hpp"

namespace idiophone::spectra {
namespace {

/// From -1 to 1.
std::vector<double> random_samples(std::size_t count, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  std::vector<double> samples(count);
  for (double& sample : samples) {
    sample = between(engine);
  }
  return samples;
}

TEST(Convolution, IsThatOfPlainSums) {
  const std::vector<double> taps = random_samples(700, 1);
  const std::vector<double> input = random_samples(3000, 2);
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
    const std::vector<double> taps = random_samples(length, 5);
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

/// What has to be kept of the input, to go on with the same bits later.
TEST(Convolution, GoesOnAfterThePiecesThatItRemembers) {
  const std::vector<double> taps = random_samples(1000, 7);
  const std::vector<double> input = random_samples(5000, 8);
  Convolver whole(taps);
  Convolver resumed(taps);
  constexpr std::size_t stop = 4001;
  const std::size_t begin = (stop / Convolver::piece - whole.remembered_pieces()) * Convolver::piece;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const double expected = whole.step(input[i]);
    const double found = i >= begin ? resumed.step(input[i]) : expected;
    if (i >= stop) {
      ASSERT_EQ(found, expected) << i;
    }
  }
}

}  // namespace
}  // namespace idiophone::spectra
