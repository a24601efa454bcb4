#include "sound_message.hpp"

#include <array>

namespace idiophone::harmonic {

namespace {

constexpr std::array facts_of_sounds = {
    &RadiatedSound::mean_square_velocity, &RadiatedSound::power,           &RadiatedSound::level_error,
    &RadiatedSound::solved_vertices,      &RadiatedSound::efficiency,      &RadiatedSound::loss_factor,
    &RadiatedSound::directivity_index,    &RadiatedSound::kirchhoff_error, &RadiatedSound::kirchhoff_worst,
    &RadiatedSound::rayleigh_error,       &RadiatedSound::rayleigh_worst,  &RadiatedSound::waves_error,
    &RadiatedSound::waves_worst};

}  // namespace

void pack(const RadiatedSound& sound, std::vector<Complex>& packed) {
  for (const auto fact : facts_of_sounds) {
    packed.emplace_back(sound.*fact);
  }
  for (const auto* field : {&sound.surface_pressure, &sound.listener_pressure, &sound.far_field}) {
    packed.insert(packed.end(), field->begin(), field->end());
  }
}

std::span<const Complex> unpack(std::span<const Complex> packed, const Radiation& facts, RadiatedSound& sound) {
  std::size_t place = 0;
  for (const auto fact : facts_of_sounds) {
    sound.*fact = packed[place++].real();
  }
  const auto take = [&](std::vector<Complex>& field, std::size_t count) {
    const auto values = packed.subspan(place, count);
    field.assign(values.begin(), values.end());
    place += count;
  };
  take(sound.surface_pressure, facts.vertices.size());
  take(sound.listener_pressure, facts.listener_positions.size());
  take(sound.far_field, facts.directions.size());
  return packed.subspan(place);
}

}  // namespace idiophone::harmonic
