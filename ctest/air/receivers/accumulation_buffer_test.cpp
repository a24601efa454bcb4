#include "idiophone/air/receivers/accumulation_buffer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "idiophone/air/receivers/filter_bank.hpp"
#include "idiophone/air/receivers/spreading.hpp"
#include "ranks.hpp"

namespace idiophone::receivers {
namespace {

using radiation::Arrivals;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double longest = 1e6;
const Spreading& splat = Spreading::splat();

/// One sound, padded.
Arrivals one(double sound, double delay) {
  Arrivals arrivals{std::vector<double>(8), {}, std::vector<double>(8)};
  arrivals.sound[3] = sound;
  arrivals.delay[3] = delay;
  return arrivals;
}

Arrivals make_random(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> delay(100.0, 300.0);
  std::normal_distribution<double> sound;
  Arrivals arrivals;
  for (std::size_t i = 0; i < count; ++i) {
    arrivals.sound.push_back(sound(random) * std::exp2(8.0 * sound(random) - 20.0));
    arrivals.delay.push_back(delay(random));
  }
  return arrivals;
}

double centroid(const std::vector<double>& entries) {
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    sum += entries[i];
    moment += entries[i] * static_cast<double>(i);
  }
  return moment / sum;
}

ON_RANKS(1);

TEST(AccumulationBuffer, APulseArrivesAfterItsTravelTime) {
  for (const double distance : {0.001, 0.5, 1.0, 3.3333, 343.0}) {
    const double delay = distance / 343.0 * 44100.0;
    AccumulationBuffer buffer(-1, longest, splat);
    buffer.add(20, one(2.5, delay));
    const auto entries = values(buffer.pending());
    EXPECT_NEAR(centroid(entries) - 1.0, 20.0 + delay, 1e-8);  // the first entry is sample -1
    EXPECT_NEAR(std::accumulate(entries.begin(), entries.end(), 0.0), 2.5, 1e-14);
  }
}

TEST(AccumulationBuffer, WritesNoEntryBelowTheStatedOne) {
  AccumulationBuffer buffer(0, longest, splat);
  buffer.add(50, one(1.0, 0.0));
  const auto entries = values(buffer.pending());
  const auto first = std::ranges::find_if(entries, [](double entry) { return entry != 0.0; });
  EXPECT_EQ(first - entries.begin(), 50 + splat.first());
  EXPECT_THAT([&] { buffer.add(0, one(1.0, 0.0)); }, ThrowsMessage<std::logic_error>(HasSubstr("too late")));
}

TEST(AccumulationBuffer, AMovingSourceIsShiftedInPitch) {
  // The source nears the receiver at v: f' = f/(1 - v/c).
  const double rate = 44100.0, c = 343.0, v = 20.0, frequency = 2000.0;
  AccumulationBuffer buffer(-1, longest, splat);
  const int samples = 20000;
  for (int sample = 0; sample < samples; ++sample) {
    const double distance = 30.0 - v * sample / rate;
    buffer.add(sample, one(std::sin(2.0 * std::numbers::pi * frequency * sample / rate), distance / c * rate));
  }
  const auto entries = values(buffer.take(samples));
  // Periods between the first and the last rising zero crossing, placed linearly between entries.
  double first = -1.0, last = 0.0;
  int periods = -1;
  for (std::size_t i = 5000; i + 1 < entries.size(); ++i) {
    if (entries[i] < 0.0 && entries[i + 1] >= 0.0) {
      last = static_cast<double>(i) - entries[i] / (entries[i + 1] - entries[i]);
      first = first < 0.0 ? last : first;
      ++periods;
    }
  }
  EXPECT_NEAR(periods * rate / (last - first), frequency / (1.0 - v / c), 0.02);
}

TEST(AccumulationBuffer, DoesNotDependOnOrderOrParts) {
  const Arrivals all = make_random(8192 + 512, 5);
  AccumulationBuffer whole(-1, longest, splat), parts(-1, longest, splat);
  whole.add(10, all);

  std::vector<std::size_t> order(all.sound.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, std::mt19937(1));
  for (std::size_t begin = 0; begin < order.size(); begin += 544) {
    Arrivals part;
    for (std::size_t i = begin; i < std::min(begin + 544, order.size()); ++i) {
      part.sound.push_back(all.sound[order[i]]);
      part.delay.push_back(all.delay[order[i]]);
    }
    parts.add(10, part);
  }
  EXPECT_EQ(whole.pending(), parts.pending());
}

TEST(AccumulationBuffer, AddsManySoundsAtOnceAsOneByOne) {
  Arrivals all = make_random(4096 + 40, 7);
  all.change = make_random(all.sound.size(), 8).sound;
  const Spreading& spreading = Spreading::band_limited();
  AccumulationBuffer whole(-5, longest, spreading), parts(-5, longest, spreading);
  whole.add(10, all);
  for (std::size_t begin = 0; begin < all.sound.size(); begin += 4) {
    const auto part = [&](const std::vector<double>& values) {
      return std::vector<double>(&values[begin], &values[begin] + 4);
    };
    parts.add(10, {part(all.sound), part(all.change), part(all.delay)});
  }
  EXPECT_EQ(whole.pending(), parts.pending());
}

ON_RANKS(1, 3);

TEST(AccumulationBuffer, IsTheSameOnAnyNumberOfRanks) {
  const Arrivals all = make_random(960, 11);
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  AccumulationBuffer whole(-1, longest, splat), mine(-1, longest, splat);
  whole.add(0, all);
  const std::size_t share = 960 / static_cast<std::size_t>(ranks) / 8 * 8;
  const std::size_t begin = share * static_cast<std::size_t>(rank);
  const std::size_t end = rank == ranks - 1 ? 960 : begin + share;
  Arrivals part;
  part.sound.assign(all.sound.begin() + static_cast<std::ptrdiff_t>(begin),
                    all.sound.begin() + static_cast<std::ptrdiff_t>(end));
  part.delay.assign(all.delay.begin() + static_cast<std::ptrdiff_t>(begin),
                    all.delay.begin() + static_cast<std::ptrdiff_t>(end));
  mine.add(0, part);

  const auto taken = sum_over_ranks(mine.take(150), MPI_COMM_WORLD);
  const auto pending = sum_over_ranks(mine.pending(), MPI_COMM_WORLD);
  if (rank == 0) {
    EXPECT_EQ(taken, whole.take(150));
    EXPECT_EQ(pending, whole.pending());
  } else {
    EXPECT_TRUE(taken.empty());
  }
}

ON_RANKS(1);

TEST(AccumulationBuffer, GoesOnFromPendingEntriesToTheBit) {
  AccumulationBuffer straight(-1, longest, splat);
  straight.add(0, make_random(64, 1));
  static_cast<void>(straight.take(90));
  AccumulationBuffer resumed(-1, longest, splat);
  resumed.restore(straight.first(), straight.pending());
  for (auto* buffer : {&straight, &resumed}) {
    buffer->add(95, make_random(64, 2));
  }
  EXPECT_EQ(resumed.first(), 89);
  EXPECT_EQ(resumed.take(500), straight.take(500));
}

TEST(AccumulationBuffer, TakesTheSameInBlocksOfAnySize) {
  AccumulationBuffer once(-1, longest, splat), often(-1, longest, splat);
  std::vector<FixedPoint> blocks;
  for (int sample = 0; sample < 400; ++sample) {
    const Arrivals arrivals = make_random(16, static_cast<unsigned>(sample));
    once.add(sample, arrivals);
    often.add(sample, arrivals);
    const auto final = static_cast<std::size_t>(sample + 1 + splat.first() - often.first());
    if (sample % 7 == 0) {
      std::ranges::move(often.take(final), std::back_inserter(blocks));
    }
  }
  auto all = once.take(blocks.size());
  EXPECT_EQ(all, blocks);
}

TEST(AccumulationBuffer, DoesNotOverflowInMillionsOfAdditions) {
  // The fine part of the largest tap is almost as large as it can be, so 2^24.2 of them exceed 63 bits.
  const double sound = 1000.45 * 0x1p-30 / splat.weights().sound(Spreading::cell_of(5.0), 0)[1];
  const std::size_t at_once = 1 << 16;
  constexpr int times = 600;  // 39 million
  const Arrivals arrivals{std::vector<double>(at_once, sound), {}, std::vector<double>(at_once, 5.0)};
  AccumulationBuffer buffer(-1, longest, splat);
  for (int i = 0; i < times; ++i) {
    buffer.add(0, arrivals);
  }
  const auto entries = values(buffer.pending());
  EXPECT_NEAR(std::accumulate(entries.begin(), entries.end(), 0.0) / (sound * times * at_once), 1.0, 1e-11);
}

TEST(AccumulationBuffer, RefusesWhatCannotBeAdded) {
  AccumulationBuffer buffer(-1, longest, splat);
  const auto adding = [&](double sound, double delay) {
    return [&buffer, sound, delay] { buffer.add(0, one(sound, delay)); };
  };
  EXPECT_THAT(adding(std::nan(""), 1.0), ThrowsMessage<std::runtime_error>(HasSubstr("unstable")));
  EXPECT_THAT(adding(HUGE_VAL, 1.0), ThrowsMessage<std::runtime_error>(HasSubstr("unstable")));
  EXPECT_THAT(adding(2e6, 1.0), ThrowsMessage<std::runtime_error>(HasSubstr("unstable")));
  EXPECT_THAT(adding(1.0, 1.1e6), ThrowsMessage<std::runtime_error>(HasSubstr("too far")));
  EXPECT_THAT(adding(1.0, -1.0), ThrowsMessage<std::runtime_error>(HasSubstr("travels")));
  EXPECT_THAT(adding(1.0, std::nan("")), ThrowsMessage<std::runtime_error>(HasSubstr("travels")));
  EXPECT_THROW(buffer.add(0, Arrivals{{1.0}, {}, {1.0}}), std::logic_error);
  Arrivals changing = one(1.0, 1.0);
  changing.change.resize(8);
  EXPECT_THAT([&] { buffer.add(0, changing); }, ThrowsMessage<std::logic_error>(HasSubstr("derivative")));
  EXPECT_NO_THROW(buffer.add(0, Arrivals{}));
}

TEST(AccumulationBuffer, HearsTheDerivativeOfAChangeFromAMovingSource) {
  // s(t) emitted on the way towards the receiver at v is heard as d/dt s(t') = s'(t')/(1 - v/c).
  const double rate = 44100.0, c = 343.0, v = 20.0, w = 2.0 * std::numbers::pi * 9000.0 / rate;
  FilterBank bank(Spreading::band_limited().first(), longest, Spreading::band_limited(), Filters::none());
  const int samples = 6000;
  for (int sample = 0; sample < samples; ++sample) {
    Arrivals arrivals = one(0.0, (30.0 - v * sample / rate) / c * rate);
    arrivals.change.resize(8);
    arrivals.change[3] = std::sin(w * sample);
    bank.add(0, sample, arrivals);
  }
  const std::int64_t begin = bank.first();
  const std::vector<double> sound = bank.take(samples, MPI_COMM_SELF).at(0);
  const double shift = 1.0 / (1.0 - v / c);
  for (std::int64_t i = 5000; i < 5100; ++i) {
    const auto heard = static_cast<double>(i + begin);
    const double emitted = (heard - 30.0 / c * rate) * shift;
    // What is emitted at evenly spaced moments arrives denser by the shift, and so louder.
    EXPECT_NEAR(sound[i] / (w * shift * shift), std::cos(w * emitted), 1e-4);
  }
}

}  // namespace
}  // namespace idiophone::receivers
