#include "idiophone/timbre/track/soundtrack.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/timbre/language/graph.hpp"
#include "idiophone/timbre/nodes/random.hpp"
#include "soundtrack_parts.hpp"
#include "track_renderer.hpp"

namespace idiophone::timbre {

std::shared_ptr<const Curve> time_dependent_variable(const timbre::Keyframes& keys) {
  std::vector<double> times, values;
  for (const auto& [time, value] : keys.keys) {
    times.push_back(time);
    values.push_back(value);
  }
  return std::make_shared<const Curve>(std::move(times), std::move(values), keys.interpolation);
}

Soundtrack::Soundtrack(const scene::Acoustics& acoustics, std::uint64_t seed) : acoustics_(acoustics), seed_(seed) {}

Soundtrack::~Soundtrack() = default;

SoundClassHandle Soundtrack::timbre_tree(const std::filesystem::path& file) {
  classes_.push_back(std::make_unique<const Tree>(read_tree_file(file)));
  return {classes_.size() - 1};
}

SoundHandle Soundtrack::instantiate_sound(SoundClassHandle sound_class, double gain, Path path,
                                          std::optional<Aim> aim) {
  sources_.push_back({.tree = classes_[sound_class.index].get(),
                      .gain = gain,
                      .path = std::move(path),
                      .aim = std::move(aim),
                      .instances = {}});
  return {sources_.size() - 1};
}

void Soundtrack::start_sound(SoundHandle sound, double time, Bindings bindings, double duration) {
  Source& source = sources_[sound.index];
  static_cast<void>(Graph(*source.tree, bindings, sound_start(sound.index, source.instances.size(), time)));
  Instance instance{.start = std::llround(time * acoustics_.audio.rate), .bindings = std::move(bindings)};
  if (std::isfinite(duration)) {
    instance.stop = instance.start + std::llround(duration * acoustics_.audio.rate);
  }
  source.instances.push_back(std::move(instance));
}

void Soundtrack::stop_sound(SoundHandle sound, double time) {
  const std::int64_t stop = std::llround(time * acoustics_.audio.rate);
  for (Instance& instance : sources_[sound.index].instances) {
    if (instance.start < stop) {
      instance.stop = std::min(instance.stop, stop);
    }
  }
}

SoundStart Soundtrack::sound_start(std::size_t source, std::size_t start, double time) const {
  const std::uint64_t body = joined_seed(seed_, source);
  return {.rate = acoustics_.audio.rate, .start = time, .body_seed = body, .start_seed = joined_seed(body, start)};
}

std::vector<TrackSound> Soundtrack::render(double duration, const std::optional<timbre::Reverberation>& reverberation,
                                           const Progress& progress) const {
  return TrackRenderer(*this, reverberation, std::llround(duration * acoustics_.audio.rate)).render(progress);
}

std::size_t Soundtrack::starts() const {
  std::size_t count = 0;
  for (const Source& source : sources_) {
    count += source.instances.size();
  }
  return count;
}

std::size_t Soundtrack::starts_from(double time) const {
  const std::int64_t sample = std::llround(time * acoustics_.audio.rate);
  std::ptrdiff_t count = 0;
  for (const Source& source : sources_) {
    count += std::ranges::count_if(source.instances,
                                   [sample](const Instance& instance) { return instance.start >= sample; });
  }
  return static_cast<std::size_t>(count);
}

}  // namespace idiophone::timbre
