// Motion channels of bodies and contacts, where the motion is known: flight, rotation and a bounce.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"
#include "stages.hpp"

namespace idiophone::bodies {
namespace {

using ::testing::SizeIs;

constexpr int rate = 2000;  // audio samples per second, as in the decks

/// A ball that moves for some audio samples, and its channels on rank 0.
struct Moved {
  Moved(const std::string& deck, std::vector<std::string> overrides, int samples,
        MPI_Comm communicator = MPI_COMM_WORLD)
      : ready(prepare(read_deck(IDIOPHONE_SOURCE_DIR "/ctest/app/decks/" + deck, overrides, communicator),
                      communicator)) {
    FiniteElementSource source(ready, support::stages(), communicator);
    Channels channels(source.channels());
    channels.subscribe([&](const spectra::Series& channel, std::span<const double> values) {
      auto& all = rows[channel.path];
      all.insert(all.end(), values.begin(), values.end());
      rates[channel.path] = channel.rate;
    });
    surface::SurfaceMotion motion;
    source.start(motion);
    for (int sample = 1; sample <= samples; ++sample) {
      source.advance(motion);
      if (sample % 7 == 0) {
        channels.deliver();
      }
    }
    channels.deliver();
    source.check();
    now = source.observe_now();
  }

  [[nodiscard]] double at(const std::string& channel, std::size_t row, std::size_t column = 0) const {
    const auto& values = rows.at(channel);
    return values.at(row * (channel == "/energy" ? 5 : channel.ends_with("energy") ? 2 : 3) + column);
  }
  [[nodiscard]] Vector3 vector(const std::string& channel, std::size_t row) const {
    return {at(channel, row, 0), at(channel, row, 1), at(channel, row, 2)};
  }

