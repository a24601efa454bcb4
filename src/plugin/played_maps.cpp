#include "played_maps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"

namespace idiophone::plugin {

namespace {

constexpr int keys_of_midi = 128;
constexpr int middle_key = 60;      // c'
constexpr double separation = 0.2;  // of the two receivers along x, m; as a stereo listener of a deck

/// Size at which a key strikes a body, times the lengths of its map.
double size_of(const Controls& controls, int key, const sound_maps::SoundMap& map) {
  constexpr double keys_in_octave = 12.0;
  constexpr double pitch_of_a = 440.0, slowest = 50.0;  // Hz; below, bodies move on their supports
  constexpr int key_of_a = 69;
  if (controls.keyboard == Keyboard::scaled) {
    return controls.size * std::exp2((middle_key - key) / keys_in_octave);
  }
  const auto lowest = std::ranges::find_if(map.frequency, [](double frequency) { return frequency > slowest; });
  if (controls.keyboard == Keyboard::bodies || lowest == map.frequency.end()) {
    return controls.size;
  }
  return controls.size * *lowest / (pitch_of_a * std::exp2((key - key_of_a) / keys_in_octave));
}

/// In the box around a body, m.
Vector3 place_in(const sound_maps::SoundMap& map, const Vector3& place) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : map.vertices) {
    box.extend(vertex);
  }
  return box.center() + 0.5 * box.sizes().cwiseProduct(place);
}

score::HammerBlow blow_on(const sound_maps::SoundMap& map, const Controls& controls) {
  const Vector3 at = place_in(map, controls.place);
  return {.at = at, .direction = sound_maps::inward_normal(map, at), .hammer = controls.hammer};
}

scene::Listener stereo_at(const Vector3& middle) {
  scene::Listener listener;
  for (const double side : {-1.0, 1.0}) {
    listener.receivers.push_back(
        {.channel = side < 0.0 ? "left" : "right", .position = middle + side * 0.5 * separation * Vector3::UnitX()});
  }
  return listener;
}

}  // namespace

void HostDriver::ask(std::int64_t /*now*/, std::int64_t /*until*/, std::vector<drivers::Event>& events) {
  std::ranges::move(waiting, std::back_inserter(events));
  waiting.clear();
}

PlayedMaps::PlayedMaps(Maps maps, const Controls& controls, int rate)
    : maps_(std::move(maps)), controls_(controls), actions_({}, 0, rate, 0) {
  Maps bodies = maps_;
  if (controls.keyboard != Keyboard::bodies && !maps_.empty()) {
    for (int key = lowest_key; key <= highest_key; ++key) {
      keys_.push_back(key);
    }
    bodies.assign(keys_.size(), maps_.front());
  }
  const voices::Audience audience(stereo_at(listener()), rate);
  std::vector<std::unique_ptr<voices::Voice>> all;
  if (!bodies.empty()) {
    all.push_back(std::make_unique<voices::SoundMapVoices>(bodies, audience, rate));
  }
  stage_ = std::make_unique<voices::Stage>(audience, std::move(all), channels, rate);
  auto host = std::make_unique<HostDriver>();
  host_ = host.get();
  drivers_.push_back(std::move(host));
  tune_all(0);
  set_keys();
  attend();
}

const sound_maps::SoundMap& PlayedMaps::map_of(std::size_t body) const {
  return keys_.empty() ? *maps_[body] : *maps_.front();
}

Vector3 PlayedMaps::listener() const {
  return (maps_.empty() ? Vector3(Vector3::Zero()) : maps_.front()->centre) + controls_.listener;
}

/// Bodies as they are in their maps need no event.
void PlayedMaps::tune_all(std::int64_t start) {
  for (std::size_t body = 0; body < stage_->bodies().size(); ++body) {
    const double size = size_of(controls_, keys_.empty() ? middle_key : keys_[body], map_of(body));
    if (start > 0 || size != 1.0 || controls_.friction != 1.0) {
      host_->waiting.push_back(
          {.start = start, .body = body, .action = score::Tuning{.size = size, .friction = controls_.friction}});
    }
  }
}

void PlayedMaps::set_keys() {
  std::vector<score::HammerBlow> blows;
  for (const auto& map : maps_) {
    blows.push_back(blow_on(*map, controls_));
  }
  std::vector<score::NoteAction> actions;
  for (std::size_t body = 0; body < keys_.size(); ++body) {
    actions.push_back({.note = keys_[body], .body = body, .blow = blows.front()});
  }
  if (keys_.empty() && !maps_.empty()) {
    const int count = static_cast<int>(maps_.size());
    for (int key = 0; key < keys_of_midi; ++key) {
      const auto body = static_cast<std::size_t>(((key - middle_key) % count + count) % count);
      actions.push_back({.note = key, .body = body, .blow = blows[body]});
    }
  }
  actions_.set(std::move(actions));
}

void PlayedMaps::change(const Controls& controls, std::int64_t start) {
  const Controls before = std::exchange(controls_, controls);
  if (before.listener != controls.listener) {
    host_->waiting.push_back({.start = start, .action = drivers::ListenerMove{listener()}});
  }
  if (before.size != controls.size || before.friction != controls.friction) {
    tune_all(start);
  }
  set_keys();
}

void PlayedMaps::take(const drivers::MidiMessage& message, std::int64_t start) {
  actions_.take(message, start, host_->waiting);
  attend();
}

void PlayedMaps::attend() {
  stage_->drive(drivers_, stage_->now());
}

}  // namespace idiophone::plugin
