#include "idiophone/air/receivers/filter_bank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::receivers {
namespace {

constexpr double longest_delay = 1e4;
constexpr std::size_t taps = 37;

/// Two channels; another response for each number.
Filters filters() {
  return {.channels = 2, .taps = taps, .lookahead = 5, .make = [](std::int64_t number) {
            std::mt19937_64 random(static_cast<unsigned>(number));
            std::normal_distribution<double> normal;
            Responses responses(2, std::vector<double>(taps));
            for (auto& response : responses) {
              for (double& tap : response) {
                tap = normal(random);
              }
            }
            return responses;
          }};
}

FilterBank make_bank() {
  return {-1, longest_delay, Spreading::splat(), filters()};
}

/// Sounds for several filters, a few at each audio sample up to `end`.
void play(FilterBank& bank, std::int64_t begin, std::int64_t end) {
  for (std::int64_t sample = begin; sample < end; ++sample) {
    std::mt19937_64 random(static_cast<unsigned>(sample));
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    radiation::Arrivals arrivals;
    for (int i = 0; i < 4; ++i) {
      arrivals.sound.push_back(uniform(random) - 0.5);
      arrivals.delay.push_back(30.0 * uniform(random));
    }
    bank.add(static_cast<std::int64_t>(7.0 * uniform(random)), sample, arrivals);
  }
}

ON_RANKS(1);

TEST(FilterBank, ConvolvesAsTheSumSays) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (const std::size_t count : {1U, 15U, 16U, 17U, 100U}) {
    std::vector<double> line(count + taps - 1), response(taps);
    for (auto* values : {&line, &response}) {
      for (double& value : *values) {
        value = normal(random);
      }
    }
    const std::vector<double> found = convolve(line, response);
    ASSERT_EQ(found.size(), count);
    for (std::size_t n = 0; n < count; ++n) {
      double sum = 0.0;
      for (std::size_t k = 0; k < taps; ++k) {
        sum += response[k] * line[n + taps - 1 - k];
      }
      EXPECT_NEAR(found[n], sum, 1e-13);
    }
  }
}

TEST(FilterBank, WithoutFiltersGivesWhatArrives) {
  FilterBank bank(-1, longest_delay, Spreading::splat(), Filters::none());
  AccumulationBuffer buffer(-1, longest_delay, Spreading::splat());
  const radiation::Arrivals arrivals{{1.0, -0.3, 0.2, 0.0}, {}, {10.25, 11.5, 40.0, 0.0}};
  bank.add(0, 3, arrivals);
  buffer.add(3, arrivals);
  EXPECT_EQ(bank.take(60, MPI_COMM_SELF).at(0), values(buffer.take(60)));
}

TEST(FilterBank, PutsTheTapThatIsNoDelayAtItsTime) {
  FilterBank bank = make_bank();
  bank.add(3, 20, {{1.0, 0.0, 0.0, 0.0}, {}, {0.0, 0.0, 0.0, 0.0}});
  EXPECT_EQ(bank.first(), -6);
  const std::vector<double> sound = bank.take(80, MPI_COMM_SELF).at(1);
  const std::vector<double> response = filters().make(3)[1];
  // The splat of a whole delay is 1 at its sample, and less than e-2 beside it.
  const std::vector<double> weights = gaussian_splat(0.0);
  double expected = 0.0;
  for (std::size_t tap = 0; tap < weights.size(); ++tap) {
    expected += weights[tap] * response[10 + 1 - tap];
  }
  EXPECT_NEAR(sound[6 + 20 + 5], expected, 1e-7);  // tap 10 is 5 after the one that leaves the time as it is
}

TEST(FilterBank, GivesTheSameBitsHoweverManyAreTakenAndAcrossAResume) {
  FilterBank whole = make_bank();
  play(whole, 0, 300);
  const std::vector<std::vector<double>> expected = whole.take(290, MPI_COMM_SELF);

  FilterBank bank = make_bank();
  std::vector<std::vector<double>> found(2);
  std::int64_t played = 0;
  for (const std::size_t count : {1U, 2U, 16U, 17U, 64U, 100U, 90U}) {
    const std::int64_t end = bank.first() + static_cast<std::int64_t>(count) + 6;
    play(bank, played, end);
    played = std::max(played, end);
    const auto sounds = bank.take(count, MPI_COMM_SELF);
    for (std::size_t channel = 0; channel < 2; ++channel) {
      found[channel].insert(found[channel].end(), sounds[channel].begin(), sounds[channel].end());
    }
    FilterBank resumed = make_bank();
    support::MemoryArchive archive(MPI_COMM_SELF);
    bank.archive(archive, "bank");
    archive.restore();
    resumed.archive(archive, "bank");
    bank = std::move(resumed);
  }
  EXPECT_EQ(found, expected);
}

ON_RANKS(1, 3);

TEST(FilterBank, GivesTheSameBitsOnAnyRanks) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  FilterBank whole = make_bank();
  play(whole, 0, 200);
  FilterBank shared = make_bank();
  for (std::int64_t sample = rank; sample < 200; sample += ranks) {
    play(shared, sample, sample + 1);
  }
  support::MemoryArchive archive(MPI_COMM_WORLD);
  shared.archive(archive, "bank");
  const auto expected = whole.take(150, MPI_COMM_SELF);
  const auto found = shared.take(150, MPI_COMM_WORLD);
  if (rank == 0) {
    EXPECT_EQ(found, expected);
    EXPECT_EQ(archive.integers.at("bank").at(0), -6);
  } else {
    EXPECT_TRUE(found.empty());
  }
  archive.restore();
  FilterBank resumed = make_bank();
  resumed.archive(archive, "bank");
  EXPECT_EQ(resumed.take(150, MPI_COMM_WORLD), found);
}

}  // namespace
}  // namespace idiophone::receivers
