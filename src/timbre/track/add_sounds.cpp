// The sounds and objects of a sonic scene, from its file and the motion.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "motion_curve.hpp"
#include "places.hpp"

namespace idiophone::timbre {

namespace {

void bind_event(Bindings& bindings, const timbre::SonicSound& sound, const ContactEvent& event) {
  for (const timbre::NamedVariable& parameter : sound.parameters) {
    if (const auto* variable = std::get_if<timbre::EventVariable>(&parameter.variable)) {
      const bool is_force = variable->quantity == timbre::EventVariable::Quantity::force;
      bindings[parameter.name].value = variable->mapping(is_force ? event.force : event.impulse);
    }
  }
}

/// Collects the mistakes of all classes and sounds.
class MistakesOfScene {
 public:
  /// Does one piece of work. Sounds of one class can have the same mistakes, which are said once.
  template <class Work>
  void collect(const Work& work) {
    try {
      work();
    } catch (const deck::DeckError& error) {
      std::istringstream lines(error.what());
      for (std::string line; std::getline(lines, line);) {
        if (std::ranges::find(mistakes_, line, &deck::Mistake::message) == mistakes_.end()) {
          mistakes_.push_back({.where = {}, .message = line});
        }
      }
    }
  }

  /// @throws deck::DeckError if there are any
  void raise() const {
    if (!mistakes_.empty()) {
      throw deck::DeckError(mistakes_);
    }
  }

 private:
  std::vector<deck::Mistake> mistakes_;  // whose messages name their places
};

std::optional<Soundtrack::Aim> aim_of(const timbre::SonicSound& sound, const MotionChannels& motion) {
  if (!sound.directivity) {
    return {};
  }
  return Soundtrack::Aim{.directivity = *sound.directivity,
                         .axis = [turn = turn_of(sound.place, sound.where, motion), axis = sound.directivity->axis](
                                     double time) -> Vector3 { return turn(time) * axis; }};
}

SoundHandle add_sound(Soundtrack& track, const timbre::SonicSound& sound, SoundClassHandle sound_class,
                      const MotionChannels& motion) {
  const SoundHandle handle = track.instantiate_sound(sound_class, sound.gain, path_of(sound.place, sound.where, motion),
                                                     aim_of(sound, motion));
  Bindings bindings = bindings_of(sound.parameters, motion);
  std::vector<double> starts = sound.starts;
  std::ranges::sort(starts);
  for (const double time : starts) {
    track.start_sound(handle, time, bindings, sound.duration);
  }
  if (sound.on_contact) {
    for (const ContactEvent& event : motion.contacts(*sound.on_contact)) {
      bind_event(bindings, sound, event);
      track.start_sound(handle, event.time, bindings, sound.duration);
    }
  }
  return handle;
}

/// The surface of a solid; none of a box.
std::vector<std::array<Vector3, 3>> triangles_of(const timbre::SonicObject& object) {
  constexpr std::size_t most_triangles = 20000;
  std::vector<std::array<Vector3, 3>> triangles;
  if (!object.solid) {
    return triangles;
  }
  scene::Body body = *object.solid;
  body.name = object.name;
  body.element = element::tet4;
  const mesh::Mesh mesh = mesh::read_mesh(body);
  for (const mesh::Triangle& corners : mesh.outer_surface()) {
    triangles.push_back({mesh.nodes[corners[0]], mesh.nodes[corners[1]], mesh.nodes[corners[2]]});
  }
  if (triangles.size() > most_triangles) {
    throw deck::DeckError(body.mesh_where, fmt::format("objects.{}: its surface has {} triangles, more than {}, which "
                                                       "would take long; make it coarser, e.g. with a larger `size`",
                                                       object.name, triangles.size(), most_triangles));
  }
  return triangles;
}

/// @param own  its sounds
void add_object(Soundtrack& track, const timbre::SonicObject& object, std::vector<SoundHandle> own,
                const MotionChannels& motion) {
  const double angle = object.rotation.norm();
  const Eigen::Matrix3d rotation =
      angle > 0.0 ? Eigen::AngleAxisd(angle, object.rotation / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  track.add_object(
      {.size = object.size,
       .triangles = triangles_of(object),
       .surface_density = object.surface_density,
       .absorption = object.absorption,
       .pose =
           [path = path_of(object.place, object.where, motion), turn = turn_of(object.place, object.where, motion),
            rotation](double time) { return TrackObject::Pose{.centre = path(time), .axes = turn(time) * rotation}; },
       .own = std::move(own)});
}

}  // namespace

void add_sounds(Soundtrack& track, const timbre::SonicScene& scene, const MotionChannels& motion) {
  MistakesOfScene mistakes;
  std::vector<std::optional<SoundClassHandle>> classes;
  for (const timbre::SoundClass& sound_class : scene.classes) {
    classes.emplace_back();
    mistakes.collect([&] { classes.back() = track.timbre_tree(sound_class.tree); });
  }
  std::multimap<std::string, SoundHandle> of_bodies;
  for (const timbre::SonicSound& sound : scene.sounds) {
    if (const auto sound_class = classes[sound.sound_class]) {
      mistakes.collect([&] { of_bodies.emplace(sound.place.body, add_sound(track, sound, *sound_class, motion)); });
    }
  }
  for (const timbre::SonicObject& object : scene.objects) {
    std::vector<SoundHandle> own;
    const auto [first, last] = of_bodies.equal_range(object.place.body);
    std::transform(first, object.place.body.empty() ? first : last, std::back_inserter(own),
                   [](const auto& sound) { return sound.second; });
    mistakes.collect([&] { add_object(track, object, std::move(own), motion); });
  }
  mistakes.raise();
}

}  // namespace idiophone::timbre
