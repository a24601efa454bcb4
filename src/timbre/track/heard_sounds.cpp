#include "heard_sounds.hpp"

#include "idiophone/air/receivers/spreading.hpp"

namespace idiophone::timbre {

namespace {

constexpr std::int64_t samples_at_once = 1024;

}  // namespace

HeardSounds::HeardSounds(const scene::Acoustics& acoustics, std::size_t emitters, PointSources model,
                         std::int64_t samples)
    : ears_(acoustics, 0, emitters, std::make_unique<PointSources>(std::move(model)),
            receivers::Spreading::band_limited()),
      samples_(samples),
      sounds_(acoustics.listeners.size()) {}

void HeardSounds::hear(std::int64_t sample, const surface::Emission& emission) {
  ears_.hear(sample, emission, nullptr);
  take(sample);
}

void HeardSounds::hear(std::int64_t sample, const propagation::Ears::EmissionOn& emission_on) {
  ears_.hear(sample, emission_on);
  take(sample);
}

void HeardSounds::take(std::int64_t sample) {
  const bool is_last = sample + 1 == samples_;
  if (!is_last && (sample + 1) % samples_at_once != 0) {
    return;
  }
  const std::int64_t final_before = is_last ? samples_ : ears_.final_before(sample);
  if (final_before <= taken_) {
    return;
  }
  const auto sounds = ears_.take(static_cast<std::size_t>(final_before - taken_), MPI_COMM_SELF);
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    sounds_[l].insert(sounds_[l].end(), sounds[l].begin(), sounds[l].end());
  }
  taken_ = final_before;
}

}  // namespace idiophone::timbre
