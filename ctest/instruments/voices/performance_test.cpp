#include "performance.hpp"

#include <gtest/gtest.h>
#include <lo/lo.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "idiophone/instruments/drivers/osc.hpp"
#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "sheet_map.hpp"
#include "sound_power.hpp"

namespace idiophone::voices {

using sound_maps::sheet;

namespace {

score::HammerBlow blow_at(const Vector3& at) {
  return {.at = at, .direction = -Vector3::UnitZ(), .hammer = {.mass = 0.01, .hardness = 1e8, .speed = 1.0}};
}

score::Score score_of(std::vector<score::ScoreEvent> events) {
  score::Score score;
  score.duration = 0.5;
  score.events = std::move(events);
  return score;
}

scene::Listener listener_at(const Vector3& position) {
  scene::Listener listener;
  listener.receivers = {{.channel = "ear", .position = position}};
  return listener;
}

std::vector<double> play(const score::Score& score, std::int64_t samples, std::int64_t block = 512) {
  Performance performance({sheet()}, score, rate);
  return rendered(performance, samples, block);
}

score::Stroke some_scrape() {
  score::Stroke stroke;
  stroke.from = {0.02, 0.02, 0.0};
  stroke.to = {0.12, 0.06, 0.0};
  stroke.direction = -Vector3::UnitZ();
  stroke.speed = 1.0;
  stroke.load = 1.0;
  stroke.mass = 0.01;
  stroke.hardness = 1e9;
  stroke.friction = 0.3;
  stroke.roughness.height = 1e-6;
  return stroke;
}

}  // namespace

TEST(Performance, SoundsAsTheBlowOfTheSoundMap) {
  for (const double hardness : {1e6, 1e8, 1e10}) {  // contacts of 2.6, 0.4 and 0.07 ms
    score::HammerBlow blow = blow_at({0.06, 0.03, 0.0});
    blow.hammer.hardness = hardness;
    const std::vector<double> found = play(score_of({{.time = 0.01, .body = 0, .action = blow}}), 12000);
    const resonators::HertzPulse pulse(blow.hammer);
    const sound_maps::Blow exact{.at = blow.at,
                                 .direction = blow.direction,
                                 .force = [&](double time) { return pulse.at(time); },
                                 .duration = pulse.duration};
    for (std::size_t ear = 0; ear < 2; ++ear) {
      const std::vector<double> expected = sound_maps::sound_of(exact, sheet(), ear, rate, 12000 - 480);
      double difference = 0.0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        difference += std::pow(found[2 * (i + 480) + ear] - expected[i], 2);
      }
      EXPECT_LT(std::sqrt(difference / power(expected)), 0.03) << hardness;  // 0.3 dB are 0.035
    }
  }
}

TEST(Performance, GivesTheSameBitsInBlocksOfAnySize) {
  score::Score score = score_of({{.time = 0.001, .body = 0, .action = blow_at({0.1, 0.1, 0.0})},
                                 {.time = 0.0013, .body = 0, .action = blow_at({0.0, 0.1, 0.0})},
                                 {.time = 0.02, .body = 0, .action = some_scrape()}});
  score.listener = listener_at({0.1, 0.1, 2.0});
  score.listener->path = scene::Path{.points = {{0.0, {0.1, 0.1, 2.0}}, {1.0, {3.0, 0.1, 2.0}}}, .where = {}};
  const std::vector<double> expected = play(score, 9000);
  EXPECT_GT(power(expected), 0.0);
  for (const std::int64_t block : {1, 64, 100, 128, 9000}) {
    const std::vector<double> found = play(score, 9000, block);
    const auto differs = std::ranges::mismatch(found, expected);
    EXPECT_EQ(differs.in1 - found.begin(), 9000) << "blocks of " << block;
  }
}

TEST(Performance, AddsTheSoundsOfAllBodies) {
  const score::ScoreEvent first{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})};
  const score::ScoreEvent second{.time = 0.01, .body = 1, .action = blow_at({0.0, 0.1, 0.0})};
  const auto of = [&](std::vector<score::ScoreEvent> events) {
    Performance both({sheet("one"), sheet("two")}, score_of(std::move(events)), rate);
    return rendered(both, 4000);
  };
  const std::vector<double> together = of({first, second}), one = of({first}), two = of({second});
  for (std::size_t i = 0; i < together.size(); ++i) {
    ASSERT_NEAR(together[i], one[i] + two[i], 1e-14 * std::sqrt(power(one)));  // one filter for all bodies rounds once
  }
}

