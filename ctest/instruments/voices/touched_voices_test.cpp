// Bows and mallets on sound maps: what a score and players ask for, and how it sounds.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "heard_sound.hpp"
#include "idiophone/instruments/resonators/point_contacts.hpp"
#include "performance.hpp"
#include "sheet_map.hpp"
#include "sound_power.hpp"

namespace idiophone::voices {

using sound_maps::sheet;

namespace {

score::Bow bow_at(const Vector3& at, double speed, double load) {
  score::Bow bow;
  bow.at = at;
  bow.direction = Vector3::UnitZ();
  bow.speed.points = {{0.0, speed}};
  bow.load.points = {{0.0, load}};
  return bow;
}

score::Score touch_score(std::vector<score::ScoreEvent> events) {
  score::Score score;
  score.duration = 1.0;
  score.events = std::move(events);
  return score;
}

/// The rim of a glass: modes n = 2, 3, ... with 2 n nodes, each twice, turned against each other.
sound_maps::SoundMap glass() {
  constexpr int vertices = 64;
  constexpr double radius = 0.04, modal_mass = 0.015, lowest = 620.0;
  sound_maps::SoundMap map = sheet("glass");
  map.mass = 0.1;
  map.vertices.clear();
  map.triangles.clear();
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / vertices;
    map.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    map.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.01);
  }
  for (Index i = 0; i < 2 * vertices; i += 2) {
    const Index next = (i + 2) % (2 * vertices);
    map.triangles.push_back({i, next, i + 1});
    map.triangles.push_back({next, next + 1, i + 1});
  }
  map.frequency.clear();
  map.material_decay.clear();
  map.shape.clear();
  for (int mode = 0; mode < 12; ++mode) {
    const int n = 2 + mode / 2;
    const double turned = 0.5 * std::numbers::pi * (mode % 2);
    map.frequency.push_back(lowest * (n * n - 1.0) / 3.0);
    map.material_decay.push_back(2.0 + 0.5 * n);
    for (const Vector3& vertex : map.vertices) {
      const double angle = std::atan2(vertex.y(), vertex.x());
      const double outwards = std::cos(n * angle + turned), along = -std::sin(n * angle + turned) / n;
      const Vector3 radial(std::cos(angle), std::sin(angle), 0.0), tangential(-radial.y(), radial.x(), 0.0);
      const Vector3 shape = (outwards * radial + along * tangential) / std::sqrt(modal_mass);
      map.shape.insert(map.shape.end(), {static_cast<float>(shape.x()), static_cast<float>(shape.y()), 0.0F});
    }
  }
  map.radiation_decay.assign(map.frequency.size(), 0.5);
  map.listeners.resize(1);
  map.listeners[0].pressure.assign(map.frequency.size(), 1.0);
  return map;
}

}  // namespace

TEST(TouchedVoices, GlassThatIsRubbedSingsAtItsLowestMode) {
  score::Bow finger = bow_at({0.0401, 0.004, 0.0}, 0.05, 0.6);
  finger.direction = Vector3::UnitY();
  Performance performance({glass()}, touch_score({{.time = 0.0, .body = 0, .action = finger}}), rate);
  const std::vector<double> sound = rendered(performance, 2 * rate);
  const std::span<const double> last = std::span(sound).last(16384);
  EXPECT_GT(power({last.begin(), last.end()}), 0.0);
  EXPECT_LT(std::abs(1200.0 * std::log2(support::pitch(last, 590.0, 650.0, rate) / 620.0)), 5.0);
}

TEST(TouchedVoices, GiveTheSameBitsInBlocksOfAnySize) {
  score::HammerBlow blow{.at = {0.1, 0.1, 0.0}, .direction = -Vector3::UnitZ(), .hammer = {0.01, 1e8, 1.0}};
  score::Bow bow = bow_at({0.06, 0.03, 0.0}, 0.2, 0.5);
  bow.duration = 0.05;
  const score::Score score = touch_score({{.time = 0.001, .body = 0, .action = bow},
                                          {.time = 0.0123, .body = 0, .action = blow},
                                          {.time = 0.02, .body = 0, .action = bow_at({0.1, 0.1, 0.0}, -0.1, 0.3)},
                                          {.time = 0.03, .body = 0, .action = score::Tuning{.size = 1.1}}});
  const auto play = [&](std::int64_t block) {
    Performance performance({sheet()}, score, rate);
    return rendered(performance, 6000, block);
  };
  const std::vector<double> expected = play(512);
  EXPECT_GT(power(expected), 0.0);
  for (const std::int64_t block : {1, 100, 6000}) {
    EXPECT_EQ(play(block), expected) << block;
  }
}

