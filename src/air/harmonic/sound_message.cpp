#include "sound_message.hpp"

#include "sound_facts.hpp"

namespace idiophone::harmonic {

namespace {

/// Calls visit(number) for each number of a sound but those of its fields.
template <class Sound, class Visitor>
void for_each_fact(Sound& sound, Visitor visit) {
  for (const auto& fact : sound_facts) {
    visit(sound.*fact.value);
  }
  for (const auto& fact : waves_facts) {
    visit(sound.*fact.value);
  }
  visit(sound.solution.wave_number);
  visit(sound.solution.power);
}

/// Calls visit(values) for each field of a sound.
template <class Sound, class Visitor>
void for_each_field(Sound& sound, Visitor visit) {
  visit(sound.solution.pressure);
  visit(sound.solution.normal_velocity);
  visit(sound.listener_pressure);
  visit(sound.far_field);
}

}  // namespace

void pack(const RadiatedSound& sound, std::vector<Complex>& packed) {
  for_each_fact(sound, [&](double fact) { packed.emplace_back(fact); });
  packed.emplace_back(static_cast<double>(sound.refinements));
  for_each_field(sound, [&](const std::vector<Complex>& field) {
    packed.emplace_back(static_cast<double>(field.size()));
    packed.insert(packed.end(), field.begin(), field.end());
  });
}

std::span<const Complex> unpack(std::span<const Complex> packed, RadiatedSound& sound) {
  std::size_t place = 0;
  const auto number = [&] { return packed[place++].real(); };
  for_each_fact(sound, [&](double& fact) { fact = number(); });
  sound.refinements = static_cast<std::size_t>(number());
  for_each_field(sound, [&](std::vector<Complex>& field) {
    const auto count = static_cast<std::size_t>(number());
    const auto values = packed.subspan(place, count);
    field.assign(values.begin(), values.end());
    place += count;
  });
  return packed.subspan(place);
}

}  // namespace idiophone::harmonic