  Preparation ready;
  std::map<std::string, std::vector<double>> rows;
  std::map<std::string, double> rates;
  Observation now;
};

ON_RANKS(1, 3);

TEST(BodyChannels, FollowAParabola) {
  const Moved moved("free.yaml",
                    {"bodies.ball.velocity=[1, 2, 3]", "gravity=[0, 0, -10]", "output.motion_per_second=500"}, 40);
  if (support::rank() != 0) {
    EXPECT_TRUE(moved.rows.at("/energy").empty());
    return;
  }
  const Vector3 begin = moved.vector("/motion/ball/centre_of_mass", 0);
  EXPECT_THAT(moved.rows.at("/motion/ball/centre_of_mass"), SizeIs(3 * 11));  // each fourth sample, and sample 0
  EXPECT_EQ(moved.rates.at("/motion/ball/centre_of_mass"), 500.0);
  for (std::size_t row = 0; row < 11; ++row) {
    const double time = 4.0 * static_cast<double>(row) / rate;
    const Vector3 place = begin + time * Vector3(1, 2, 3) - 5 * time * time * Vector3::UnitZ();
    EXPECT_LT((moved.vector("/motion/ball/centre_of_mass", row) - place).norm(), 1e-10) << row;
    const Vector3 velocity(1, 2, 3 - 10 * time);
    EXPECT_LT((moved.vector("/motion/ball/velocity", row) - velocity).norm(), 1e-10) << row;
    const double kinetic = moved.ready.initial_state.masses[0] * velocity.squaredNorm() / 2;
    EXPECT_NEAR(moved.at("/motion/ball/energy", row), kinetic, 1e-9 * kinetic);
  }
}

TEST(BodyChannels, AddUpEnergiesThatAFlightKeeps) {
  const Moved moved("free.yaml",
                    {"bodies.ball.velocity=[1, 2, 3]", "gravity=[0, 0, -10]", "output.motion_per_second=2000"}, 20);
  if (support::rank() != 0) {
    return;
  }
  const double mass = moved.ready.initial_state.masses[0];
  for (std::size_t row = 0; row <= 20; ++row) {
    const double gravitational = 10 * mass * moved.at("/motion/ball/centre_of_mass", row, 2);
    EXPECT_NEAR(moved.at("/energy", row, 3), gravitational, 1e-10 * mass);
    EXPECT_NEAR(moved.at("/energy", row, 0) + moved.at("/energy", row, 3),
                moved.at("/energy", 0, 0) + moved.at("/energy", 0, 3), 1e-9 * mass);
    EXPECT_NEAR(moved.at("/energy", row, 1), 0.0, 1e-12);  // elastic
    EXPECT_EQ(moved.at("/energy", row, 2), 0.0);           // contact
    EXPECT_EQ(moved.at("/energy", row, 4), 0.0);           // work
  }
  EXPECT_NEAR(moved.now.energy(), moved.at("/energy", 0, 0) + moved.at("/energy", 0, 3), 1e-9 * mass);
}

TEST(BodyChannels, TurnWithoutAJumpOfTheSign) {
  const Moved moved("free.yaml", {"bodies.ball.spin=[0, 0, 200]", "output.motion_per_second=2000"}, 100);
  if (support::rank() != 0) {
    return;
  }
  const auto& turns = moved.rows.at("/motion/ball/orientation");
  ASSERT_THAT(turns, SizeIs(4 * 101));
  for (std::size_t row = 0; row <= 100; ++row) {
    const double half = 0.5 * 200 * static_cast<double>(row) / rate;  // angle; five radians at the end
    EXPECT_NEAR(turns[4 * row], std::cos(half), 0.05) << row;
    EXPECT_NEAR(turns[4 * row + 3], std::sin(half), 0.05) << row;
    EXPECT_NEAR(moved.at("/motion/ball/angular_velocity", row, 2), 200, 8) << row;
    const double momentum = moved.at("/motion/ball/angular_momentum", 0, 2);
    EXPECT_NEAR(moved.at("/motion/ball/angular_momentum", row, 2) / momentum, 1.0, 1e-9) << row;
  }
  EXPECT_LT(turns[4 * 63], -0.9);  // a whole turn: the other quaternion of no turn
}

// A bar that is held at one end and pulled at the other breaks in the middle, into two pieces of the same mass.
TEST(BodyChannels, FollowThePiecesOfABodyThatBreaks) {
  const Moved moved("breaking.yaml", {}, 40);
  if (support::rank() != 0) {
    return;
  }
  const auto& joined = moved.rows.at("/motion/bar/joined_pieces");
  ASSERT_THAT(joined, SizeIs(2 * 41));
  EXPECT_EQ(joined[1], 1.0);
  EXPECT_EQ(joined[2 * 40 + 1], 2.0);
  for (std::size_t row = 0; row <= 40; ++row) {
    for (const std::string channel : {"/centre_of_mass", "/velocity"}) {
      const Vector3 whole = moved.vector("/motion/bar" + channel, row);
      const Vector3 mean =
          (moved.vector("/motion/bar.1" + channel, row) + moved.vector("/motion/bar.2" + channel, row)) / 2;
      EXPECT_LT((whole - mean).norm(), 1e-9 + 1e-9 * whole.norm()) << channel << row;
    }
    for (const std::size_t column : {0, 1}) {
      const double sum = moved.at("/motion/bar.1/energy", row, column) + moved.at("/motion/bar.2/energy", row, column);
      EXPECT_NEAR(sum, moved.at("/motion/bar/energy", row, column), 1e-9 * sum) << row;
    }
  }
  const double apart =
      std::abs(moved.at("/motion/bar.1/centre_of_mass", 40) - moved.at("/motion/bar.2/centre_of_mass", 40));
  EXPECT_GT(apart, 0.1001);  // m: at rest, it is 0.1
}

TEST(ContactChannels, GiveTheImpulseThatTurnsABallRound) {
  const Moved moved("bounce.yaml", {"output.motion_per_second=2000"}, 80);  // one wall, at 0.01 s
  if (support::rank() != 0) {
    return;
  }
  const auto& force = moved.rows.at("/contacts/right/force");
  ASSERT_THAT(force, SizeIs(3 * 80));
  EXPECT_EQ(moved.rates.at("/contacts/right/force"), rate);
  Vector3 impulse = Vector3::Zero();
  double most_overlap = 0.0;
  for (std::size_t row = 0; row < 80; ++row) {
    impulse += moved.vector("/contacts/right/force", row) / rate;
    most_overlap = std::max(most_overlap, moved.rows.at("/contacts/right/overlap")[row]);
    if (moved.vector("/contacts/right/force", row).norm() > 0) {
      EXPECT_LT(moved.vector("/contacts/right/normal", row).x(), -0.9);
      EXPECT_NEAR(moved.vector("/contacts/right/point", row).x(), 0.05, 0.002);
    }
  }
  EXPECT_GT(most_overlap, 0.0);
  const Vector3 change = moved.vector("/motion/ball/velocity", 80) - moved.vector("/motion/ball/velocity", 0);
  ASSERT_LT(change.x(), -1.0);  // it came back
  EXPECT_LT((impulse - moved.ready.initial_state.masses[0] * change).norm(), 1e-9 * impulse.norm());
  EXPECT_EQ(moved.vector("/contacts/left/force", 20), Vector3::Zero());
}

TEST(LoadChannels, HaveTheSameBitsOnAnyNumberOfRanks) {
  const std::vector<std::string> gusty = {
      "bodies.ball.spin=[0, 0, 50]", "output.motion_per_second=2000",
      "loads={breeze: {type: wind, velocity: [3, -4, 12], drag: 2, gusts: {intensity: 0.3, time: 0.01, seed: 5}}, "
      "rub: {type: bow, at: [0.04, 0, 0], radius: 0.05, direction: [0, 1, 1], speed: 0.5, load: 3}}"};
  const Moved together("free.yaml", gusty, 30);
  const Moved alone("free.yaml", gusty, 30, MPI_COMM_SELF);
  if (support::rank() == 0) {
    EXPECT_THAT(alone.rows.at("/loads/breeze/force"), SizeIs(3 * 31));
    EXPECT_GT(alone.vector("/loads/rub/force", 30).norm(), 0.1);
    EXPECT_EQ(together.rows, alone.rows);
  }
}

ON_RANKS(1);  // a modal body lies on one rank

TEST(LoadChannels, GiveTheForceThatMovesFiniteElementsAndModes) {
  const std::string wind = "{type: wind, velocity: [30, 0, 0]}";
  const std::string bow = "{type: bow, at: [0.04, 0, 0], direction: [1, 0, 0], speed: 2, load: 0.5}";
  for (const auto& [model, load] :
       {std::pair("{type: finite_elements}", wind), std::pair("{type: modal, up_to: 500}", wind),
        std::pair("{type: finite_elements}", bow), std::pair("{type: modal, up_to: 500}", bow)}) {
    const Moved moved("free.yaml",
                      {fmt::format("bodies.ball.model={}", model), "output.motion_per_second=2000",
                       fmt::format("loads={{pull: {}}}", load)},
                      60);
    if (support::rank() != 0) {
      continue;
    }
    Vector3 impulse = Vector3::Zero();
    for (std::size_t row = 0; row < 60; ++row) {
      impulse += (moved.vector("/loads/pull/force", row) + moved.vector("/loads/pull/force", row + 1)) / (2.0 * rate);
    }
    const Vector3 change = moved.vector("/motion/ball/velocity", 60) - moved.vector("/motion/ball/velocity", 0);
    EXPECT_GT(change.x(), 0.01) << model << load;
    EXPECT_LT((impulse - moved.ready.initial_state.masses[0] * change).norm(), 2e-3 * impulse.norm()) << model << load;
    EXPECT_NEAR(moved.at("/energy", 60, 4) / (moved.at("/energy", 60, 0) + moved.at("/energy", 60, 1)), 1.0, 0.02)
        << model << load;
  }
}

}  // namespace
}  // namespace idiophone::bodies
