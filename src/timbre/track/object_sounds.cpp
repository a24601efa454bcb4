#include "object_sounds.hpp"

#include <algorithm>

namespace idiophone::timbre {

ObjectSounds::ObjectSounds(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects,
                           std::vector<std::size_t> sounds, const std::vector<PointSources::Pattern>& patterns,
                           std::int64_t samples)
    : walls_(acoustics, objects, std::move(sounds)), enclosures_(walls_.emitters() * walls_.count()) {
  const auto add = [&](std::size_t listener, std::size_t channel, scene::Listener one) {
    ears_.emplace_back(acoustics, std::move(one), walls_, patterns, samples);
    listeners_.push_back(listener);
    channels_.push_back(channel);
  };
  for (std::size_t l = 0; l < acoustics.listeners.size(); ++l) {
    const scene::Listener& listener = acoustics.listeners[l];
    if (listener.head) {
      add(l, 0, listener);
      continue;
    }
    for (std::size_t r = 0; r < listener.receivers.size(); ++r) {
      scene::Listener one = listener;
      one.receivers = {listener.receivers[r]};
      add(l, r, std::move(one));
    }
  }
}

void ObjectSounds::hear(std::int64_t sample, const surface::Emission& emission) {
  walls_.place(sample);
  for (WaysToEar& ear : ears_) {
    ear.hear(sample, emission);
  }
  enclose(sample, emission);
}

void ObjectSounds::enclose(std::int64_t sample, const surface::Emission& emission) {
  constexpr double diffuse = 2.0 / 3.0;  // mean cosine of what a diffuse field brings to a wall
  const int interval = walls_.interval();
  late_emission_ = emission;
  for (std::size_t emitter = 0; emitter < walls_.emitters(); ++emitter) {
    const Vector3 place(emission.centre[0][emitter], emission.centre[1][emitter], emission.centre[2][emitter]);
    for (std::size_t o = 0; o < walls_.count(); ++o) {
      Shade& enclosure = enclosures_[emitter * walls_.count() + o];
      if (sample % interval == 0) {
        enclosure.aim(!walls_.is_own(emitter, o) && walls_.shape(o).contains(place), walls_.corner(o, diffuse));
      }
      if (sample == 0) {
        enclosure.part.from = enclosure.part.to;
      }
      double& pressure = late_emission_.pressure[emitter];
      pressure = enclosure.step(pressure, static_cast<double>(sample % interval) / interval);
    }
  }
}

void ObjectSounds::add_to(std::vector<TrackSound>& heard) const {
  for (std::size_t e = 0; e < ears_.size(); ++e) {
    TrackSound& listener = heard[listeners_[e]];
    const std::vector<double>& sound = ears_[e].sound();
    const std::size_t frames = listener.samples.size() / listener.channels, width = sound.size() / frames;
    for (std::size_t i = 0; i < frames; ++i) {
      for (std::size_t c = 0; c < width; ++c) {
        listener.samples[i * listener.channels + channels_[e] + c] += sound[i * width + c];
      }
    }
  }
}

}  // namespace idiophone::timbre
