#include "late_sound.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "diffuse_field.hpp"

namespace idiophone::timbre {

namespace {

/// The receivers of a listener's late sound. A head is two points as far apart as its ears (O'Brien 2001, section 4).
std::vector<scene::Receiver> receivers_of(const scene::Listener& listener) {
  std::vector<scene::Receiver> receivers = listener.receivers;
  if (listener.head) {
    constexpr double between_ears = 0.2;  // m
    const Vector3 left = listener.head->up.cross(listener.head->look);
    receivers[0].position += 0.5 * between_ears * left;
    receivers[1].position -= 0.5 * between_ears * left;
  }
  return receivers;
}

/// A microphone in the middle of a listener.
scene::Listener middle_of(const scene::Listener& listener) {
  scene::Listener middle{.name = listener.name, .receivers = {}, .path = listener.path, .head = {}, .where = {}};
  scene::Receiver& receiver = middle.receivers.emplace_back();
  for (const scene::Receiver& one : listener.receivers) {
    receiver.position += one.position / static_cast<double>(listener.receivers.size());
  }
  return middle;
}

}  // namespace

LateSound::LateSound(const scene::Acoustics& acoustics, const timbre::Reverberation& reverberation, PointSources model,
                     std::size_t sources, std::int64_t samples)
    : acoustics_(acoustics), reverberation_(reverberation), plain_(static_cast<std::size_t>(samples)) {
  if (acoustics.listeners.empty()) {
    return;
  }
  middles_.audio = acoustics.audio;
  middles_.radiation.air.speed = acoustics.radiation.air.speed;
  std::ranges::transform(acoustics.listeners, std::back_inserter(middles_.listeners), middle_of);
  ears_.emplace(middles_, sources, std::move(model), samples);
}

void LateSound::hear(std::int64_t sample, const surface::Emission& emission) {
  ears_->hear(sample, emission);
}

void LateSound::hear_plain(std::int64_t sample, double sound) {
  plain_[static_cast<std::size_t>(sample)] += sound;
}

void LateSound::add_to(std::vector<TrackSound>& heard) {
  for (std::size_t l = 0; l < heard.size(); ++l) {
    const auto receivers =
        acoustics_.listeners.empty() ? std::vector<scene::Receiver>(1) : receivers_of(acoustics_.listeners[l]);
    DiffuseField field(receivers, reverberation_.decay, acoustics_.radiation.air.speed, acoustics_.audio.rate);
    std::vector<double> late(receivers.size());
    for (std::size_t i = 0; i < plain_.size(); ++i) {
      field.step(plain_[i] + (ears_ ? ears_->sounds()[l][i] : 0.0), late);
      for (std::size_t r = 0; r < late.size(); ++r) {
        heard[l].samples[i * late.size() + r] += reverberation_.level * late[r];
      }
    }
  }
}

}  // namespace idiophone::timbre
