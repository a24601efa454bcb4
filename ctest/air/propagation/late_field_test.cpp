// The late field of a room: Eyring's decay, and the energy of the images that it takes the place of.

#include "idiophone/air/propagation/late_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checkpointed.hpp"
#include "late_tail.hpp"
#include "pulsating_sphere.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using support::barrier;
using support::Folder;

ON_RANKS(1);

/// Time for 60 dB, by the energy that is left from -5 dB to -35 dB, s.
double decay_time(const std::vector<double>& sound, int rate) {
  std::vector<double> left(sound.size());
  double sum = 0.0;
  for (std::size_t n = sound.size(); n-- > 0;) {
    left[n] = sum += sound[n] * sound[n];
  }
  const auto first_below = [&](double decibels) {
    const double limit = left.front() * std::pow(10.0, 0.1 * decibels);
    return static_cast<double>(std::ranges::find_if(left, [&](double value) { return value < limit; }) - left.begin());
  };
  return 2.0 * (first_below(-35.0) - first_below(-5.0)) / rate;
}

TEST(LateField, DecaysAsEyringSays) {
  constexpr int rate = 16000;
  const scene::Room room = room_of({5, 4, 3}, 0.25, 2, true);
  const std::vector<Vector3> microphones = {{3, 1, 1}, {0, 1, 3}, {2, -1, 2}, {3.5, -1, 3}};
  const auto sounds = hear(scene_in(room, rate, microphones), {-0.5, -1.5, 1.0}, rate, 1.5);
  const double exact = 24.0 * std::log(10.0) * 60.0 / (343.0 * -94.0 * std::log(0.75));
  double mean = 0.0;
  for (const auto& sound : sounds) {
    mean += decay_time(sound, rate) / 4.0;
    EXPECT_NEAR(decay_time(sound, rate) / exact, 1.0, 0.06);
  }
  EXPECT_NEAR(mean / exact, 1.0, 0.03);
}

TEST(LateField, DecaysInEachOctaveAsEyringSays) {
  constexpr int rate = 8000;
  scene::Scene scene = scene_in(room_of({5, 4, 3}, 0.1, 2, true), rate, {{3, 1, 1}});
  for (scene::OctaveBands& wall : scene.radiation.room->absorption) {
    wall = {0.1, 0.1, 0.1, 0.2, 0.4, 0.4};
  }
  const LateDirection direction = late_directions(scene.radiation).front();
  const LateBands decay = late_decay(scene.radiation);
  std::vector<std::vector<double>> tails;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    tails.push_back(late_tail(direction, decay, rate, seed));
  }
  const auto level = [&](double frequency, double begin) {  // sum over the tails, of 0.1 s behind a window
    double sum = 0.0;
    for (const auto& tail : tails) {
      std::vector<double> part(tail.begin() + static_cast<std::ptrdiff_t>(begin * rate),
                               tail.begin() + static_cast<std::ptrdiff_t>((begin + 0.1) * rate));
      for (std::size_t n = 0; n < part.size(); ++n) {
        part[n] *= 1.0 - std::cos(2.0 * pi * static_cast<double>(n) / static_cast<double>(part.size()));
      }
      sum += std::norm(spectrum(part, frequency, rate));
    }
    return sum;
  };
  for (const auto& [frequency, absorption] : {std::pair{500.0, 0.1}, std::pair{1000.0, 0.2}, std::pair{2000.0, 0.4}}) {
    const double rate_of_decay = -343.0 * 94.0 / (4.0 * 60.0) * std::log(1.0 - absorption);
    const double fallen = decibels_of_energy(level(frequency, 0.0) / level(frequency, 0.1));
    EXPECT_NEAR(fallen, 0.1 * rate_of_decay * 10.0 / std::log(10.0), 2.0) << frequency;
  }
  // In the air the high ones decay faster still, by 2 alpha c.
  scene.radiation.air.absorption = true;
  EXPECT_NEAR(late_decay(scene.radiation)[7] - decay[7], 2.0 * 343.0 * 0.0388, 3.0);
}

