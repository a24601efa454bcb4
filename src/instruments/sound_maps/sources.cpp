#include "sources.hpp"

#include <cmath>
#include <numbers>

#include "idiophone/air/surface/emitter.hpp"

namespace idiophone::sound_maps {

namespace {

using Complex = std::complex<double>;
constexpr Complex imaginary{0.0, 1.0};

Vector3 at(const std::array<std::vector<double>, 3>& vectors, std::size_t place) {
  return {vectors[0][place], vectors[1][place], vectors[2][place]};
}

/// Outward normal velocity at the corners of each triangle for a modal velocity of 1, [3 x triangles].
std::vector<double> normal_velocities(const sound_maps::SoundMap& map, std::size_t mode,
                                      const surface::Emission& surface) {
  const std::span<const float> shape = map.shape_of(mode);
  std::vector<double> velocities;
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    for (const Index vertex : map.triangles[t]) {
      velocities.push_back(Eigen::Map<const Eigen::Vector3f>(&shape[3 * static_cast<std::size_t>(vertex)])
                               .cast<double>()
                               .dot(at(surface.normal, t)));
    }
  }
  return velocities;
}

}  // namespace

surface::Emission surface_of(const sound_maps::SoundMap& map) {
  surface::SurfaceMotion rest{std::vector<double>(padded(map.triangles.size())),
                              std::vector<double>(surface::SurfaceMotion::position_length(map.vertices.size()))};
  for (std::size_t v = 0; v < map.vertices.size(); ++v) {
    Vector3::Map(&rest.position[3 * v]) = map.vertices[v];
  }
  surface::Emitter emitter(map.triangles, 0.0);
  surface::Emission surface;
  emitter.start(rest);
  emitter.emit(rest, surface);
  return surface;
}

Sources sources_of(const sound_maps::SoundMap& map, std::size_t mode, const surface::Emission& surface,
                   const ModalRadiation& radiation) {
  Sources sources;
  sources.frequency = map.frequency[mode];
  const double angular = 2.0 * std::numbers::pi * sources.frequency;
  sources.wave_number = angular / map.air_speed;
  const std::vector<double> velocities = normal_velocities(map, mode, surface);
  const double image = radiation ? 1.0 : 2.0;
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    const double share = surface.area[t] / (4.0 * std::numbers::pi);
    sources.monopole.push_back(image * share * imaginary * angular * map.air_density * corner_mean(velocities, t));
  }
  if (radiation) {
    sources.dipole = radiation(angular, velocities);
    for (std::size_t t = 0; t < map.triangles.size(); ++t) {
      sources.dipole[t] *= surface.area[t] / (4.0 * std::numbers::pi);
    }
  }
  return sources;
}

Complex pressure_at(const radiation::Paths& paths, const Sources& sources,
                    const std::optional<radiation::Atmosphere>& atmosphere) {
  const double attenuation = atmosphere ? atmosphere->attenuation(sources.frequency) : 0.0;
  const Complex propagation = attenuation + imaginary * sources.wave_number;
  const bool in_wall = sources.dipole.empty();
  Complex sum = 0.0;
  for (std::size_t t = 0; t < sources.monopole.size(); ++t) {
    const double distance = paths.distance[t];
    const double cosine = paths.cosine[t];
    if (in_wall && cosine <= 0.0) {
      continue;
    }
    const Complex dipole =
        in_wall ? 0.0 : cosine * (1.0 / distance + imaginary * sources.wave_number) * sources.dipole[t];
    sum += paths.gain[t] * std::exp(-propagation * distance) / distance * (sources.monopole[t] + dipole);
  }
  return sum;
}

std::vector<Complex> far_field(const surface::Emission& surface, const Sources& sources, const Vector3& centre,
                               const sound_maps::MapSphere& sphere) {
  const bool in_wall = sources.dipole.empty();
  std::vector<Complex> pressure;
  for (const Vector3& direction : sphere.direction) {
    Complex sum = 0.0;
    for (std::size_t t = 0; t < sources.monopole.size(); ++t) {
      const double cosine = direction.dot(at(surface.normal, t));
      if (in_wall && cosine <= 0.0) {
        continue;
      }
      const double phase = sources.wave_number * direction.dot(at(surface.centre, t) - centre);
      const Complex dipole = in_wall ? 0.0 : imaginary * sources.wave_number * cosine * sources.dipole[t];
      sum += Complex(std::cos(phase), std::sin(phase)) * (sources.monopole[t] + dipole);
    }
    pressure.push_back(sum);
  }
  return pressure;
}

}  // namespace idiophone::sound_maps
