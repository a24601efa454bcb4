#include "idiophone/instruments/voices/proxy_voices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "heard_sound.hpp"

namespace idiophone::voices {

namespace {

constexpr int sound_rate = 16000;
constexpr double air = 343.0;
constexpr double closest = 4.0;                          // m, at which a body passes the listener
constexpr double above = 1.0;                            // m, by which the listener is above it
const Eigen::AngleAxisd oblique(0.3, Vector3::UnitZ());  // no triangle is seen from its edge

/// Stiff, so that the lowest mode is the only one that matters after a blow; rings long.
std::shared_ptr<const proxies::Lattice> ringing_box(double young = 4e7) {
  const auto place = [](const Vector3& at) {
    return Vector3((at - Vector3::Constant(0.5)).cwiseProduct(Vector3(0.3, 0.1, 0.1)));
  };
  return std::make_shared<proxies::Lattice>(
      proxies::grid_mesh({3, 1, 1}, place),
      proxies::Material{.young = young, .density = 600, .damping = {.mass = 0.0, .stiffness = 0.0}});
}

drivers::Excitation tap_at(std::int64_t start) {
  return {
      .forces = {{.start = start, .at = {0.15, 0.0, 0.0}, .direction = Vector3(-1, 0, 0), .force = {{.mean = 100.0}}}},
      .strength = {}};
}

ProxyVoices voices_of(std::vector<ProxyBody> bodies, std::vector<HearingPoint> points,
                      proxies::EngineOptions options = {.rate = sound_rate, .most_active = 8}) {
  proxies::Engine engine(options);
  const auto lattice = ringing_box();
  for (const ProxyBody& body : bodies) {
    engine.add({.name = body.name, .levels = {lattice}});
  }
  return {
      std::move(engine), std::move(bodies), Audience(std::move(points)), {.speed_of_sound = air, .rate = sound_rate}};
}

/// Along x, past a listener at (0, closest, above), which it passes at a time and to which it always turns the same
/// side.
drivers::BodyTrack passing(double speed, double time_of_passing) {
  return [=](double time) {
    const double x = speed * (time - time_of_passing);
    return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0) *
                             Eigen::AngleAxisd(std::atan2(x, closest), Vector3::UnitZ()) * oblique);
  };
}

std::vector<double> sound_of(ProxyVoices& voices, std::size_t frames, std::size_t channels = 1,
                             std::size_t block = 512) {
  std::vector<double> sound(frames * channels);
  for (std::size_t first = 0; first < frames; first += block) {
    const std::size_t count = std::min(block, frames - first);
    voices.render(std::span(sound).subspan(first * channels, count * channels), 0);
  }
  return sound;
}

/// Squared magnitude at a frequency of a piece of sound, with a Hann window.
double power_at(std::span<const double> sound, double frequency) {
  double real = 0.0, imaginary = 0.0;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const double place = static_cast<double>(i) / static_cast<double>(sound.size());
    const double angle = 2.0 * std::numbers::pi * frequency * static_cast<double>(i) / sound_rate;
    const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * place);
    real += window * sound[i] * std::cos(angle);
    imaginary += window * sound[i] * std::sin(angle);
  }
  return real * real + imaginary * imaginary;
}

/// The strongest frequency between two.
double pitch_of(std::span<const double> sound, double low, double high) {
  double best = low, most = 0.0;
  for (double step = 4.0; step > 0.05; step /= 4.0) {
    for (double frequency = low; frequency <= high; frequency += step) {
      if (const double power = power_at(sound, frequency); power > most) {
        most = power;
        best = frequency;
      }
    }
    low = best - step;
    high = best + step;
  }
  return best;
}

}  // namespace

TEST(ProxyVoices, BodyThatPassesTheListenerShiftsItsPitchAndLevel) {
  constexpr double speed = 40.0, passes_at = 1.0;  // m/s, s
  const double nearest = std::hypot(closest, above);
  ProxyVoices still = voices_of({{.name = "box", .centre = Vector3::Zero(), .track = passing(0.0, 0.0)}},
                                {{.position = {0, closest, above}}});
  ProxyVoices moving = voices_of({{.name = "box", .centre = Vector3::Zero(), .track = passing(speed, passes_at)}},
                                 {{.position = {0, closest, above}}});
  still.excite(0, tap_at(0), 0);
  moving.excite(0, tap_at(0), 0);
  const std::vector<double> own = sound_of(still, 2 * sound_rate), heard = sound_of(moving, 2 * sound_rate);
  const double pitch = pitch_of(std::span(own).subspan(4000, 4000), 300.0, 3000.0);
  for (const double time : {0.4, 0.8, 1.2, 1.7}) {  // at which the sound is emitted
    const double x = speed * (time - passes_at), distance = std::hypot(x, closest, above);
    const auto middle = static_cast<std::size_t>((time + distance / air) * sound_rate);
    const double shift = 1.0 / (1.0 + speed * x / distance / air);  // receding where x > 0
    const auto half = static_cast<std::size_t>(400.0 / shift);
    const auto piece = std::span(heard).subspan(middle - half, 2 * half);
    EXPECT_NEAR(pitch_of(piece, 0.85 * pitch, 1.2 * pitch) / (shift * pitch), 1.0, 0.005) << time;
    const auto emitted = static_cast<std::size_t>((time + nearest / air) * sound_rate);
    const double level = support::root_mean_square(std::span(own).subspan(emitted - 400, 800)) * nearest;
    // What arrives in a shorter time than it was emitted is stronger by as much.
    EXPECT_NEAR(support::root_mean_square(piece) * distance / level, shift, 0.08) << time;
  }
}

