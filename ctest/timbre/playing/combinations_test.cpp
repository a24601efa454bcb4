// Every voice with every driver: sound maps, proxies and timbre trees by a score, OSC, MIDI, contacts and motion.

#include <gtest/gtest.h>
#include <lo/lo.h>
#include <mpi.h>

#include <cmath>
#include <numbers>
#include <set>
#include <thread>

#include "idiophone/instruments/drivers/motion_drivers.hpp"
#include "idiophone/instruments/drivers/players.hpp"
#include "idiophone/instruments/voices/buffered_voice.hpp"
#include "idiophone/instruments/voices/proxy_voices.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/instruments/voices/stage.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "ranks.hpp"
#include "temporary_file.hpp"
#include "tree_voice.hpp"

namespace idiophone::timbre {

namespace {

constexpr int rate = 8000;
constexpr std::int64_t samples = 2000;
constexpr std::int64_t beginning = 400;  // audio sample at which something happens

/// A cube of 0.1 m with two modes.
sound_maps::SoundMap cube_map() {
  sound_maps::SoundMap map;
  map.body = "cube";
  map.vertices = {{0, 0, 0.1}, {0.1, 0, 0.1}, {0, 0.1, 0.1}};
  map.triangles = {{0, 1, 2}};
  map.centre = {0.05, 0.05, 0.05};
  map.listeners = {{.name = "ear", .position = {0, 0, 1}, .delay = 0.002, .pressure = {{0.1, 0.2}, {-0.3, 0.1}}}};
  map.frequency = {300, 700};
  map.material_decay = {20, 30};
  map.radiation_decay = {1, 1};
  map.shape = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0.5};
  return map;
}

proxies::Engine cube_proxy() {
  const auto place = [](const Vector3& at) { return Vector3(0.1 * at); };
  proxies::Engine engine({.rate = rate});
  engine.add({.name = "cube",
              .levels = {std::make_shared<proxies::Lattice>(
                  proxies::grid_mesh({2, 2, 2}, place),
                  proxies::Material{.young = 1e6, .density = 600, .damping = {.mass = 20, .stiffness = 1e-5}})},
              .listener = {0, 0, 1}});
  return engine;
}

const char* const tree_text =
    "(parameter force)\n(parameter impulse 2)\n(* force impulse (damp 400 0.02) (sine 400))\n";

enum class Kind { map, proxy, tree };

std::unique_ptr<voices::Voice> voice_of(Kind kind, const voices::Audience& audience) {
  switch (kind) {
    case Kind::map:
      return std::make_unique<voices::SoundMapVoices>(voices::shared_maps({cube_map()}), audience, rate);
    case Kind::proxy:
      return std::make_unique<voices::ProxyVoices>(
          cube_proxy(), std::vector<voices::ProxyBody>{{.name = "cube", .centre = {0.05, 0.05, 0.05}, .track = {}}},
          audience, voices::ProxyHearing{.rate = rate});
    case Kind::tree:
      return std::make_unique<TreeVoice>(parse_tree(tree_text, "cube.tt"), "cube", audience, 1, rate);
  }
  return {};
}

score::HammerBlow blow() {
  return {
      .at = {0.03, 0.04, 0.1}, .direction = -Vector3::UnitZ(), .hammer = {.mass = 0.01, .hardness = 1e7, .speed = 1}};
}

/// A result in which a force of 3 N acts on the cube from `beginning` on, for 0.01 s, and a channel that follows it.
class Result {
 public:
  /// @param reach  m; how far the contact reaches along x from its point, 0 as in results of older programs
  explicit Result(double reach = 0.0) {
    auto result = results::ResultFile::create(
        file_.path(), {"hit", "0", "bodies: {cube: {}}\ncontacts: {hit: {between: [cube, floor]}}\n", {}},
        MPI_COMM_SELF);
    declare(result, "/contacts/hit/force", {"x", "y", "z"});
    declare(result, "/contacts/hit/point", {"x", "y", "z"});
    if (reach > 0) {
      declare(result, "/contacts/hit/spread", {"xx", "yy", "zz", "xy", "xz", "yz"});
    }
    declare(result, "/motion/cube/centre_of_mass", {"x", "y", "z"});
    declare(result, "/motion/cube/orientation", {"w", "x", "y", "z"});
    for (int row = 0; row < samples; ++row) {
      const double force = row >= beginning && row < beginning + 80 ? -3.0 : 0.0;
      result.append("/contacts/hit/force", std::array{0.0, 0.0, force});
      result.append("/contacts/hit/point", std::array{0.03, 0.04, 0.1});
      if (reach > 0) {
        result.append("/contacts/hit/spread", std::array{reach * reach, 0.0, 0.0, 0.0, 0.0, 0.0});
      }
      result.append("/motion/cube/centre_of_mass", std::array{0.05, 0.05, 0.05});
      result.append("/motion/cube/orientation", std::array{1.0, 0.0, 0.0, 0.0});
    }
    result.flush();
  }
  [[nodiscard]] std::filesystem::path path() const { return file_.path(); }

