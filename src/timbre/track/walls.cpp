// The objects of a soundtrack as walls.

#include <algorithm>

#include "idiophone/timbre/nodes/limp_wall.hpp"
#include "object_sounds.hpp"

namespace idiophone::timbre {

Walls::Walls(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects,
             std::vector<std::size_t> sounds)
    : objects_(objects),
      sounds_(std::move(sounds)),
      impedance_(acoustics.radiation.air.impedance()),
      rate_(acoustics.audio.rate) {
  for (const TrackObject& object : objects) {
    shapes_.push_back(object.triangles.empty() ? ObjectShape::box(object.size) : ObjectShape(object.triangles));
  }
}

void Walls::place(std::int64_t sample) {
  for (std::size_t o = 0; o < count(); ++o) {
    const TrackObject::Pose pose = objects_[o].pose(static_cast<double>(sample) / rate_);
    shapes_[o].place(pose.centre, pose.axes);
  }
}

bool Walls::is_own(std::size_t emitter, std::size_t object) const {
  return std::ranges::find(objects_[object].own, sounds_[emitter], &SoundHandle::index) != objects_[object].own.end();
}

double Walls::corner(std::size_t object, double cosine) const {
  constexpr double grazing = 1e-3;  // a smaller cosine
  const std::optional<double>& density = objects_[object].surface_density;
  return density ? LimpWall::corner(*density, std::max(cosine, grazing), impedance_) / rate_ : 0.0;
}

int Walls::interval() const {
  constexpr int finds_per_second = 100;
  return std::max(1, rate_ / finds_per_second);
}

}  // namespace idiophone::timbre
