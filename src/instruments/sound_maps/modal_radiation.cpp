#include "idiophone/instruments/sound_maps/modal_radiation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/air/harmonic/sphere_rule.hpp"
#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/air/surface/equivalent_radius.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/scene/still_receivers.hpp"
#include "sources.hpp"

namespace idiophone::sound_maps {

namespace {

using Complex = std::complex<double>;

/// Pressure of a sphere over that of a plane wave, s = i k a (surface/surface_pressure.hpp).
Complex sphere_factor(scene::SurfacePressureModel model, Complex s) {
  switch (model) {
    case scene::SurfacePressureModel::pulsating:
      return s / (s + 1.0);
    case scene::SurfacePressureModel::oscillating:
      return (s * s + s) / (s * s + 2.0 * s + 2.0);
    case scene::SurfacePressureModel::plane_wave:
      break;
  }
  return 1.0;
}

/// What one receiver hears: straight, and by way of the floor.
struct Reception {
  std::string name;
  radiation::ReceiverState receiver;
  std::vector<radiation::Paths> ways;
};

std::vector<Reception> receptions(const scene::Acoustics& acoustics, const surface::Emission& surface) {
  const radiation::Medium air{acoustics.radiation.air.speed, acoustics.audio.rate};
  std::vector<Reception> all;
  for (const scene::StillReceiver& still : scene::still_receivers(acoustics.listeners)) {
    Reception& reception = all.emplace_back();
    reception.name = still.name;
    reception.receiver = {
        .position = still.position, .axis = still.receiver->axis, .directivity = still.receiver->directivity};
    radiation::find_paths(surface, reception.receiver, air, reception.ways.emplace_back());
    if (const auto& floor = acoustics.radiation.floor) {
      const radiation::ReflectingPlane plane{floor->at, floor->direction, floor->reflection};
      radiation::find_paths(surface, radiation::image(reception.receiver, plane), air, reception.ways.emplace_back());
    }
  }
  return all;
}

/// Travel time from the nearest vertex, s.
double delay_of(const Vector3& position, const sound_maps::SoundMap& map) {
  double nearest = (position - map.vertices.front()).norm();
  for (const Vector3& vertex : map.vertices) {
    nearest = std::min(nearest, (position - vertex).norm());
  }
  return nearest / map.air_speed;
}

/// One mode's pressures: those of the receptions, then those of the directions at the map's distance.
std::vector<Complex> pressures_of(const sound_maps::SoundMap& map, std::size_t mode, const surface::Emission& surface,
                                  const std::vector<Reception>& receptions,
                                  const std::optional<radiation::Atmosphere>& atmosphere,
                                  const ModalRadiation& radiation) {
  const Sources sources = sources_of(map, mode, surface, radiation);
  std::vector<Complex> pressures;
  for (const Reception& reception : receptions) {
    Complex sum = 0.0;
    for (const radiation::Paths& way : reception.ways) {
      sum += pressure_at(way, sources, atmosphere);
    }
    const double turn = 2.0 * std::numbers::pi * sources.frequency * delay_of(reception.receiver.position, map);
    pressures.push_back(sum * std::polar(1.0, turn));
  }
  for (const Complex pressure : far_field(surface, sources, map.centre, map.sphere)) {
    pressures.push_back(pressure / map.sphere.distance);
  }
  return pressures;
}

/// @param pressures  [modes] as of pressures_of()
void put(sound_maps::SoundMap& map, const std::vector<Reception>& receptions,
         const std::vector<std::span<const Complex>>& pressures) {
  map.listeners.clear();
  for (std::size_t r = 0; r < receptions.size(); ++r) {
    auto& listener = map.listeners.emplace_back();
    listener.name = receptions[r].name;
    listener.position = receptions[r].receiver.position;
    listener.delay = delay_of(listener.position, map);
    for (const auto& of_mode : pressures) {
      listener.pressure.push_back(of_mode[r]);
    }
  }
  map.sphere.pressure.clear();
  map.radiation_decay.clear();
  const double scale = map.sphere.distance * map.sphere.distance / (2.0 * map.air_density * map.air_speed);
  for (const auto& of_mode : pressures) {
    const auto around = of_mode.subspan(receptions.size());
    map.sphere.pressure.insert(map.sphere.pressure.end(), around.begin(), around.end());
    double power = 0.0;  // W for a modal velocity of amplitude 1, whose energy is 1/2 J
    for (std::size_t d = 0; d < around.size(); ++d) {
      power += scale * map.sphere.weight[d] * std::norm(around[d]);
    }
    map.radiation_decay.push_back(power);
  }
}

/// Leaves out all but some modes.
void keep_lowest(sound_maps::SoundMap& map, std::size_t modes) {
  for (auto* values : {&map.frequency, &map.material_decay, &map.mesh_error}) {
    values->resize(std::min(values->size(), modes));  // only rank 0 has them all
  }
  map.shape.resize(modes * 3 * map.vertices.size());
  if (map.scalable) {
    map.scalable->lossless_frequency.resize(modes);
  }
  map.stretching = map.stretching.of_first(modes);
}

}  // namespace

void share_vibrations(sound_maps::SoundMap& map, MPI_Comm communicator) {
  for (auto* numbers : {&map.frequency, &map.sphere.weight}) {
    parallel::broadcast(*numbers, communicator);
  }
  for (auto* points : {&map.vertices, &map.sphere.direction}) {
    parallel::broadcast(*points, communicator);
  }
  parallel::broadcast(map.triangles, communicator);
  parallel::broadcast(map.shape, communicator);
  parallel::broadcast(map.sphere.distance, communicator);
  parallel::broadcast(map.centre, communicator);
  parallel::broadcast(map.air_density, communicator);
  parallel::broadcast(map.air_speed, communicator);
}

ModalRadiation sphere_patches(const sound_maps::SoundMap& map, const scene::Radiation& radiation) {
  std::vector<double> radii(map.triangles.size(), 1.0);
  if (radiation.surface_pressure != scene::SurfacePressureModel::plane_wave) {
    std::vector<std::array<Vector3, 3>> corners;
    for (const auto& [a, b, c] : map.triangles) {
      corners.push_back({map.vertices[a], map.vertices[b], map.vertices[c]});
    }
    std::vector<Index> all(corners.size());
    std::iota(all.begin(), all.end(), 0);
    radii = surface::equivalent_radii(corners, all);
  }
  return [radii = std::move(radii), air = radiation.air, model = radiation.surface_pressure](
             double angular_frequency, std::span<const double> normal_velocity) {
    std::vector<Complex> pressure;
    for (std::size_t t = 0; t < radii.size(); ++t) {
      const Complex s(0.0, angular_frequency / air.speed * radii[t]);
      pressure.push_back(air.impedance() * corner_mean(normal_velocity, t) * sphere_factor(model, s));
    }
    return pressure;
  };
}

sound_maps::MapSphere sphere_of_directions(std::size_t rings) {
  harmonic::SphereRule rule = harmonic::sphere_rule(static_cast<unsigned>(rings));
  sound_maps::MapSphere sphere;
  sphere.rings = rule.rings;
  sphere.azimuths = rule.azimuths;
  sphere.direction = std::move(rule.directions);
  sphere.weight = std::move(rule.weights);
  return sphere;
}

void add_radiation(sound_maps::SoundMap& map, const scene::Acoustics& acoustics, const ModalRadiation& radiation,
                   MPI_Comm communicator, const PartWatch& watch) {
  const surface::Emission surface = surface_of(map);
  const std::vector<Reception> heard = receptions(acoustics, surface);
  const auto& air = acoustics.radiation.air;
  std::optional<radiation::Atmosphere> atmosphere;
  if (air.absorption) {
    atmosphere = {air.temperature, air.humidity, air.pressure};
  }
  const auto ranks = static_cast<std::size_t>(parallel::size_of(communicator));
  std::vector<Complex> own;
  std::size_t next = parallel::rank_of(communicator);
  for (bool goes_on = true; goes_on && next < map.modes();) {
    const auto pressures = pressures_of(map, next, surface, heard, atmosphere, radiation);
    own.insert(own.end(), pressures.begin(), pressures.end());
    next += ranks;
    goes_on = !watch || watch(std::min(next, map.modes()), map.modes());
  }
  keep_lowest(map, parallel::smallest(std::uint64_t{std::min(next, map.modes())}, communicator));
  const auto all = parallel::gather_all(std::span<const Complex>(own), communicator);
  const std::size_t width = heard.size() + map.sphere.direction.size();
  std::vector<std::span<const Complex>> pressures;
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    pressures.push_back(std::span(all.values).subspan(all.offsets[mode % ranks] + mode / ranks * width, width));
  }
  put(map, heard, pressures);
}

}  // namespace idiophone::sound_maps
