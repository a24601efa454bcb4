#pragma once
// A small sphere that pulsates once in a room, and what microphones there hear of it.

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/scene/scene.hpp"
#include "shared_folder.hpp"

namespace idiophone::propagation {

using std::numbers::pi;
using support::rank;
using support::ranks;

constexpr double sphere_radius = 1e-3;     // m
constexpr std::int64_t pulse_middle = 40;  // audio sample

inline scene::Room room_of(const Vector3& size, double absorption, int order, bool late) {
  scene::Room room{.size = size, .corner = Vector3(-1, -2, 0.5), .images = order, .late = late, .where = {}};
  for (scene::OctaveBands& wall : room.absorption) {
    wall.fill(absorption);
  }
  return room;
}

inline scene::Scene scene_in(const scene::Room& room, int rate, const std::vector<Vector3>& microphones) {
  scene::Scene scene;
  scene.audio.rate = rate;
  scene.radiation.model = scene::RadiationModel::kirchhoff;
  scene.radiation.visibility.reset();
  scene.radiation.room = room;
  for (const Vector3& microphone : microphones) {
    auto& listener = scene.listeners.emplace_back();
    listener.name = "listener";
    listener.receivers.push_back({.channel = "listener", .position = microphone});
  }
  return scene;
}

/// Eight triangles around a centre, as large as a sphere, that all move alike.
inline surface::Emission sphere(const Vector3& centre, double strength) {
  surface::Emission emission;
  emission.resize(8);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vector3 normal = Vector3(i & 1U ? 1 : -1, i & 2U ? 1 : -1, i & 4U ? 1 : -1).normalized();
    for (int axis = 0; axis < 3; ++axis) {
      emission.normal[axis][i] = normal[axis];
      emission.centre[axis][i] = centre[axis] + sphere_radius * normal[axis];
    }
    emission.area[i] = 4.0 * pi * sphere_radius * sphere_radius / 8.0;
    emission.pressure[i] = strength;
  }
  return emission;
}

/// The pulse at a time in audio samples, and its derivative.
inline double pressure_at(double time, double width) {
  return std::exp(-0.5 * std::pow((time - pulse_middle) / width, 2));
}
inline double slope_at(double time, double width) {
  return -(time - pulse_middle) / (width * width) * pressure_at(time, width);
}

/// All of the pulse that is not negligible.
inline void emit(Ears& ears, const Vector3& source, double width) {
  const auto half = static_cast<std::int64_t>(8.0 * width);
  for (std::int64_t sample = pulse_middle - half; sample <= pulse_middle + half; ++sample) {
    const double strength = pressure_at(static_cast<double>(sample), width) / ranks();
    ears.hear(sample, sphere(source, strength), nullptr);
  }
}

/// What all listeners hear of a pulse of a width (audio samples, at most 5); nothing on other ranks than 0.
inline std::vector<std::vector<double>> hear(const scene::Scene& scene, const Vector3& source, std::size_t length,
                                             double width) {
  Ears ears(scene, 0, 8);
  emit(ears, source, width);
  return ears.take(length, MPI_COMM_WORLD);
}

inline double energy(const std::vector<double>& sound, double begin, double end) {
  const auto at = [&](double sample) { return sound.begin() + static_cast<std::ptrdiff_t>(sample); };
  return std::inner_product(at(begin), at(end), at(begin), 0.0);
}

inline std::complex<double> spectrum(const std::vector<double>& sound, double frequency, int rate) {
  std::complex<double> sum;
  for (std::size_t n = 0; n < sound.size(); ++n) {
    sum += sound[n] * std::polar(1.0, -2.0 * pi * frequency / rate * static_cast<double>(n));
  }
  return sum;
}

inline double decibels_of_energy(double ratio) {
  return 10.0 * std::log10(ratio);
}

}  // namespace idiophone::propagation