TEST(Performance, HearsTheSphereWithDistanceAndDelay) {
  const auto loudest = [](const Vector3& at) {
    score::Score score = score_of({{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}});
    score.listener = listener_at(at);
    return play(score, 4800);
  };
  const std::vector<double> near = loudest({0.1, 0.1, 3.43}), far = loudest({0.1, 0.1, 6.86});
  for (std::size_t i = 500; i < 2000; ++i) {  // 3.43 m are 480 samples
    ASSERT_NEAR(far[i + 480], 0.5 * near[i], 1e-12 * std::sqrt(power(near)));
  }
  EXPECT_NEAR(near[450], 0.0, 1e-6 * std::sqrt(power(near)));
  const std::vector<double> below = loudest({0.1, 0.1, -3.43});  // the dipole's other side
  for (std::size_t i = 500; i < 2000; ++i) {
    ASSERT_NEAR(below[i], -near[i], 1e-12 * std::sqrt(power(near)));
  }
}

TEST(Performance, ShiftsTheFrequenciesForAListenerThatMoves) {
  score::Score score = score_of({{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}});
  sound_maps::SoundMap map = sheet();
  map.frequency.assign(map.frequency.size(), 1000.0);
  map.material_decay.assign(map.frequency.size(), 0.1);
  score.listener = listener_at({0.1, 0.1, 5.0});
  score.listener->path = scene::Path{.points = {{0.0, {0.1, 0.1, 5.0}}, {1.0, {0.1, 0.1, 25.0}}}, .where = {}};
  Performance performance({map}, score, rate);
  const std::vector<double> sound = rendered(performance, rate);
  int crossings = 0;
  std::size_t first = 0, last = 0;
  for (std::size_t i = 2400; i < sound.size(); ++i) {
    if (sound[i - 1] < 0.0 && sound[i] >= 0.0) {
      first = crossings == 0 ? i : first;
      last = i;
      ++crossings;
    }
  }
  const double frequency = (crossings - 1.0) * rate / static_cast<double>(last - first);
  EXPECT_NEAR(frequency / (1000.0 / (1.0 + 20.0 / 343.0)), 1.0, 1e-3);
}

TEST(Performance, PlaysMidiNotesWithTheirVelocity) {
  score::Score score = score_of({});
  score.notes = {{.note = 60, .body = 0, .blow = blow_at({0.1, 0.1, 0.0})}};
  Performance performance({sheet()}, score, rate);
  EXPECT_EQ(performance.add({{.time = 0.0, .number = 60, .velocity = 127}, {.time = 0.0, .number = 61, .velocity = 9}}),
            1U);
  EXPECT_EQ(rendered(performance, 1000),
            play(score_of({{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}}), 1000));
}

TEST(Performance, BeginsWhatIsPlayedAtOnceInTheNextBlock) {
  Performance performance({sheet()}, score_of({}), rate);
  static_cast<void>(rendered(performance, 256, 128));
  const auto before = std::chrono::steady_clock::now();
  performance.play({.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})});
  std::vector<double> block(256);
  const auto clock = std::chrono::steady_clock::now();
  performance.stage().render(block, clock.time_since_epoch().count());
  EXPECT_EQ(performance.waits().count, 1);
  EXPECT_GT(performance.waits().mean, 0.0);
  EXPECT_LE(performance.waits().longest, std::chrono::duration<double>(clock - before).count());
  EXPECT_GT(power(rendered(performance, 1000)), 0.0);
}

TEST(Performance, BlowByOscIsHeardWithinTwoBlocks) {
  // A device asks for a block while it plays the one before. A blow that comes during block 7 has to begin at the first
  // sample of block 8, which is heard after one more block: one to two blocks after the blow came.
  constexpr std::int64_t block = 128;
  Performance performance({sheet()}, score_of({}), rate);
  auto player = std::make_unique<drivers::OscPlayer>("127.0.0.1", 0, performance.stage().bodies(), 1, rate);
  const std::string port = std::to_string(player->port());
  drivers::OscPlayer& osc = *player;
  std::vector<double> live = rendered(performance, 8 * block, block);
  lo_address here = lo_address_new("127.0.0.1", port.c_str());
  lo_send(here, "/blow", "sfffffffff", "sheet", 0.125, 0.0625, 0.0, 0.0, 0.0, -1.0, 0.0078125, 1e8, 1.0);
  std::vector<drivers::Event> events;
  for (int tries = 0; tries < 5000 && events.empty(); ++tries) {
    osc.ask(performance.stage().now(), 0, events);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  lo_address_free(here);
  ASSERT_EQ(events.size(), 1U);
  performance.stage().perform(events.front());
  const std::vector<double> rest = rendered(performance, 8 * block, block);
  live.insert(live.end(), rest.begin(), rest.end());
  score::HammerBlow blow = blow_at({0.125, 0.0625, 0.0});
  blow.hammer.mass = 0.0078125;
  const double eighth_block = 8.0 * block / rate;  // s
  EXPECT_EQ(live, play(score_of({{.time = eighth_block, .body = 0, .action = blow}}), 16 * block, block));
  EXPECT_GT(power(live), 0.0);
}

TEST(Performance, KeepsMoreEventsThanFitAtOnce) {
  const score::ScoreEvent blow{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})};
  const std::vector<score::ScoreEvent> events(3000, blow);
  EXPECT_GT(power(play(score_of(events), 20000)), 0.0);
}

