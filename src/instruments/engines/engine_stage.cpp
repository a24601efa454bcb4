#include "idiophone/instruments/engines/engine_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "stage_checks.hpp"
#include "stage_parts.hpp"

namespace idiophone::engines {

namespace {

constexpr double shortest_step = 1e-5;  // s

score::Tuning score_tuning(const Tuning& tuning) {
  return {.size = tuning.size, .friction = tuning.friction, .tension = tuning.tension};
}

}  // namespace

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
  parts_->bodies.listen(checked(ears));
  parts_->proxies.listen(checked(ears));
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
  const std::vector<touching::ContactForce> forces = parts.sounds.step(parts.events, parts.start, duration);
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
