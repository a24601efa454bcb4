#include "idiophone/instruments/engines/engine_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/touching/contact_sounds.hpp"
#include "idiophone/instruments/touching/vectors.hpp"
#include "stage_bodies.hpp"
#include "stage_checks.hpp"
#include "stage_proxies.hpp"

namespace idiophone::engines {

using touching::ContactForce, touching::ContactSounds, touching::vector_of;

namespace {

constexpr double longest_pause = 0.25;  // s, of the audio thread, after which contacts are left out
constexpr double shortest_step = 1e-5;  // s
// Of the budget. The rest is for blows between two choices, and for caches that many bodies share.
constexpr double share_to_spend = 0.85;
constexpr std::size_t most_claims = 4096;  // of bodies with maps, and of proxies, to a budget

std::shared_ptr<voices::SharedBudget> shared_budget(double budget) {
  return std::isfinite(budget) ? std::make_shared<voices::SharedBudget>(most_claims, most_claims) : nullptr;
}

score::Tuning score_tuning(const Tuning& tuning) {
  return {.size = tuning.size, .friction = tuning.friction, .tension = tuning.tension};
}

std::vector<Vector3> vectors_of(std::span<const Triple> ears) {
  check_ears(ears);
  std::vector<Vector3> vectors;
  std::ranges::transform(ears, std::back_inserter(vectors), vector_of);
  return vectors;
}

std::vector<double> masses_of(const std::vector<SharedMap>& bodies) {
  std::vector<double> masses;
  std::ranges::transform(bodies, std::back_inserter(masses), [](const SharedMap& map) { return map->mass; });
  return masses;
}

}  // namespace

class EngineStage::Parts {
 public:
  Parts(StageOptions stage_options, const std::vector<SharedMap>& maps, std::vector<Surface> surfaces)
      : options(checked(std::move(stage_options))),
        channels(options.ears.size()),
        surface_count(surfaces.size()),
        shared(shared_budget(options.budget)),
        bodies(checked(maps), vectors_of(options.ears), options, share_to_spend * options.budget, shared),
        proxies(vectors_of(options.ears), options, share_to_spend * options.budget, shared),
        sounds(checked(std::move(surfaces)), masses_of(maps), options.rate,
               std::min(options.most_strokes, bodies.most_strokes()), options.seed) {}

  /// Numbers that bodies have or had.
  [[nodiscard]] std::size_t size() const { return std::max(bodies.size(), proxies.size()); }

  /// The lowest.
  [[nodiscard]] std::size_t free_number() const {
    std::size_t number = 0;
    while (!bodies.is_free(number) || proxies.has(number)) {
      ++number;
    }
    return number;
  }

