// What a stage of sound maps leaves out to keep within a budget.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "idiophone/instruments/voices/shared_budget.hpp"
#include "performance.hpp"
#include "sheet_map.hpp"
#include "sound_power.hpp"

namespace idiophone::voices {

namespace {

constexpr double no_limit = 1e9;  // of a budget that suffices for everything

/// A body with one mode.
struct Tone {
  double frequency;  ///< Hz
  double level;      ///< of its sound, dB
};

/// Bodies that were struck at once, and what is heard of them.
class Stand {
 public:
  Stand(const std::vector<sound_maps::SoundMap>& maps, const MapDetail& detail)
      : stage_(audience_of(maps), voices(maps, detail), audience_of(maps).receivers(), rate) {
    for (std::size_t body = 0; body < maps.size(); ++body) {
      strike(body, 0.0);
    }
  }

  void strike(std::size_t body, double time) {
    const score::HammerBlow blow{.at = {0.06, 0.03, 0.0},
                                 .direction = -Vector3::UnitZ(),
                                 .hammer = {.mass = 0.01, .hardness = 1e9, .speed = 1.0}};
    stage_.perform(drivers::event_of({.time = time, .body = body, .action = blow},
                                     static_cast<std::int64_t>(time * rate), 1, rate));
  }

  [[nodiscard]] std::vector<double> render(std::int64_t samples, std::int64_t block = 512) {
    return rendered(stage_, {}, samples, block);
  }

  [[nodiscard]] SoundMapVoices& maps() { return *maps_; }
  [[nodiscard]] Stage& stage() { return stage_; }

 private:
  std::vector<std::unique_ptr<Voice>> voices(const std::vector<sound_maps::SoundMap>& maps, const MapDetail& detail) {
    auto voice = std::make_unique<SoundMapVoices>(shared_maps(maps), audience_of(maps), rate, detail);
    maps_ = voice.get();
    std::vector<std::unique_ptr<Voice>> all;
    all.push_back(std::move(voice));
    return all;
  }

  SoundMapVoices* maps_ = nullptr;
  Stage stage_;
};

std::vector<sound_maps::SoundMap> sheets(int count) {
  std::vector<sound_maps::SoundMap> maps;
  for (int i = 0; i < count; ++i) {
    maps.push_back(sound_maps::sheet("sheet" + std::to_string(i)));
    for (double& frequency : maps.back().frequency) {
      frequency *= 1.0 + 0.07 * i;  // sounds of one pitch would add up coherently
    }
  }
  return maps;
}

std::vector<sound_maps::SoundMap> tones(const std::vector<Tone>& all) {
  std::vector<sound_maps::SoundMap> maps;
  for (const Tone& tone : all) {
    sound_maps::SoundMap map = sound_maps::sheet("tone" + std::to_string(maps.size()));
    map.frequency.assign(1, tone.frequency);
    map.material_decay.assign(1, 1.0);
    map.radiation_decay.assign(1, 0.0);
    map.shape.resize(3 * map.vertices.size());
    for (sound_maps::MapListener& listener : map.listeners) {
      listener.pressure.assign(1, std::pow(10.0, 0.05 * tone.level));
    }
    maps.push_back(map);
  }
  return maps;
}

/// In one channel of two.
double largest_jump(const std::vector<double>& sound) {
  double largest = 0.0;
  for (std::size_t i = 2; i < sound.size(); ++i) {
    largest = std::max(largest, std::abs(sound[i] - sound[i - 2]));
  }
  return largest;
}

/// Part of a sound's power that is near a frequency.
double power_at(const std::vector<double>& sound, double frequency) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < sound.size() / 2; ++i) {
    sum += sound[2 * i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(i) / rate);
  }
  return std::norm(sum);
}

}  // namespace

TEST(ModeChoice, LeavesNothingOutWithinItsBudget) {
  Stand plain(sheets(3), {}), limited(sheets(3), {.budget = no_limit});
  const std::vector<double> expected = plain.render(9600), found = limited.render(9600);
  std::vector<double> difference(found.size());
  std::ranges::transform(expected, found, difference.begin(), std::minus());
  EXPECT_GT(power(expected), 0.0);
  EXPECT_LT(power(difference), 1e-12 * power(expected));  // strides begin elsewhere
  EXPECT_TRUE(plain.maps().take_choices().empty());
  const std::vector<MapChoice> choices = limited.maps().take_choices();
  ASSERT_EQ(choices.size(), 10U);
  EXPECT_EQ(choices[5].sample, 5 * MapChoice::interval);
  EXPECT_EQ(choices[5].sounding, 3U);
  EXPECT_EQ(choices[5].heard, choices[5].modes);
  EXPECT_EQ(choices[5].left_out, 0.0);
}

