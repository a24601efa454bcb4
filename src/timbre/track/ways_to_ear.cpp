// The ways of sounds past objects to one microphone or head.

#include <algorithm>
#include <cmath>

#include "idiophone/air/propagation/image_paths.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "object_sounds.hpp"

namespace idiophone::timbre {

namespace {

Vector3 vector_at(const std::array<std::vector<double>, 3>& components, std::size_t i) {
  return {components[0][i], components[1][i], components[2][i]};
}

void put(surface::Emission& emission, std::size_t emitter, double pressure, const Vector3& centre,
         const Vector3& normal) {
  emission.pressure[emitter] = pressure;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    emission.centre[axis][emitter] = centre[static_cast<Eigen::Index>(axis)];
    emission.normal[axis][emitter] = normal[static_cast<Eigen::Index>(axis)];
  }
}

/// Where a way that may be reflected first meets an object.
std::optional<ObjectShape::Meeting> first_crossing(const ObjectShape& shape, const std::vector<Vector3>& way) {
  std::optional<ObjectShape::Meeting> crossing;
  for (std::size_t leg = 1; leg < way.size() && !crossing; ++leg) {
    crossing = shape.crossing(way[leg - 1], way[leg]);
  }
  return crossing;
}

}  // namespace

WaysToEar::WaysToEar(const scene::Acoustics& acoustics, scene::Listener listener, const Walls& walls,
                     std::vector<PointSources::Pattern> patterns, std::int64_t samples)
    : walls_(walls), mirrors_(walls.emitters() * walls.count()) {
  scene_.audio = acoustics.audio;
  scene_.radiation.air = acoustics.radiation.air;
  scene_.radiation.floor = acoustics.radiation.floor;
  scene_.radiation.room = acoustics.radiation.room;
  if (scene_.radiation.room) {
    scene_.radiation.room->images = scene_.radiation.room->order();
    scene_.radiation.room->late = false;
  }
  scene_.listeners = {std::move(listener)};
  const std::size_t paths = 1 + propagation::image_paths(scene_.radiation).size();
  shades_.resize(paths * mirrors_.size());
  for (std::size_t emitter = 0; emitter < walls.emitters(); ++emitter) {
    for (std::size_t o = 0; o < walls.count(); ++o) {
      for (std::size_t path = 0; path < paths; ++path) {
        shades_[(path * walls.emitters() + emitter) * walls.count() + o].wall.tune(walls.corner(o, 1.0));
      }
      mirrors_[emitter * walls.count() + o].shade.wall.tune(walls.corner(o, 1.0));
      patterns.push_back(PointSources::Pattern(patterns[emitter]));
    }
  }
  emissions_.resize(paths);
  for (surface::Emission& emission : emissions_) {
    emission.resize(padded(patterns.size()));
  }
  heard_.emplace(scene_, emissions_.front().pressure.size(),
                 PointSources(PointSources::Fall::with_distance, std::move(patterns)), samples);
}

void WaysToEar::hear(std::int64_t sample, const surface::Emission& emission) {
  const int interval = walls_.interval();
  if (sample % interval == 0) {
    find_ways(sample, emission);
  }
  const double part = static_cast<double>(sample % interval) / interval;
  for (std::size_t emitter = 0; emitter < walls_.emitters(); ++emitter) {
    for (std::size_t path = 0; path < emissions_.size(); ++path) {
      emit_behind(path, emitter, part, emission);
    }
    emit_mirrored(emitter, part, emission);
  }
  heard_->hear(sample, [this](std::size_t path) -> const surface::Emission& { return emissions_[path]; });
}

void WaysToEar::find_ways(std::int64_t sample, const surface::Emission& emission) {
  const std::vector<Vector3> ends = heard_->path_ends(sample);
  for (std::size_t emitter = 0; emitter < walls_.emitters(); ++emitter) {
    const Vector3 source = vector_at(emission.centre, emitter);
    for (std::size_t path = 0; path < ends.size(); ++path) {
      find_shades(path, emitter, propagation::reflected_way(scene_.radiation, source, ends[path]));
    }
    find_mirrors(emitter, source, ends.front());
  }
  if (sample == 0) {  // as if it had been so for ever
    for (Shade& shade : shades_) {
      shade.part.from = shade.part.to;
    }
    for (Mirror& mirror : mirrors_) {
      mirror.shade.part.from = mirror.shade.part.to;
    }
  }
}

void WaysToEar::find_shades(std::size_t path, std::size_t emitter, const std::vector<Vector3>& way) {
  for (std::size_t o = 0; o < walls_.count(); ++o) {
    std::optional<ObjectShape::Meeting> crossing;
    if (!walls_.is_own(emitter, o)) {
      crossing = first_crossing(walls_.shape(o), way);
    }
    shades_[(path * walls_.emitters() + emitter) * walls_.count() + o].aim(
        crossing.has_value(), crossing ? walls_.corner(o, crossing->cosine) : 0.0);
  }
}

void WaysToEar::find_mirrors(std::size_t emitter, const Vector3& source, const Vector3& ear) {
  const auto is_free = [&](const Vector3& from, const Vector3& to, std::size_t but) {
    for (std::size_t o = 0; o < walls_.count(); ++o) {
      if (o != but && walls_.shape(o).crossing(from, to)) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t o = 0; o < walls_.count(); ++o) {
    std::optional<ObjectShape::Meeting> reflection;
    if (!walls_.is_own(emitter, o)) {
      reflection = walls_.shape(o).reflection(source, ear);
    }
    if (reflection && !(is_free(source, reflection->point, o) && is_free(reflection->point, ear, o))) {
      reflection.reset();
    }
    Mirror& mirror = mirrors_[emitter * walls_.count() + o];
    const bool is_silent = mirror.shade.part.to == 0.0;
    if (reflection && is_silent) {
      mirror.face = reflection->face;
    }
    const bool goes_on = reflection && mirror.face == reflection->face;  // another face waits until this one is silent
    mirror.shade.aim(goes_on, goes_on ? walls_.corner(o, reflection->cosine) : 0.0);
  }
}

void WaysToEar::emit_behind(std::size_t path, std::size_t emitter, double part, const surface::Emission& emission) {
  const double sound = emission.pressure[emitter];
  double behind = sound;
  for (std::size_t o = 0; o < walls_.count(); ++o) {
    behind = shades_[(path * walls_.emitters() + emitter) * walls_.count() + o].step(behind, part);
  }
  put(emissions_[path], emitter, behind - sound, vector_at(emission.centre, emitter),
      vector_at(emission.normal, emitter));
}

void WaysToEar::emit_mirrored(std::size_t emitter, double part, const surface::Emission& emission) {
  const double sound = emission.pressure[emitter];
  for (std::size_t o = 0; o < walls_.count(); ++o) {
    Mirror& mirror = mirrors_[emitter * walls_.count() + o];
    const double share = std::sqrt(1.0 - walls_.absorption(o));
    const double reflected = share * (sound - mirror.shade.wall.step(sound)) * mirror.shade.part.at(part);
    if (mirror.face) {
      const ObjectShape& shape = walls_.shape(o);
      put(emissions_.front(), walls_.emitters() + emitter * walls_.count() + o, reflected,
          shape.mirrored(vector_at(emission.centre, emitter), *mirror.face),
          shape.mirrored_direction(vector_at(emission.normal, emitter), *mirror.face));
    }
  }
}

}  // namespace idiophone::timbre
