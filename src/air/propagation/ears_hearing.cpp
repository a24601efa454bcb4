// What the ears hear of an emission, along all paths.

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "idiophone/air/propagation/ears.hpp"

namespace idiophone::propagation {

void Ears::hear(std::int64_t sample, const surface::Emission& emission, const LineOfSight* sight,
                std::span<const std::optional<LocalSounds>> local_sounds, const surface::Emission* late_emission) {
  const bool in_room = acoustics_.radiation.room.has_value();
  if (in_room) {
    require_inside(sample, emission);
  }
  for (std::size_t e = 0; e < ears_.size(); ++e) {
    const Stand straight = stand(sample, ears_[e]);
    if (!local_sounds.empty() && local_sounds[e]) {
      hear_here(sample, *local_sounds[e], ears_[e].ear);
      if (!in_room) {
        continue;
      }
    } else {
      hear_directly(sample, emission, straight, sight, e);
    }
    hear_reflections(
        sample, [&](std::size_t /*path*/) -> const surface::Emission& { return emission; }, straight, sight, e);
  }
  if (late_) {
    late_->hear(sample, late_emission == nullptr ? emission : *late_emission, *model_);
  }
}

void Ears::hear(std::int64_t sample, const EmissionOn& emission_on) {
  for (std::size_t e = 0; e < ears_.size(); ++e) {
    const Stand straight = stand(sample, ears_[e]);
    hear_directly(sample, emission_on(0), straight, nullptr, e);
    hear_reflections(sample, emission_on, straight, nullptr, e);
  }
}

void Ears::hear_reflections(std::int64_t sample, const EmissionOn& emission_on, const Stand& stand,
                            const LineOfSight* sight, std::size_t ear) {
  for (std::size_t path = 1; path <= images_.size(); ++path) {
    const Stand image = mirrored(stand, images_[path - 1]);
    radiation::find_paths(emission_on(path), image.receiver, air_, paths_);
    hear_along(sample, emission_on(path), image, sight, path, ear);
  }
}

void Ears::hear_directly(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                         const LineOfSight* sight, std::size_t ear) {
  radiation::find_paths(emission, stand.receiver, air_, paths_);
  hear_along(sample, emission, stand, sight, 0, ear);
}

void Ears::hear_along(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                      const LineOfSight* sight, std::size_t path, std::size_t ear) {
  if (sight != nullptr && sight->has(path)) {
    sight->fade(sample, ear, path, paths_);
  }
  radiate(sample, emission, stand, path, ears_[ear].ear);
  if (sight != nullptr) {
    for (const std::int64_t way : sight->ways_heard(ear, path)) {
      hear_around(sample, emission, stand, *sight, path, way, ear);
    }
  }
}

void Ears::hear_around(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                       const LineOfSight& sight, std::size_t path, std::int64_t number, std::size_t ear) {
  const std::size_t count = emission.pressure.size();
  for (auto* values : {&bent_paths_.distance, &bent_paths_.delay, &bent_paths_.cosine, &bent_paths_.gain}) {
    values->assign(count, values == &bent_paths_.distance ? 1.0 : 0.0);
  }
  edge_waves_.assign(count, receivers::no_edges);
  const radiation::ReceiverState& receiver = stand.receiver;
  const bool twice_reflected = path == 0 && DiffractingEdges::copy_of(number) > 0;
  const double reflected = twice_reflected ? std::pow(acoustics_.radiation.floor->reflection, 2) : 1.0;
  for (std::size_t i = 0; i < sight.triangles(); ++i) {
    const BentWay way = sight.bend(sample, ear, path, number, i);
    if (way.gain == 0.0) {
      continue;
    }
    const Vector3 centre(emission.centre[0][i], emission.centre[1][i], emission.centre[2][i]);
    const Vector3 normal(emission.normal[0][i], emission.normal[1][i], emission.normal[2][i]);
    const Vector3 there = way.apexes[0] - centre;
    const Vector3 onwards = receiver.position + paths_.delay[i] / air_.rate * receiver.velocity - way.apexes[1];
    const double distance = std::max(there.norm() + way.between + onwards.norm(), radiation::smallest_distance);
    bent_paths_.distance[i] = distance;
    bent_paths_.delay[i] = distance * air_.samples_per_metre();
    bent_paths_.cosine[i] = there.normalized().dot(normal);
    const double off_axis = onwards.normalized().dot(receiver.axis);
    bent_paths_.gain[i] =
        way.gain * reflected * receiver.gain * (1.0 - receiver.directivity - receiver.directivity * off_axis);
    edge_waves_[i] = way.waves;
  }
  model_->radiate(emission, bent_paths_, arrivals_);
  ears_[ear].ear.hear_around(sample, path, arrivals_, bent_paths_.distance, edge_waves_);
}

void Ears::radiate(std::int64_t sample, const surface::Emission& emission, const Stand& stand, std::size_t path,
                   receivers::Ear& ear) {
  const radiation::ReceiverState& receiver = stand.receiver;
  model_->radiate(emission, paths_, arrivals_);
  ear.hear(sample, path, arrivals_, paths_.distance, [&](std::size_t triangle) -> Vector3 {
    const Vector3 centre(emission.centre[0][triangle], emission.centre[1][triangle], emission.centre[2][triangle]);
    return stand.frame * (centre - receiver.position - paths_.delay[triangle] / air_.rate * receiver.velocity);
  });
}

void Ears::hear_here(std::int64_t sample, const LocalSounds& sounds, receivers::Ear& ear) {
  arrivals_.sound.assign(sounds.begin(), sounds.end());
  arrivals_.change.clear();
  arrivals_.delay.assign(sounds.size(), 0.0);
  ear.hear(sample, 0, arrivals_, arrivals_.delay, [](std::size_t) -> Vector3 {
    throw std::runtime_error("a head cannot be inside the grid of the waves; move it away, or use a microphone");
  });
}

}  // namespace idiophone::propagation