TEST(ModeChoice, KeepsWithinItsBudgetAndTellsItsLoss) {
  Stand full(sheets(6), {.budget = no_limit});
  const std::vector<double> expected = full.render(24000);
  const double whole = full.maps().take_choices()[10].cost;
  double last_loss = 1.0;
  for (const double share : {0.3, 0.6, 0.9}) {
    Stand limited(sheets(6), {.budget = share * whole, .priority = proxies::Priority::audibility});
    const std::vector<double> found = limited.render(24000);
    const std::vector<MapChoice> choices = limited.maps().take_choices();
    for (std::size_t i = 4; i < choices.size(); ++i) {  // the forces are over
      EXPECT_LE(choices[i].cost, share * whole);
      EXPECT_LT(choices[i].heard, choices[i].modes);
    }
    double error = 0.0, all = 0.0;
    for (std::size_t i = 2 * 12000; i < found.size(); ++i) {
      error += std::pow(found[i] - expected[i], 2);
      all += expected[i] * expected[i];
    }
    const double loss = error / all;
    EXPECT_LT(loss, last_loss);
    double power_told = 0.0, left_out_told = 0.0;
    for (std::size_t i = 12; i < choices.size(); ++i) {
      power_told += choices[i].power;
      left_out_told += choices[i].left_out * choices[i].power;
    }
    EXPECT_NEAR(loss / (left_out_told / power_told), 1.0, 0.5);
    last_loss = loss;
  }
}

/// Requires that a sound within part of its budget has no larger jump than the whole one, about each choice.
void expect_no_click(const std::vector<sound_maps::SoundMap>& maps, double share) {
  Stand full(maps, {.budget = no_limit});
  const std::vector<double> expected = full.render(24000);
  const double whole = full.maps().take_choices()[10].cost;
  Stand limited(maps, {.budget = share * whole, .priority = proxies::Priority::audibility});
  const std::vector<double> found = limited.render(24000);
  for (std::size_t first = 2 * 1000; first < found.size(); first += 2 * 2048) {  // the first choice is at 1024
    const auto part = [first](const std::vector<double>& sound) {
      return std::vector(sound.begin() + static_cast<std::ptrdiff_t>(first - 2),
                         sound.begin() + static_cast<std::ptrdiff_t>(std::min(first + 2 * 2048, sound.size())));
    };
    EXPECT_LE(largest_jump(part(found)), 1.01 * largest_jump(part(expected))) << first;
  }
}

TEST(ModeChoice, NeverClicks) {
  expect_no_click(sheets(6), 0.0);
  expect_no_click(sheets(6), 0.4);
  expect_no_click(tones({{100.0, 0.0}}), 0.0);  // whose own jumps are small
}

TEST(ModeChoice, GivesTheSameBitsInBlocksOfAnySize) {
  const auto sound = [](std::int64_t block) {
    Stand limited(sheets(4), {.budget = 2e-3, .priority = proxies::Priority::loudness});
    limited.strike(2, 0.1);
    return limited.render(9000, block);
  };
  const std::vector<double> expected = sound(512);
  EXPECT_GT(power(expected), 0.0);
  for (const std::int64_t block : {1, 100, 1500, 9000}) {
    EXPECT_EQ(sound(block), expected) << block;
  }
}

