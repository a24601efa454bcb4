#include "grid_far_field.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "idiophone/air/waves/pulse_response.hpp"

namespace idiophone::harmonic {

namespace {

/// Of each triangle, outward, m/s. [triangles]
struct MeanVelocities {
  std::vector<float> real, imaginary;
};

MeanVelocities mean_velocities(const Vibration& vibration) {
  MeanVelocities means;
  for (std::size_t at = 0; at < vibration.normal_velocity.size(); at += 3) {
    const Complex* const corners = &vibration.normal_velocity[at];
    const Complex mean = (corners[0] + corners[1] + corners[2]) / 3.0;
    means.real.push_back(static_cast<float>(mean.real()));
    means.imaginary.push_back(static_cast<float>(mean.imag()));
  }
  return means;
}

}  // namespace

std::vector<harmonic::Complex> grid_far_field(const AcousticSurface& surface, const Vibration& vibration,
                                              const harmonic::QuietAir& air, double cell,
                                              std::span<const Vector3> directions) {
  const harmonic::Boundary& boundary = surface.boundary;
  std::vector<float> positions;
  for (const Vector3& vertex : boundary.vertices) {
    positions.insert(positions.end(), vertex.begin(), vertex.end());
  }
  // Motions in phase, and a quarter of a period ahead.
  const auto shapes = mean_velocities(vibration);
  std::vector<Complex> far_field(directions.size());
  for (const auto& [phase, shape] :
       {std::pair{Complex(1.0, 0.0), shapes.real}, {Complex(0.0, 1.0), shapes.imaginary}}) {
    if (std::ranges::all_of(shape, [](float velocity) { return velocity == 0.0F; })) {
      continue;
    }
    const std::array frequencies = {vibration.frequency};
    const waves::PulseResponse response({.obstruction = {boundary.triangles, positions},
                                         .shape = shape,
                                         .cell = cell,
                                         .speed = air.speed,
                                         .impedance = air.impedance()},
                                        frequencies);
    for (std::size_t d = 0; d < directions.size(); ++d) {
      far_field[d] += phase * response.towards(0, directions[d]);
    }
  }
  return far_field;
}

}  // namespace idiophone::harmonic