/// All images, and few images with a late field, have the same energy in each hundredth of a second.
TEST(LateField, GoesOnWithTheEnergyOfTheImages) {
  constexpr int rate = 44100;
  const Vector3 edges(4, 3.5, 3), source(-0.43, -1.37, 1.12);
  const std::vector<Vector3> microphones = {{2.21, 0.58, 2.77}, {1.13, 0.91, 3.1}, {2.67, -0.83, 1.39},
                                            {0.37, 1.21, 2.3},  {1.9, -0.2, 0.93}, {-0.3, 0.7, 2.9}};
  const auto energies = [&](int order, bool late) {  // in each hundredth
    std::array<double, 6> sums{};
    for (const auto& sound : hear(scene_in(room_of(edges, 0.08, order, late), rate, microphones), source, 2800, 1.5)) {
      for (std::size_t part = 0; part < sums.size(); ++part) {
        const double begin = pulse_middle + 0.01 * rate * static_cast<double>(part);
        sums.at(part) += energy(sound, begin, begin + 0.01 * rate);
      }
    }
    return sums;
  };
  const auto all = energies(13, false), early = energies(2, false), both = energies(2, true);
  for (std::size_t part = 0; part < all.size(); ++part) {
    EXPECT_NEAR(decibels_of_energy(both.at(part) / all.at(part)), 0.0, 1.0) << part;
  }
  EXPECT_LT(decibels_of_energy(early.back() / all.back()), -10.0);
}

TEST(LateField, SoundsDifferentAtEachEarAndAlwaysTheSame) {
  constexpr int rate = 8000;
  const Vector3 place(3, 1, 1);
  const scene::Scene scene = scene_in(room_of({5, 4, 3}, 0.2, 1, true), rate, {place, place});
  const auto sounds = hear(scene, {-0.5, -1.5, 1.0}, 3000, 1.5);
  EXPECT_EQ(sounds, hear(scene, {-0.5, -1.5, 1.0}, 3000, 1.5));
  double product = 0.0;
  for (std::size_t n = 800; n < 3000; ++n) {
    product += sounds[0][n] * sounds[1][n];
  }
  EXPECT_LT(std::abs(product) / std::sqrt(energy(sounds[0], 800, 3000) * energy(sounds[1], 800, 3000)), 0.15);
}

ON_RANKS(1, 3);

TEST(LateField, GoesOnFromAnArchiveWithTheSameBitsOnAnyRanks) {
  constexpr std::size_t length = 600;
  scene::Room room = room_of({2, 3, 2}, 0.3, 1, true);
  room.absorption[4] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const scene::Scene scene = scene_in(room, 4000, {{0.5, 0.5, 1}, {0, 0, 2}});
  const Vector3 source(-0.5, -1.5, 1.0);
  const Folder folder;
  const parallel::Rows triangles(std::vector<Index>{rank()}, ranks(), MPI_COMM_WORLD);
  Ears ears(scene, 0, 8);
  emit(ears, source, 3.0);
  (void)ears.take(300, MPI_COMM_WORLD);
  const auto checkpoint = support::save(folder, ears, triangles);
  const auto expected = ears.take(length, MPI_COMM_WORLD);

  Ears resumed(scene, 0, 8);
  support::restore(checkpoint, MPI_COMM_WORLD, resumed, triangles);
  auto found = resumed.take(length / 2, MPI_COMM_WORLD);
  const auto rest = resumed.take(length / 2, MPI_COMM_WORLD);
  for (std::size_t listener = 0; listener < found.size(); ++listener) {
    found[listener].insert(found[listener].end(), rest[listener].begin(), rest[listener].end());
  }
  EXPECT_EQ(found, expected);
  if (rank() == 0) {
    EXPECT_GT(energy(expected[0], 0, length), 0.0);
    Ears alone(scene, 0, 8);
    support::restore(checkpoint, MPI_COMM_SELF, alone, triangles);
    EXPECT_EQ(alone.take(length, MPI_COMM_SELF), expected);
  }
  barrier();
}

}  // namespace
}  // namespace idiophone::propagation