  void require_body(std::size_t body) const {
    const bool is_there = bodies.has(body) || proxies.has(body);
    if (!is_there || std::ranges::find(leaving, body) != leaving.end()) {
      throw std::runtime_error(fmt::format("there is no body {}", body));
    }
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

  /// The bodies that were removed before the step leave when its contacts have struck: what they rested on, or what
  /// rested on them, feels their load until then.
  void let_leave() {
    for (const std::size_t body : std::exchange(leaving, {})) {
      sounds.leave(body);
      proxies.has(body) ? proxies.remove(body) : bodies.remove(body);
    }
  }

  void tune() {
    for (const auto& [body, tuning] : std::exchange(tunings, {})) {
      proxies.has(body) ? proxies.tune(body, tuning, start) : bodies.tune(body, tuning, start);
    }
  }

  /// What was chosen to be heard since the last call; nothing without a budget.
  void note_choices() {
    for (const voices::MapChoice& choice : bodies.voices().take_choices()) {
      last_report.sounding = choice.sounding;
      last_report.modes = choice.modes;
      last_report.heard = choice.heard;
      last_report.cost = choice.cost;
      last_report.loss = choice.left_out;
    }
  }

  StageOptions options;
  const std::size_t channels;
  std::size_t surface_count;
  std::shared_ptr<voices::SharedBudget> shared;
  StageBodies bodies;
  StageProxies proxies;
  ContactSounds sounds;
  std::vector<ContactEvent> events;                            // of the step that follows
  std::vector<std::size_t> leaving;                            // bodies that were removed since the last step
  std::vector<std::pair<std::size_t, score::Tuning>> tunings;  // of bodies, since the last step
  double clock = 0.0;                                          // audio sample at which the next step begins
  std::int64_t start = 0;                                      // of the present step
  double pause = 0.0;                                          // since the audio thread rendered last, s
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

std::size_t EngineStage::add(const SharedMap& map) {
  require(map != nullptr, "a body has no map");
  const std::size_t body = parts_->free_number();
  parts_->bodies.add(body, map);
  parts_->sounds.join(body, map->mass);
  return body;
}

std::size_t EngineStage::add(const SharedProxy& proxy) {
  require(proxy != nullptr, "a body has no proxy");
  const std::size_t body = parts_->free_number();
  const std::int64_t rendered = parts_->rendered.load(std::memory_order_acquire);
  parts_->proxies.add(body, *proxy, std::max<std::int64_t>(rendered, std::llround(parts_->clock)));
  parts_->sounds.join(body, facts_of(proxy).mass);
  return body;
}

void EngineStage::remove(std::size_t body) {
  parts_->require_body(body);
  parts_->leaving.push_back(body);
}

void EngineStage::place(std::size_t body, const Pose& pose) {
  check_pose(body, pose, parts_->size());
  parts_->require_body(body);
  parts_->proxies.has(body) ? parts_->proxies.place(body, pose) : parts_->bodies.place(body, pose);
}

void EngineStage::tune(std::size_t body, const Tuning& tuning) {
  check_tuning(tuning);
  parts_->require_body(body);
  const score::Tuning wanted = score_tuning(tuning);
  parts_->proxies.has(body) ? parts_->proxies.require_tunable(body, wanted)
                            : parts_->bodies.require_tunable(body, wanted);
  parts_->tunings.emplace_back(body, wanted);
}

void EngineStage::listen(std::span<const Triple> ears) {
  require(ears.size() == channels(), fmt::format("the stage has {} ears, not {}", channels(), ears.size()));
  parts_->bodies.listen(vectors_of(ears));
  parts_->proxies.listen(vectors_of(ears));
}

void EngineStage::contact(const ContactEvent& event) {
  check_event(event, parts_->size(), parts_->surface_count);
  for (const std::int32_t body : event.bodies) {
    if (body != ContactEvent::nobody) {
      parts_->require_body(static_cast<std::size_t>(body));
    }
  }
  parts_->events.push_back(event);
}

void EngineStage::step(double duration) {
  require(duration >= shortest_step && duration <= longest_step, "a step takes 1e-5 to 1 s");
  Parts& parts = *parts_;
  const bool is_heard = parts.keep_time(duration);
  if (!is_heard) {
    parts.left_out += std::exchange(parts.events, {}).size();
  }
  const std::vector<ContactForce> forces = parts.sounds.step(parts.events, parts.start, duration);
  parts.events.clear();
  parts.tune();
  if (is_heard) {
    const std::int64_t length = std::llround(duration * parts.options.rate);
    parts.bodies.send(forces, parts.start, length);
    parts.proxies.send(forces, parts.start, length);
  }
  parts.let_leave();
  parts.proxies.compute_until(std::llround(parts.clock));
  parts.note_choices();
}

StageReport EngineStage::report() {
  StageReport& report = parts_->last_report;
  parts_->note_choices();
  report.strokes = parts_->sounds.strokes();
  report.impacts = parts_->sounds.impacts();
  report.left_out = parts_->sounds.left_out() + parts_->bodies.left_out() + parts_->left_out;
  parts_->proxies.note(report);
  return report;
}

void EngineStage::render(std::span<double> sound) {
  require(sound.size() % channels() == 0, "a block of sound has to have whole frames of all channels");
  std::ranges::fill(sound, 0.0);
  parts_->bodies.voices().render(sound, 0);
  parts_->proxies.render(parts_->rendered.load(std::memory_order_relaxed), sound);
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
