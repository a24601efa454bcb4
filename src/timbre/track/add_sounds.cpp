// The sounds of a sonic scene, from its file and the motion.

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>

#include "idiophone/timbre/track/soundtrack.hpp"
#include "motion_curve.hpp"

namespace idiophone::timbre {

namespace {

Soundtrack::Path path_of(const timbre::SonicSound& sound, const MotionChannels& motion) {
  if (sound.at) {
    return [place = *sound.at](double /*time*/) { return place; };
  }
  if (sound.path) {
    return [path = *sound.path](double time) { return path.at(time).position; };
  }
  if (sound.body.empty()) {
    return {};
  }
  std::array<std::shared_ptr<const Curve>, 3> axes;
  constexpr std::array names = {"x", "y", "z"};
  for (std::size_t a = 0; a < axes.size(); ++a) {
    axes[a] = curve_of({.channel = "motion/" + sound.body + "/centre_of_mass",
                        .column = names[a],
                        .interpolation = timbre::Interpolation::cubic,
                        .where = sound.where},
                       motion);
  }
  return [axes](double time) { return Vector3(axes[0]->at(time), axes[1]->at(time), axes[2]->at(time)); };
}

void bind_event(Bindings& bindings, const timbre::SonicSound& sound, const ContactEvent& event) {
  for (const timbre::NamedVariable& parameter : sound.parameters) {
    if (const auto* variable = std::get_if<timbre::EventVariable>(&parameter.variable)) {
      const bool is_force = variable->quantity == timbre::EventVariable::Quantity::force;
      bindings[parameter.name].value = variable->mapping(is_force ? event.force : event.impulse);
    }
  }
}

}  // namespace

namespace {

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

void add_sound(Soundtrack& track, const timbre::SonicSound& sound, SoundClassHandle sound_class,
               const MotionChannels& motion) {
  const SoundHandle handle = track.instantiate_sound(sound_class, sound.gain, path_of(sound, motion));
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
}

}  // namespace

void add_sounds(Soundtrack& track, const timbre::SonicScene& scene, const MotionChannels& motion) {
  MistakesOfScene mistakes;
  std::vector<std::optional<SoundClassHandle>> classes;
  for (const timbre::SoundClass& sound_class : scene.classes) {
    classes.emplace_back();
    mistakes.collect([&] { classes.back() = track.timbre_tree(sound_class.tree); });
  }
  for (const timbre::SonicSound& sound : scene.sounds) {
    if (const auto sound_class = classes[sound.sound_class]) {
      mistakes.collect([&] { add_sound(track, sound, *sound_class, motion); });
    }
  }
  mistakes.raise();
}

}  // namespace idiophone::timbre
