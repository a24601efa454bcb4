#pragma once
// Radiation of sound: the model, visibility, the air, the floor and the room.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/room_section.hpp"

namespace idiophone::scene {

/// The air (section 3.2: 20 C, one atmosphere).
struct AirProperties {
  double density = 1.21;  ///< kg/m3
  double speed = 343.0;   ///< m/s

  bool absorption = false;     ///< atmospheric absorption, by the next three
  double temperature = 20.0;   ///< degrees Celsius
  double humidity = 50.0;      ///< relative, per cent
  double pressure = 101325.0;  ///< Pa

  /// Specific acoustic impedance z = rho c, Pa s/m.
  [[nodiscard]] double impedance() const { return density * speed; }
};

/// A rigid plane that reflects sound.
struct Floor {
  Vector3 at = Vector3::Zero();          ///< a point of it, m
  Vector3 direction = Vector3::UnitZ();  ///< unit vector: its normal, towards the listeners
  double reflection = 1.0;               ///< reflected pressure over incident pressure, -1 to 1

  /// Distance from it, negative behind it, m.
  [[nodiscard]] double height(const Vector3& point) const { return (point - at).dot(direction); }
};

/// Radiation models (docs/use/radiation.md).
enum class RadiationModel { huygens, rayleigh, kirchhoff, waves };

/// The pressure of the air at a surface, for model kirchhoff.
enum class SurfacePressureModel { plane_wave, pulsating, oscillating };

/// Waves on a grid in the air (docs/use/waves.md), for model waves.
struct WaveGrid {
  double cell = 0.0;         ///< edge of a cell, m
  double margin = 0.0;       ///< room that the bodies may move in, around where they are at the start, m
  bool back = false;         ///< whether the pressure of the air acts on the bodies
  bool wall_losses = false;  ///< whether friction and heat conduction at walls take sound
};

/// Updates of the visibility of triangles from each receiver.
struct VisibilityUpdates {
  double rate = 100.0;  ///< per second, at most the audio rate

  /// Audio samples between two updates: the nearest whole number.
  [[nodiscard]] std::int64_t interval(int audio_rate) const { return std::llround(audio_rate / rate); }
};

/// A thin, flat and rigid screen that blocks sound, which bends around its edges.
struct Screen {
  std::string name;
  std::vector<Vector3> corners;  ///< of a convex polygon, in order, m
};

struct Radiation {
  RadiationModel model = RadiationModel::kirchhoff;
  SurfacePressureModel surface_pressure = SurfacePressureModel::oscillating;  ///< kirchhoff only
  WaveGrid grid;

  std::optional<VisibilityUpdates> visibility = VisibilityUpdates{};  ///< none: everything is visible

  /// Whether the surface pressure depends on the equivalent radii of the bodies' surfaces.
  [[nodiscard]] bool needs_radii() const {
    return model == RadiationModel::kirchhoff && surface_pressure != SurfacePressureModel::plane_wave;
  }

  AirProperties air;
  std::optional<Floor> floor;
  std::optional<Room> room;
  std::vector<Screen> screens;
  bool diffraction = false;  ///< whether sound bends around the edges of obstacles and of other bodies, too
};

}  // namespace idiophone::scene