 private:
  static void declare(results::ResultFile& result, const std::string& path, std::vector<std::string> columns) {
    result.declare({.path = path,
                    .unit = "1",
                    .rate = rate,
                    .columns = std::move(columns),
                    .description = "test",
                    .positions = {}});
  }
  support::TemporaryFile file_{"hit.h5"};
};

std::unique_ptr<drivers::Driver> by_score() {
  const score::ScoreEvent event{.time = static_cast<double>(beginning) / rate, .body = 0, .action = blow()};
  return std::make_unique<drivers::ScoreDriver>(std::vector{event}, 1, rate);
}

std::unique_ptr<drivers::Driver> by_midi() {
  const drivers::NoteBlows blows =
      drivers::blows_of({{static_cast<double>(beginning) / rate, 60, 100}}, {{.note = 60, .body = 0, .blow = blow()}});
  return std::make_unique<drivers::ScoreDriver>(blows.events, 1, rate);
}

std::unique_ptr<drivers::Driver> by_contacts() {
  const Result result;
  return std::make_unique<drivers::KnownEvents>(
      drivers::contact_events(result.path(), {{.name = "cube", .centre = Vector3(0.05, 0.05, 0.05)}}, rate));
}

std::unique_ptr<drivers::Driver> by_motion() {
  const Result result;
  const score::MotionForce force{
      .channel = "contacts/hit/force", .column = "z", .at = {0.03, 0.04, 0.1}, .force = {0, 0, 1}, .above = 0.5};
  return std::make_unique<drivers::KnownEvents>(drivers::motion_events(result.path(), {force}, rate));
}

/// OSC that got a message before the audio sample `beginning`.
std::unique_ptr<drivers::Driver> by_osc() {
  auto player = std::make_unique<drivers::OscPlayer>("127.0.0.1", 0, std::vector<std::string>{"cube"}, 1, rate);
  lo_address here = lo_address_new("127.0.0.1", std::to_string(player->port()).c_str());
  lo_send(here, "/blow", "sfffffffff", "cube", 0.03, 0.04, 0.1, 0.0, 0.0, -1.0, 0.01, 1e7, 1.0);
  lo_address_free(here);
  std::vector<drivers::Event> events;
  for (int tries = 0; tries < 5000 && events.empty(); ++tries) {
    player->ask(beginning, beginning, events);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::make_unique<drivers::KnownEvents>(std::move(events));
}

double power(std::span<const double> sound) {
  double sum = 0.0;
  for (const double sample : sound) {
    sum += sample * sample;
  }
  return sum;
}

struct Combination {
  Kind kind;
  std::unique_ptr<drivers::Driver> (*driver)();
};

ON_RANKS(1);

class Combinations : public testing::TestWithParam<Combination> {};

ON_RANKS(1);

TEST_P(Combinations, Sound) {
  const voices::Audience audience = voices::audience_of({cube_map()});
  std::vector<std::unique_ptr<voices::Voice>> all;
  all.push_back(voice_of(GetParam().kind, audience));
  voices::Stage stage(audience, std::move(all), 1, rate);
  drivers::Drivers drivers;
  drivers.push_back(GetParam().driver());
  const std::vector<double> sound = voices::rendered(stage, drivers, samples);
  ASSERT_EQ(sound.size(), static_cast<std::size_t>(samples));
  EXPECT_EQ(power(std::span(sound).first(beginning - 1)), 0.0);  // nothing before it happens
  EXPECT_GT(power(std::span(sound).subspan(beginning, 400)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, Combinations, testing::ValuesIn([] {
                           std::vector<Combination> all;
                           for (const Kind kind : {Kind::map, Kind::proxy, Kind::tree}) {
                             for (const auto driver : {by_score, by_osc, by_midi, by_contacts, by_motion}) {
                               all.push_back({kind, driver});
                             }
                           }
                           return all;
                         }()));

/// All three voices, computed at once or ahead.
std::vector<double> together(bool is_buffered, std::int64_t block) {
  const voices::Audience audience = voices::audience_of({cube_map()});
  std::vector<std::unique_ptr<voices::Voice>> all;
  for (const Kind kind : {Kind::map, Kind::proxy, Kind::tree}) {
    auto voice = voice_of(kind, audience);
    if (is_buffered && kind != Kind::map) {
      voice = std::make_unique<voices::BufferedVoice>(std::move(voice), 1, rate,
                                                      voices::Buffering{.frames = 128, .buffers = 20});
    }
    all.push_back(std::move(voice));
  }
  voices::Stage stage(audience, std::move(all), 1, rate);
  std::vector<score::ScoreEvent> events;
  for (std::size_t body = 0; body < 3; ++body) {
    events.push_back({.time = 0.05 + 0.01 * static_cast<double>(body), .body = body, .action = blow()});
  }
  drivers::Drivers drivers;
  drivers.push_back(std::make_unique<drivers::ScoreDriver>(std::move(events), 1, rate));
  return voices::rendered(stage, drivers, samples, block);
}

TEST(Stages, GiveTheSameBitsInBlocksOfAnySizeAndComputedAhead) {
  const std::vector<double> expected = together(false, 512);
  EXPECT_GT(power(expected), 0.0);
  EXPECT_EQ(together(false, 100), expected);
  EXPECT_EQ(together(true, 512), expected);
}

TEST(TreeVoice, IsAsStrongAsWhatExcitesIt) {
  TreeVoice voice(parse_tree(tree_text, "cube.tt"), "cube", {}, 1, rate);
  voice.excite(0, {.forces = {{.start = 10}}, .strength = {.force = 3.0, .impulse = 0.5}}, 0);
  std::vector<double> sound(100);
  voice.render(sound, 0);
  for (int i = 0; i < 100; ++i) {
    const double time = (i - 10.0) / rate, angle = 2.0 * std::numbers::pi * 400.0 * time;
    EXPECT_NEAR(sound[i], i < 10 ? 0.0 : 1.5 * std::exp(-0.02 * angle) * std::sin(angle), 1e-9) << i;
  }
}

TEST(TreeVoice, GoesOnWithAContactThatLasts) {
  TreeVoice voice(parse_tree("(parameter force) force", "cube.tt"), "cube", {}, 1, rate);
  voice.excite(0, {.forces = {{.start = 0}}, .strength = {.force = 1.0}}, 0);
  voice.excite(0, {.forces = {{.start = 10}}, .strength = {.force = 1.0}, .begins = false}, 0);
  std::vector<double> sound(20);
  voice.render(sound, 0);
  EXPECT_EQ(sound, std::vector<double>(20, 1.0));
}

TEST(TreeVoice, IsHeardFromThePlaceOfTheForce) {
  const voices::Audience audience(std::vector<voices::HearingPoint>{{.position = {0, 0, 3.43}}});
  TreeVoice voice(parse_tree("(parameter force) (* force (sine 100))", "cube.tt"), "cube", audience, 1, rate);
  voice.excite(0, {.forces = {{.start = 0}}, .strength = {.force = 1.0}}, 0);
  std::vector<double> sound(400);
  voice.render(sound, 0);
  EXPECT_LT(power(std::span(sound).first(70)), 1e-6);  // 3.43 m are 80 samples
  for (std::size_t i = 150; i < 400; ++i) {
    const double angle = 2.0 * std::numbers::pi * 100.0 * (static_cast<double>(i) - 80.0) / rate;
    EXPECT_NEAR(sound[i], std::sin(angle) / 3.43, 1e-3);
  }
}

TEST(TreeVoice, TunesItsParameters) {
  TreeVoice voice(parse_tree("(parameter size) size", "cube.tt"), "cube", {}, 1, rate);
  EXPECT_THROW(voice.require_tunable(0, {.tension = 2.0}), std::runtime_error);
  EXPECT_NO_THROW(voice.require_tunable(0, {.size = 2.0}));
  voice.tune(0, {.size = 2.0}, 5);
  voice.excite(0, {.forces = {{.start = 5}}, .strength = {}}, 0);
  std::vector<double> sound(10);
  voice.render(sound, 0);
  EXPECT_EQ(sound, (std::vector<double>{0, 0, 0, 0, 0, 2, 2, 2, 2, 2}));
}

TEST(TreeVoice, RefusesParametersThatNobodyGives) {
  EXPECT_THROW(TreeVoice(parse_tree("(parameter colour) colour", "cube.tt"), "cube", {}, 1, rate), deck::DeckError);
}

TEST(ContactEvents, AreSpreadOverThePatch) {
  const Result result(0.01);
  const std::vector<drivers::Event> events =
      drivers::contact_events(result.path(), {{.name = "cube", .centre = {}}}, rate);
  double impulse = 0.0;
  std::set<double> places;
  for (const resonators::PointForce& force : std::get<drivers::Excitation>(events.at(0).action).forces) {
    places.insert(std::round(1e6 * force.at.x()));
    for (const resonators::ForcePiece& piece : force.force) {
      impulse += piece.mean * force.direction.z() / rate;
    }
  }
  const double farthest = std::round(1e4 * std::sqrt(3.0));
  EXPECT_EQ(places, (std::set<double>{30000 - farthest, 30000, 30000 + farthest}));
  EXPECT_NEAR(std::get<drivers::Excitation>(events[0].action).place->x(), 0.03, 1e-15);
  EXPECT_NEAR(impulse, -3.0 * 64 / rate, 1e-12);
}

TEST(ContactEvents, AreForcesOfTheWholeTouch) {
  const Result result;
  const std::vector<drivers::Event> events =
      drivers::contact_events(result.path(), {{.name = "cube", .centre = {}}}, 2 * rate);
  ASSERT_EQ(events.size(), 2U);  // 64 rows and 16
  const auto& first = std::get<drivers::Excitation>(events[0].action);
  const auto& second = std::get<drivers::Excitation>(events[1].action);
  EXPECT_TRUE(first.begins);
  EXPECT_FALSE(second.begins);
  EXPECT_NEAR(first.strength.impulse, 0.03, 1e-12);
  EXPECT_EQ(first.strength.force, 3.0);
  double impulse = 0.0;
  for (const drivers::Event& event : events) {
    for (const resonators::PointForce& force : std::get<drivers::Excitation>(event.action).forces) {
      for (const resonators::ForcePiece& piece : force.force) {
        impulse += piece.mean * force.direction.z() / (2 * rate);
      }
    }
  }
  EXPECT_NEAR(impulse, -0.03, 1e-12);
  EXPECT_EQ(events[0].start, 2 * beginning);
  EXPECT_THROW(static_cast<void>(drivers::contact_events(result.path(), {{.name = "ball", .centre = {}}}, rate)),
               std::runtime_error);
}

}  // namespace

}  // namespace idiophone::timbre