TEST(Performance, RefusesListenersThatDiffer) {
  sound_maps::SoundMap other = sheet("other");
  other.listeners[1].position.x() += 0.1;
  EXPECT_THROW(Performance({sheet(), other}, score_of({}), rate), std::runtime_error);
  other.listeners.clear();
  EXPECT_THROW(Performance({other}, score_of({}), rate), std::runtime_error);
}

TEST(Performance, MovesTheListener) {
  score::Score score = score_of({});
  EXPECT_THROW(Performance({sheet()}, score, rate).move_listener({0, 0, 1}), std::runtime_error);
  score.listener = listener_at({0.1, 0.1, 2.0});
  Performance moved({sheet()}, score, rate);
  EXPECT_THROW(moved.move_listener({0, 0, 1000}), std::runtime_error);
  moved.move_listener({0.1, 0.1, -1.0});
  static_cast<void>(rendered(moved, 4800));
  score.listener = listener_at({0.1, 0.1, -1.0});
  Performance there({sheet()}, score, rate);
  static_cast<void>(rendered(there, 4800));
  for (Performance* one : {&moved, &there}) {
    one->play({.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})});
  }
  EXPECT_EQ(rendered(moved, 3000), rendered(there, 3000));
}

TEST(Performance, TunesSizeAndFriction) {
  const auto sound = [](const sound_maps::SoundMap& map, const score::Tuning& tuning) {
    Performance performance({map},
                            score_of({{.time = 0.0, .body = 0, .action = tuning},
                                      {.time = 0.1, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}}),
                            rate);
    return rendered(performance, 9600);
  };
  sound_maps::SoundMap larger = sheet();
  for (std::size_t mode = 0; mode < larger.modes(); ++mode) {
    larger.frequency[mode] /= 4.0;
    larger.material_decay[mode] *= 3.0 / 4.0;
    larger.radiation_decay[mode] /= 4.0;
    for (sound_maps::MapListener& listener : larger.listeners) {
      listener.pressure[mode] /= 2.0;
    }
  }
  for (float& shape : larger.shape) {
    shape /= 8.0F;
  }
  const std::vector<double> expected = sound(larger, {});
  const std::vector<double> found = sound(sheet(), {.size = 4.0, .friction = 3.0});
  EXPECT_GT(power(expected), 0.0);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(found[i], expected[i], 1e-9 * std::sqrt(power(expected)));
  }
}

TEST(Performance, TunesWhatSounds) {
  const auto late = [](double friction) {
    Performance performance({sheet()}, score_of({{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}}), rate);
    static_cast<void>(rendered(performance, 2400));
    performance.play({.time = 0.0, .body = 0, .action = score::Tuning{.size = 1.0, .friction = friction}});
    const std::vector<double> sound = rendered(performance, 9600);
    return power({sound.begin() + 4800, sound.end()});
  };
  const double kept = late(1.0);
  EXPECT_GT(kept, 0.0);
  EXPECT_GT(late(0.5), kept);
  EXPECT_LT(late(10.0), 0.1 * kept);
  EXPECT_GT(late(10.0), 0.0);
}

TEST(Performance, HearsWithAHead) {
  // The sheet is to the left of a head that looks along x.
  score::Score score = score_of({{.time = 0.0, .body = 0, .action = blow_at({0.1, 0.1, 0.0})}});
  score.listener = scene::Listener{};
  score.listener->receivers.assign(2, {.channel = "ear", .position = {0.1, -2.0, 0.5}});
  score.listener->head = scene::Head{.look = Vector3::UnitX(),
                                     .up = Vector3::UnitZ(),
                                     .responses = "/usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa",
                                     .where = {}};
  const std::vector<double> sound = play(score, 9600);
  std::vector<double> left, right;
  for (std::size_t i = 0; i < sound.size(); i += 2) {
    left.push_back(sound[i]);
    right.push_back(sound[i + 1]);
  }
  EXPECT_GT(power(left), 2.0 * power(right));
  EXPECT_GT(power(right), 0.0);
  score.listener->path = scene::Path{.points = {{0.0, {0.1, -2.0, 0.5}}, {0.2, {2.0, 0.1, 0.5}}}, .where = {}};
  const std::vector<double> moving = play(score, 9000);
  EXPECT_NE(moving, std::vector(sound.begin(), sound.begin() + 18000));
  EXPECT_EQ(play(score, 9000, 100), moving);
}

}  // namespace idiophone::voices