TEST(ProxyVoices, SoundArrivesAfterItsWay) {
  ProxyVoices voices = voices_of({{.name = "box", .centre = Vector3::Zero(), .track = {}}},
                                 {{.position = {0, 0, 3.43}}, {.position = {0, 0, 6.86}}});
  voices.excite(0, tap_at(1000), 0);
  const std::vector<double> sound = sound_of(voices, 2000, 2);
  const auto energy = [&](std::size_t channel, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      sum += sound[2 * i + channel] * sound[2 * i + channel];
    }
    return sum;
  };
  const double near = energy(0, 1155, 1555), far = energy(1, 1315, 1715);  // 160 and 320 samples of way
  EXPECT_LT(energy(0, 0, 1155), 1e-6 * near);
  EXPECT_LT(energy(1, 0, 1315), 1e-6 * far);
  EXPECT_NEAR(near / far, 4.0, 0.05);
}

TEST(ProxyVoices, NearestBodyChangesAsBodiesMove) {
  // One body comes, the other goes: the one that is nearer when it is struck replaces the other.
  for (const bool is_late : {false, true}) {
    ProxyVoices voices = voices_of({{.name = "comes", .centre = Vector3::Zero(), .track = passing(10.0, 1.0)},
                                    {.name = "goes", .centre = Vector3::Zero(), .track = passing(10.0, 0.0)}},
                                   {{.position = {0, closest, 0}}}, {.rate = sound_rate, .most_active = 1});
    const std::int64_t start = is_late ? 14000 : 2000;
    voices.excite(0, tap_at(start), 0);
    voices.excite(1, tap_at(start + 100), 0);
    static_cast<void>(sound_of(voices, 16000));
    const std::vector<proxies::Choice> choices = voices.take_choices();
    ASSERT_GE(choices.size(), 2U);
    EXPECT_EQ(choices[1].kind, is_late ? proxies::Choice::Kind::refuse : proxies::Choice::Kind::stop);
  }
}

TEST(ProxyVoices, PriorityOfWhatSoundsFollowsItsDistance) {
  // It was the nearest when it was struck, and is far away when the other is struck.
  ProxyVoices voices = voices_of({{.name = "goes", .centre = Vector3::Zero(), .track = passing(10.0, 0.0)},
                                  {.name = "stays", .centre = Vector3::Zero(), .track = {}}},
                                 {{.position = {0, 2.0, 0}}}, {.rate = sound_rate, .most_active = 1});
  voices.excite(0, tap_at(0), 0);
  voices.excite(1, tap_at(8000), 0);
  static_cast<void>(sound_of(voices, 9000));
  const std::vector<proxies::Choice> choices = voices.take_choices();
  ASSERT_EQ(choices.size(), 4U);
  EXPECT_EQ(choices[1].kind, proxies::Choice::Kind::stop);
  EXPECT_EQ(choices[1].body, 0U);
  EXPECT_EQ(choices[2].kind, proxies::Choice::Kind::begin);
}

TEST(ProxyVoices, MotionGivesTheSameBitsForAnyBlocks) {
  std::vector<std::vector<double>> sounds;
  for (const std::size_t block : {512, 77}) {
    ProxyVoices voices = voices_of({{.name = "box", .centre = Vector3::Zero(), .track = passing(20.0, 0.1)}},
                                   {{.position = {0, closest, 0}}});
    voices.excite(0, tap_at(10), 0);
    voices.hear_at({.start = 700, .length = 1024, .points = {{.position = {1, closest, 0}}}});
    sounds.push_back(sound_of(voices, 3000, 1, block));
  }
  EXPECT_EQ(sounds[0], sounds[1]);
}

TEST(ProxyVoices, HeadHearsABodyFromItsSide) {
  // A body passes in front of a head that looks along y, from its left to its right.
  scene::Listener listener;
  listener.receivers.assign(2, {.channel = "ear", .position = Vector3::Zero()});
  listener.head = scene::Head{.look = Vector3::UnitY(),
                              .up = Vector3::UnitZ(),
                              .responses = "/usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa",
                              .where = {}};
  const auto lattice = ringing_box();
  std::vector<std::vector<double>> sounds;
  for (const std::size_t block : {512, 100}) {
    proxies::Engine engine({.rate = sound_rate});
    engine.add({.name = "box", .levels = {lattice}});
    const drivers::BodyTrack track = [](double time) {
      return Eigen::Isometry3d(Eigen::Translation3d(20.0 * (time - 0.2), 1.5, 0.0));
    };
    ProxyVoices voices(std::move(engine), {{.name = "box", .centre = Vector3::Zero(), .track = track}},
                       Audience(listener, sound_rate), {.speed_of_sound = air, .rate = sound_rate});
    voices.excite(0, tap_at(10), 0);
    sounds.push_back(sound_of(voices, 6400, 2, block));
  }
  EXPECT_EQ(sounds[0], sounds[1]);
  const auto power_of = [&](std::size_t channel, std::size_t first) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + 1500; ++i) {
      sum += std::pow(sounds[0][2 * i + channel], 2);
    }
    return sum;
  };
  EXPECT_GT(power_of(0, 500), 1.5 * power_of(1, 500));
  EXPECT_GT(power_of(1, 4800), 1.5 * power_of(0, 4800));
}

TEST(ProxyVoices, RefusesListenersThatAreTooFarAway) {
  EXPECT_THROW(voices_of({{.name = "box", .centre = Vector3::Zero(), .track = {}}}, {{.position = {0, 0, 400}}}),
               std::runtime_error);
}

}  // namespace idiophone::voices
