#include "idiophone/instruments/engines/engine_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "contact_sounds.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "moving_body.hpp"
#include "surface_pair.hpp"
#include "vectors.hpp"

namespace idiophone::engines {

namespace {

constexpr std::size_t most_channels = 4;
constexpr double most_ahead = 0.1;      // s, by which contacts may be ahead of the sound, beside the latency
constexpr double longest_pause = 0.25;  // s, of the audio thread, after which contacts are left out
constexpr double largest = 1e6;         // of any number of an event
constexpr double least_mass = 1e-9;     // kg
constexpr double shortest_step = 1e-5;  // s

void require(bool good, const std::string& problem) {
  if (!good) {
    throw std::runtime_error(problem);
  }
}

/// The same for the audio thread: a text takes memory only if it is needed.
void require(bool good, const char* problem) {
  if (!good) {
    throw std::runtime_error(problem);
  }
}

bool is_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::abs(number) <= largest; });
}

std::vector<Vector3> vectors_of(std::span<const Triple> triples) {
  std::vector<Vector3> vectors;
  for (const Triple& triple : triples) {
    require(is_finite(triple), "an ear is not at a place: its coordinates have to be from -1e6 to 1e6 m");
    vectors.push_back(vector_of(triple));
  }
  return vectors;
}

/// Ears before the first step, when all bodies are where their maps are: no farther away than can be played.
std::vector<Vector3> first_ears(std::vector<Vector3> ears, const std::vector<SharedMap>& bodies) {
  double farthest = largest;
  for (const SharedMap& map : bodies) {
    farthest = std::min(farthest, 0.9 * (voices::longest_way * map->air_speed - map->centre.norm()));
  }
  for (Vector3& ear : ears) {
    ear *= std::min(1.0, farthest / std::max(farthest, ear.norm()));
  }
  return ears;
}

voices::Audience audience_at(const std::vector<Vector3>& ears) {
  scene::Listener listener;
  for (const Vector3& ear : ears) {
    listener.receivers.push_back({.channel = "ear", .position = ear});
  }
  return voices::Audience(std::move(listener));
}

std::vector<double> masses_of(const std::vector<SharedMap>& bodies) {
  std::vector<double> masses;
  std::ranges::transform(bodies, std::back_inserter(masses), [](const SharedMap& map) { return map->mass; });
  return masses;
}

/// @return the same
StageOptions checked(StageOptions options) {
  require(options.rate >= 8000 && options.rate <= 384000, "the rate has to be from 8000 to 384000 1/s");
  require(!options.ears.empty() && options.ears.size() <= most_channels, "a stage has 1 to 4 ears");
  require(options.latency >= 0.0 && options.latency <= 1.0, "the latency has to be from 0 to 1 s");
  require(options.budget >= 0.0, "the budget must not be below 0");
  return options;
}

const std::vector<SharedMap>& checked(const std::vector<SharedMap>& bodies) {
  require(!bodies.empty(), "a stage needs a body");
  require(std::ranges::all_of(bodies, [](const SharedMap& map) { return map != nullptr; }), "a body has no map");
  return bodies;
}

std::vector<Surface> checked(std::vector<Surface> surfaces) {
  require(!surfaces.empty(), "a stage needs a surface");
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    check_surface(surfaces[i], i);
  }
  return surfaces;
}

}  // namespace

class EngineStage::Parts {
 public:
  Parts(StageOptions stage_options, const std::vector<SharedMap>& maps, std::vector<Surface> surfaces)
      : options(checked(std::move(stage_options))),
        channels(options.ears.size()),
        ears(vectors_of(options.ears)),
        surface_count(surfaces.size()),
        sounds(checked(std::move(surfaces)), masses_of(checked(maps)), options.rate, options.most_strokes,
               options.seed),
        voices(maps, audience_at(first_ears(ears, maps)), options.rate,
               {.budget = options.budget, .priority = proxies::Priority::audibility}) {
    const std::vector<Vector3> first = first_ears(ears, maps);
    for (const SharedMap& map : maps) {
      bodies.emplace_back(*map, first, options.rate);
    }
  }

  void check(const ContactEvent& event) const {
    const auto [first, second] = event.bodies;
    const auto count = static_cast<std::int32_t>(bodies.size());
    require(first >= ContactEvent::nobody && first < count && second >= ContactEvent::nobody && second < count &&
                std::max(first, second) >= 0,
            fmt::format("a contact is between bodies {} and {}; the stage has {}", first, second, count));
    require(first != second, fmt::format("a contact is between body {} and itself", first));
    for (const std::int32_t surface : event.surfaces) {
      require(surface >= 0 && static_cast<std::size_t>(surface) < surface_count,
              fmt::format("a contact has surface {}; the stage has {}", surface, surface_count));
    }
    const std::array numbers = {event.impulse, event.roll, event.mass, event.moment};
    require(is_finite(event.point) && is_finite(event.normal) && is_finite(event.slip) && is_finite(numbers),
            "a contact has a number that is not finite or above 1e6");
    require(event.impulse >= 0.0 && event.roll >= 0.0 && event.moment <= 1.0,
            "a contact has an impulse or a speed below 0, or a moment above 1");
    require(event.mass <= 0.0 || event.mass >= least_mass, "a contact moves a mass below 1e-9 kg");
    require(event.impulse == 0.0 || std::abs(vector_of(event.normal).norm() - 1.0) < 1e-3,
            "the normal of a contact is no unit vector");
  }

