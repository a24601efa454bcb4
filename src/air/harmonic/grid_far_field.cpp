#include "grid_far_field.hpp"

#include <array>

#include "idiophone/air/waves/pulse_response.hpp"

namespace idiophone::harmonic {

std::vector<harmonic::Complex> grid_far_field(const AcousticSurface& surface, const Vibration& vibration,
                                              const harmonic::QuietAir& air, double cell,
                                              std::span<const Vector3> directions) {
  const harmonic::Boundary& boundary = surface.boundary;
  std::vector<float> positions;
  for (const Vector3& vertex : boundary.vertices) {
    positions.insert(positions.end(), vertex.begin(), vertex.end());
  }
  std::vector<float> shape;
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    const double* const corners = &vibration.normal_velocity[3 * t];
    shape.push_back(static_cast<float>((corners[0] + corners[1] + corners[2]) / 3.0));
  }
  const std::array frequencies = {vibration.frequency};
  const waves::PulseResponse response({.obstruction = {boundary.triangles, positions},
                                       .shape = shape,
                                       .cell = cell,
                                       .speed = air.speed,
                                       .impedance = air.impedance()},
                                      frequencies);
  std::vector<harmonic::Complex> far_field;
  for (const Vector3& direction : directions) {
    far_field.push_back(response.towards(0, direction));
  }
  return far_field;
}

}  // namespace idiophone::harmonic