TEST(TouchedVoices, HardlyFeelALightMallet) {
  // A blow has the force on a body that does not give way. On the same heavy body a mallet gives almost the same sound.
  const score::HammerBlow blow{.at = {0.1, 0.1, 0.0}, .direction = -Vector3::UnitZ(), .hammer = {1e-5, 1e6, 1.0}};
  const auto play = [](const auto& action) {
    Performance performance({sheet()}, touch_score({{.time = 0.0, .body = 0, .action = action}}), rate);
    return rendered(performance, 9600);
  };
  const std::vector<double> felt = play(score::MalletBlow{.blow = blow}), given = play(blow);
  std::vector<double> difference = felt;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    difference[i] -= given[i];
  }
  EXPECT_LT(power(difference), 0.01 * power(given));
}

TEST(TouchedVoices, FollowTheirPlayer) {
  Performance performance({sheet()}, touch_score({}), rate);
  drivers::LiveStrokes strokes(1, rate, 0);
  std::vector<drivers::Event> events;
  const auto last_power = [&](int samples) {
    strokes.ask(performance.stage().now(), events);
    for (const drivers::Event& event : events) {
      performance.stage().perform(event);
    }
    events.clear();
    const std::vector<double> sound = rendered(performance, samples);
    return power({sound.end() - 4800, sound.end()});
  };
  strokes.begin("bow", 0, bow_at({0.1, 0.1, 0.0}, 0.2, 0.0), 0);
  EXPECT_EQ(last_power(9600), 0.0) << "without a load";
  strokes.change("bow", 0.2, 1.0);
  const double sings = last_power(rate / 2);
  EXPECT_GT(sings, 0.0);
  strokes.end("bow");
  EXPECT_LT(last_power(rate), 0.1 * sings);
}

TEST(TouchedVoices, LeaveWhileABowRubsThem) {
  const auto map = std::make_shared<const sound_maps::SoundMap>(sheet());
  scene::Listener listener;
  listener.receivers = {{.channel = "ear", .position = {0.1, 0.3, 0.8}}};
  SoundMapVoices voices({map}, Audience(listener), rate);
  score::Bow bow = bow_at({0.1, 0.1, 0.0}, 0.2, 1.0);
  bow.duration = 60.0;
  voices.touch(0, {.contact = bow}, 0);
  std::vector<double> sound(9600);
  voices.render(sound, 0);
  EXPECT_GT(power(sound), 0.0);
  voices.remove(0);
  EXPECT_FALSE(voices.is_free(0)) << "it has not faded";
  voices.render(sound, 0);
  voices.attend();
  EXPECT_TRUE(voices.is_free(0));
}

TEST(TouchedVoices, StayWhereAHeadHearsThem) {
  const auto map = std::make_shared<const sound_maps::SoundMap>(sheet());
  scene::Listener listener;
  listener.receivers.assign(2, {.channel = "ear", .position = {0.1, -2.0, 0.5}});
  listener.head = scene::Head{.look = Vector3::UnitX(),
                              .up = Vector3::UnitZ(),
                              .responses = "/usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa",
                              .where = {}};
  SoundMapVoices voices({map}, Audience(listener, rate), rate);
  EXPECT_THROW(voices.add(1, map, {{.position = {0.1, 0.3, 0.8}}}), std::runtime_error);
  EXPECT_THROW(voices.remove(0), std::runtime_error);
}

TEST(TouchedVoices, AreForAsManyReceiversAsTheirMapsHave) {
  const auto map = std::make_shared<const sound_maps::SoundMap>(sheet());
  const std::vector<HearingPoint> receivers(map->listeners.size() + 1, {.position = {0.1, 0.3, 0.8}});
  EXPECT_THROW(SoundMapVoices({map}, Audience(receivers), rate), std::runtime_error);
}

TEST(TouchedVoices, RefuseMoreBowsThanFit) {
  Performance performance({sheet()}, touch_score({}), rate);
  for (std::size_t i = 0; i < resonators::PointContacts::most; ++i) {
    performance.play({.time = 0.0, .body = 0, .action = bow_at({0.1, 0.1, 0.0}, 0.2, 0.01)});
  }
  EXPECT_THROW(performance.play({.time = 0.0, .body = 0, .action = bow_at({0.1, 0.1, 0.0}, 0.2, 0.01)}),
               std::runtime_error);
  for (const double sample : rendered(performance, 2000)) {
    ASSERT_TRUE(std::isfinite(sample));
  }
}

}  // namespace idiophone::voices
