#include "object_sounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::timbre {

namespace {

constexpr int finds_per_second = 100;

Vector3 vector_at(const std::array<std::vector<double>, 3>& components, std::size_t i) {
  return {components[0][i], components[1][i], components[2][i]};
}

}  // namespace

WaysToEar::WaysToEar(const scene::Acoustics& acoustics, scene::Listener listener,
                     const std::vector<TrackObject>& objects, std::vector<PointSources::Pattern> patterns,
                     std::int64_t samples)
    : objects_(objects),
      sources_(patterns.size()),
      own_(sources_ * objects.size()),
      shades_(sources_ * objects.size()),
      mirrors_(sources_ * objects.size()) {
  scene_.audio = acoustics.audio;
  scene_.radiation.air = acoustics.radiation.air;
  scene_.listeners = {std::move(listener)};
  for (std::size_t o = 0; o < objects.size(); ++o) {
    for (const SoundHandle& sound : objects[o].own) {
      own_[sound.index * objects.size() + o] = 1;
    }
  }
  for (std::size_t s = 0; s < sources_; ++s) {
    for (std::size_t o = 0; o < objects.size(); ++o) {
      shades_[s * objects.size() + o].wall.tune(corner(o, 1.0));
      mirrors_[s * objects.size() + o].wall.tune(corner(o, 1.0));
      patterns.push_back(PointSources::Pattern(patterns[s]));
    }
  }
  emission_.resize(padded(patterns.size()));
  heard_.emplace(scene_, emission_.pressure.size(),
                 PointSources(PointSources::Fall::with_distance, std::move(patterns)), samples);
}

void WaysToEar::hear(std::int64_t sample, const surface::Emission& emission, const std::vector<Box>& boxes) {
  const int interval = std::max(1, scene_.audio.rate / finds_per_second);
  if (sample % interval == 0) {
    find_ways(sample, emission, boxes);
  }
  const double part = static_cast<double>(sample % interval) / interval;
  for (std::size_t s = 0; s < sources_; ++s) {
    emit(s, part, emission, boxes);
  }
  heard_->hear(sample, emission_);
}

void WaysToEar::find_ways(std::int64_t sample, const surface::Emission& emission, const std::vector<Box>& boxes) {
  const Vector3 ear = heard_->position(sample);
  const auto is_free = [&](const Vector3& from, const Vector3& to, std::size_t but) {
    for (std::size_t o = 0; o < objects_.size(); ++o) {
      if (o != but && boxes[o].crossing(from, to)) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t s = 0; s < sources_; ++s) {
    const Vector3 source = vector_at(emission.centre, s);
    for (std::size_t o = 0; o < objects_.size(); ++o) {
      std::optional<Box::Meeting> crossing, reflection;
      if (own_[s * objects_.size() + o] == 0) {
        crossing = boxes[o].crossing(source, ear);
        reflection = boxes[o].reflection(source, ear);
      }
      if (reflection && !(is_free(source, reflection->point, o) && is_free(reflection->point, ear, o))) {
        reflection.reset();
      }
      Shade& shade = shades_[s * objects_.size() + o];
      Mirror& mirror = mirrors_[s * objects_.size() + o];
      find_shade(shade, o, crossing);
      find_mirror(mirror, o, reflection);
      if (sample == 0) {  // as if it had been so for ever
        shade.part.from = shade.part.to;
        mirror.part.from = mirror.part.to;
      }
    }
  }
}

void WaysToEar::find_shade(Shade& shade, std::size_t object, const std::optional<Box::Meeting>& crossing) const {
  shade.part = {.from = shade.part.to, .to = crossing ? 1.0 : 0.0};
  if (crossing) {
    shade.wall.tune(corner(object, crossing->cosine));
  }
}

void WaysToEar::find_mirror(Mirror& mirror, std::size_t object, const std::optional<Box::Meeting>& reflection) const {
  const bool is_silent = mirror.part.to == 0.0;
  if (reflection && is_silent) {
    mirror.face = reflection->face;
  }
  const bool goes_on = reflection && mirror.face == reflection->face;  // another face waits until this one is silent
  mirror.part = {.from = mirror.part.to, .to = goes_on ? 1.0 : 0.0};
  if (goes_on) {
    mirror.wall.tune(corner(object, reflection->cosine));
  }
}

double WaysToEar::corner(std::size_t object, double cosine) const {
  const std::optional<double>& density = objects_[object].surface_density;
  constexpr double grazing = 1e-3;  // a smaller cosine
  return density ? LimpWall::corner(*density, std::max(cosine, grazing), scene_.radiation.air.impedance()) /
                       scene_.audio.rate
                 : 0.0;
}

void WaysToEar::emit(std::size_t source, double part, const surface::Emission& emission,
                     const std::vector<Box>& boxes) {
  const double sound = emission.pressure[source];
  const Vector3 centre = vector_at(emission.centre, source), normal = vector_at(emission.normal, source);
  double behind = sound;
  for (std::size_t o = 0; o < objects_.size(); ++o) {
    Shade& shade = shades_[source * objects_.size() + o];
    behind += shade.part.at(part) * (shade.wall.step(behind) - behind);
    Mirror& mirror = mirrors_[source * objects_.size() + o];
    const std::size_t emitter = sources_ + source * objects_.size() + o;
    const double share = mirror.part.at(part) * std::sqrt(1.0 - objects_[o].absorption);
    const double reflected = share * (sound - mirror.wall.step(sound));
    if (mirror.face) {
      place(emitter, reflected, boxes[o].mirrored(centre, *mirror.face),
            boxes[o].mirrored_direction(normal, *mirror.face));
    }
  }
  place(source, behind - sound, centre, normal);
}

void WaysToEar::place(std::size_t emitter, double pressure, const Vector3& centre, const Vector3& normal) {
  emission_.pressure[emitter] = pressure;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    emission_.centre[axis][emitter] = centre[static_cast<Eigen::Index>(axis)];
    emission_.normal[axis][emitter] = normal[static_cast<Eigen::Index>(axis)];
  }
}

ObjectSounds::ObjectSounds(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects,
                           const std::vector<PointSources::Pattern>& patterns, std::int64_t samples)
    : objects_(objects), rate_(acoustics.audio.rate) {
  const auto add = [&](std::size_t listener, std::size_t channel, scene::Listener one) {
    ears_.emplace_back(acoustics, std::move(one), objects, patterns, samples);
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
  for (const TrackObject& object : objects) {
    boxes_.push_back({.half = 0.5 * object.size});
  }
}

void ObjectSounds::hear(std::int64_t sample, const surface::Emission& emission) {
  for (std::size_t o = 0; o < boxes_.size(); ++o) {
    const TrackObject::Pose pose = objects_[o].pose(static_cast<double>(sample) / rate_);
    boxes_[o].centre = pose.centre;
    boxes_[o].axes = pose.axes;
  }
  for (WaysToEar& ear : ears_) {
    ear.hear(sample, emission, boxes_);
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