TEST(ModeChoice, LeavesOutWhatIsMasked) {
  const std::vector<sound_maps::SoundMap> maps = tones({{1000.0, 0.0}, {1060.0, -25.0}, {5000.0, -40.0}});
  Stand full(maps, {.budget = no_limit});
  const std::vector<double> expected = full.render(24000);
  const double for_two = 0.8 * full.maps().take_choices()[20].cost;
  for (const bool masking : {true, false}) {
    Stand limited(maps, {.budget = for_two, .priority = proxies::Priority::audibility, .masking = masking});
    std::vector<double> found = limited.render(24000);
    const auto kept = [&](double frequency) {
      const std::vector<double> late(found.end() - 24000, found.end()), whole(expected.end() - 24000, expected.end());
      return power_at(late, frequency) / power_at(whole, frequency);
    };
    EXPECT_NEAR(kept(1000.0), 1.0, 1e-3);
    EXPECT_NEAR(kept(1060.0), masking ? 0.0 : 1.0, 0.1);
    EXPECT_NEAR(kept(5000.0), masking ? 1.0 : 0.0, 0.1);
  }
}

TEST(ModeChoice, BodyOfTheGreatestPriorityIsHeard) {
  const std::vector<sound_maps::SoundMap> maps = tones({{1000.0, 0.0}, {4000.0, -20.0}});
  Stand limited(maps, {.budget = no_limit, .priority = proxies::Priority::fixed});
  static_cast<void>(limited.render(12000));
  const double for_one = 0.6 * limited.maps().take_choices()[10].cost;
  const auto heard = [&] {
    std::vector<double> sound = limited.render(12000);
    sound.erase(sound.begin(), sound.begin() + 12000);
    return power_at(sound, 1000.0) > power_at(sound, 4000.0) ? 0 : 1;
  };
  score::Detail budget, priority, level;
  budget.budget = for_one;
  priority.priority = 1.0;
  level.level = 1;
  limited.stage().perform({.start = limited.stage().now(), .body = 0, .action = budget});
  EXPECT_EQ(heard(), 0);
  static_cast<void>(limited.maps().take_choices());
  limited.stage().perform({.start = limited.stage().now(), .body = 1, .action = priority});
  EXPECT_EQ(heard(), 1);
  int waits = 0;  // in which the one fades and the other is not heard yet
  for (const MapChoice& choice : limited.maps().take_choices()) {
    EXPECT_LE(choice.cost, for_one);
    EXPECT_GT(choice.cost, 0.4 * for_one);
    waits += choice.heard == 0 ? 1 : 0;
  }
  EXPECT_EQ(waits, 1);
  EXPECT_THROW(limited.stage().perform({.start = 0, .body = 1, .action = level}), std::runtime_error);
}

/// A silent body that is struck just before a choice: another one may be before the next.
TEST(ModeChoice, KeepsRoomForBlows) {
  std::vector<sound_maps::SoundMap> maps = tones({{1000.0, 0.0}, {4000.0, 0.0}});
  maps[1].material_decay = {2000.0};
  const auto choices = [&](double budget) {
    Stand stand(maps, {.budget = budget, .priority = proxies::Priority::audibility});
    stand.strike(1, static_cast<double>(20 * MapChoice::interval - 3) / rate);
    static_cast<void>(stand.render(30 * MapChoice::interval));
    return stand.maps().take_choices();
  };
  const double enough = 1.05 * choices(no_limit)[20].cost;
  const std::vector<MapChoice> found = choices(enough);
  EXPECT_EQ(found[19].heard, found[19].modes);
  EXPECT_EQ(found[20].modes, 2U);
  EXPECT_EQ(found[20].heard, 1U);
  EXPECT_EQ(found[25].heard, found[25].modes);
}

TEST(ModeChoice, GivesWayToProxiesOfGreaterPriority) {
  const auto shared = std::make_shared<SharedBudget>(2, 1);
  const std::vector<sound_maps::SoundMap> maps = tones({{1000.0, 0.0}, {4000.0, 0.0}});
  Stand limited(maps, {.budget = 1.0, .priority = proxies::Priority::fixed, .shared = shared});
  shared->proxies.make(std::vector<Claim>{{.priority = -0.5, .cost = 1.0}});
  static_cast<void>(limited.render(12000));
  const MapChoice last = limited.maps().take_choices().back();
  EXPECT_EQ(last.sounding, 2U);
  EXPECT_EQ(last.silent, 1U);
  EXPECT_LE(shared->maps.at_least(0.0), last.cost);
  EXPECT_GT(shared->maps.at_least(0.0), 0.5 * last.cost) << "without the choice itself";
  EXPECT_EQ(shared->maps.at_least(0.1), 0.0);
}

}  // namespace idiophone::voices
