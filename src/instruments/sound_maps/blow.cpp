#include "idiophone/instruments/sound_maps/blow.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "resonances.hpp"

namespace idiophone::sound_maps {

namespace {

using Complex = std::complex<double>;

/// The force of a blow as a listener meets it: sampled finely, from the audio sample before the first one heard on.
struct SampledForce {
  std::size_t first = 0;       ///< audio sample heard first
  int steps = 1;               ///< in an audio sample
  std::vector<double> values;  ///< [whole audio samples x steps + 1] N; zero at both ends
};

SampledForce sampled(const Blow& blow, double delay, int rate) {
  constexpr double steps_of_blow = 400.0;
  const double samples = blow.duration * rate;
  SampledForce force;
  force.first = static_cast<std::size_t>(std::floor(delay * rate)) + 1;
  force.steps = static_cast<int>(std::ceil(steps_of_blow / samples));
  const double begin = static_cast<double>(force.first - 1) / rate - delay;
  const auto count = static_cast<std::size_t>(std::ceil(samples) + 1) * force.steps;
  for (std::size_t i = 0; i <= count; ++i) {
    const double time = begin + static_cast<double>(i) / (static_cast<double>(rate) * force.steps);
    force.values.push_back(time >= 0.0 && time < blow.duration ? blow.force(time) : 0.0);
  }
  return force;
}

/// Adds what one mode gives to a sound.
void add_mode(std::vector<double>& sound, const Resonance& mode, const SampledForce& force, int rate) {
  const resonators::OscillatorStep step = mode.oscillator.step(1.0 / (static_cast<double>(rate) * force.steps));
  const Complex sample_decay = std::exp(mode.oscillator.exponent() / static_cast<double>(rate));
  Complex state = 0.0;
  std::size_t next = 0;
  for (std::size_t n = force.first; n < sound.size(); ++n) {
    if (next + 1 < force.values.size()) {
      for (int i = 0; i < force.steps; ++i, ++next) {
        state = step.turn * state + step.first * force.values[next] + step.last * force.values[next + 1];
      }
    } else {
      state *= sample_decay;
    }
    sound[n] += (mode.gain * state).real();
  }
}

/// Takes away what modes do when they only follow the force.
void take_following(std::vector<double>& sound, const Following& following, const SampledForce& force, int rate) {
  resonators::SmoothRise rise(following.angular_frequency, 1.0 / (static_cast<double>(rate) * force.steps));
  const auto at = [&](std::size_t i) { return i < force.values.size() ? force.values[i] : 0.0; };
  std::size_t next = 0;
  for (std::size_t n = force.first; n < sound.size(); ++n) {
    for (int i = 0; i < force.steps; ++i, ++next) {
      rise.advance(at(next), at(next + 1));
    }
    sound[n] -= following.by_force * at(next) + following.by_rise * rise.at(at(next));
  }
}

}  // namespace

std::vector<double> participation(const SoundMap& map, const SurfacePoint& point, const Vector3& direction) {
  std::vector<double> participations;
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    const std::span<const float> shape = map.shape_of(mode);
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* displacement = &shape[3 * static_cast<std::size_t>(map.triangles[point.triangle][corner])];
      sum += point.weights[static_cast<Eigen::Index>(corner)] *
             Eigen::Map<const Eigen::Vector3f>(displacement).cast<double>().dot(direction);
    }
    participations.push_back(sum);
  }
  return participations;
}

std::vector<double> participation(const SoundMap& map, const Vector3& at, const Vector3& direction) {
  return participation(map, nearest_point(map, at), direction);
}

Vector3 inward_normal(const sound_maps::SoundMap& map, const Vector3& at) {
  const auto& [i, j, k] = map.triangles[nearest_point(map, at).triangle];
  const Vector3 outward = (map.vertices[j] - map.vertices[i]).cross(map.vertices[k] - map.vertices[i]);
  return outward.norm() > 0.0 ? Vector3(-outward.normalized()) : Vector3(-Vector3::UnitZ());
}

std::vector<double> sound_of(const Blow& blow, const sound_maps::SoundMap& map, std::size_t listener, int rate,
                             std::size_t samples) {
  const sound_maps::MapListener& ear = map.listeners[listener];
  const std::vector<double> participations = participation(map, blow.at, blow.direction);
  const SampledForce force = sampled(blow, ear.delay, rate);
  std::vector<double> sound(samples);
  const std::vector<Resonance> modes = resonances(map, participations, listener, rate);
  for (const Resonance& mode : modes) {
    add_mode(sound, mode, force, rate);
  }
  take_following(sound, following(modes), force, rate);
  return sound;
}

}  // namespace idiophone::sound_maps