  /// Where contacts are now. @return whether anybody hears them
  bool keep_time(double duration) {
    const std::int64_t played = rendered.load(std::memory_order_acquire);
    pause = played == last_played ? pause + duration : 0.0;
    last_played = played;
    const double earliest = static_cast<double>(played) + options.latency * options.rate;
    const bool is_ahead = clock > earliest + most_ahead * options.rate;
    clock = std::max(clock, earliest);
    start = std::llround(clock);
    clock += is_ahead ? 0.0 : duration * options.rate;
    return pause <= longest_pause;
  }

  /// The listener first, then the forces that he hears.
  void send(std::span<const ContactForce> forces, std::int64_t length) {
    std::vector<drivers::Excitation> excitations(bodies.size());
    for (const ContactForce& force : forces) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (force.bodies[side] != ContactEvent::nobody) {
          const auto body = static_cast<std::size_t>(force.bodies[side]);
          resonators::PointForce& added = excitations[body].forces.emplace_back(bodies[body].in_body(force.force));
          added.direction *= side == 0 ? 1.0 : -1.0;
        }
      }
    }
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      const bool is_excited = !excitations[body].forces.empty();
      if (const auto place = bodies[body].follow(ears, start, length, is_excited)) {
        voices.hear_at(body, *place);
      }
      for (const resonators::PointForce& force : excitations[body].forces) {
        bodies[body].sound_until(force.start + static_cast<std::int64_t>(force.force.size()));
      }
      if (is_excited) {
        voices.excite(body, excitations[body], 0);
      }
    }
  }

  /// What was chosen to be heard since the last call; nothing without a budget.
  void note_choices() {
    for (const voices::MapChoice& choice : voices.take_choices()) {
      last_report.sounding = choice.sounding;
      last_report.modes = choice.modes;
      last_report.heard = choice.heard;
      last_report.cost = choice.cost;
      last_report.loss = choice.left_out;
    }
  }

  StageOptions options;
  const std::size_t channels;
  std::vector<Vector3> ears;  // in the world
  std::size_t surface_count;
  ContactSounds sounds;
  voices::SoundMapVoices voices;
  std::vector<MovingBody> bodies;
  std::vector<ContactEvent> events;  // of the step that follows
  double clock = 0.0;                // audio sample at which the next step begins
  std::int64_t start = 0;            // of the present step
  double pause = 0.0;                // since the audio thread rendered last, s
  std::int64_t last_played = 0;
  std::uint64_t left_out = 0;
  StageReport last_report;
  // of the audio thread
  std::atomic<std::int64_t> rendered{0};
  std::array<double, 1024> piece{};
};

EngineStage::EngineStage(StageOptions options, const std::vector<SharedMap>& bodies, std::vector<Surface> surfaces)
    : parts_(std::make_unique<Parts>(std::move(options), bodies, std::move(surfaces))) {}

EngineStage::~EngineStage() = default;

std::size_t EngineStage::channels() const {
  return parts_->channels;
}

void EngineStage::place(std::size_t body, const Pose& pose) {
  require(body < parts_->bodies.size(), fmt::format("there is no body {}", body));
  const double size = std::hypot(std::hypot(pose.turn[0], pose.turn[1], pose.turn[2]), pose.turn[3]);
  require(
      is_finite(pose.position) && size > 1e-3 && size <= largest,
      fmt::format("body {} is at no place: its position has to be from -1e6 to 1e6 m, and its turn not zero", body));
  parts_->bodies[body].place(pose);
}

void EngineStage::listen(std::span<const Triple> ears) {
  require(ears.size() == channels(), fmt::format("the stage has {} ears, not {}", channels(), ears.size()));
  parts_->ears = vectors_of(ears);
}

void EngineStage::contact(const ContactEvent& event) {
  parts_->check(event);
  parts_->events.push_back(event);
}

void EngineStage::step(double duration) {
  require(duration >= shortest_step && duration <= 1.0, "a step takes 1e-5 to 1 s");
  Parts& parts = *parts_;
  const bool is_heard = parts.keep_time(duration);
  if (!is_heard) {
    parts.left_out += std::exchange(parts.events, {}).size();
  }
  const std::vector<ContactForce> forces = parts.sounds.step(parts.events, parts.start, duration);
  parts.events.clear();
  if (is_heard) {
    parts.send(forces, std::llround(duration * parts.options.rate));
  }
  parts.note_choices();
}

StageReport EngineStage::report() {
  StageReport& report = parts_->last_report;
  parts_->note_choices();
  report.strokes = parts_->sounds.strokes();
  report.impacts = parts_->sounds.impacts();
  report.left_out = parts_->sounds.left_out() + parts_->left_out;
  return report;
}

void EngineStage::render(std::span<double> sound) {
  require(sound.size() % channels() == 0, "a block of sound has to have whole frames of all channels");
  std::ranges::fill(sound, 0.0);
  parts_->voices.render(sound, 0);
  parts_->rendered.fetch_add(static_cast<std::int64_t>(sound.size() / channels()), std::memory_order_release);
}

void EngineStage::render(std::span<float> sound, double full_scale) {
  require(full_scale > 0.0, "the full scale has to be above 0 Pa");
  const std::size_t longest = parts_->piece.size() / channels() * channels();
  while (!sound.empty()) {
    const std::span<double> piece = std::span(parts_->piece).first(std::min(longest, sound.size()));
    render(piece);
    std::ranges::transform(piece, sound.begin(), [&](double pa) { return static_cast<float>(pa / full_scale); });
    sound = sound.subspan(piece.size());
  }
}

}  // namespace idiophone::engines
