// What modes radiate, against exact solutions of spheres and pistons; the same bits on any number of ranks.

#include "idiophone/instruments/sound_maps/modal_radiation.hpp"

#include <gmock/gmock.h>
#include <mpi.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/air/radiation/absorption.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"
#include "vibrating_map.hpp"

namespace idiophone::sound_maps {
namespace {

using radiation::decibels;
using Complex = std::complex<double>;
using std::numbers::pi;
constexpr double impedance = radiation::air_density * 343.0;

scene::Scene heard_at(const std::vector<Vector3>& places, scene::SurfacePressureModel model) {
  scene::Scene scene;
  scene.radiation.surface_pressure = model;
  for (const Vector3& place : places) {
    auto& listener = scene.listeners.emplace_back();
    listener.name = "ear";
    listener.receivers = {{.channel = "ear", .position = place}};
  }
  return scene;
}

sound_maps::SoundMap with_radiation(sound_maps::SoundMap map, const scene::Scene& scene,
                                    MPI_Comm communicator = MPI_COMM_WORLD) {
  map.sphere = sphere_of_directions(6);
  share_vibrations(map, communicator);
  add_radiation(map, scene, sphere_patches(map, scene.radiation), communicator);
  return map;
}

Vector3 breathing(const Vector3& place) {
  return place.normalized();
}

Vector3 along_z(const Vector3& /*place*/) {
  return Vector3::UnitZ();
}

ON_RANKS(1, 3);

TEST(SphereOfDirections, IntegratesPolynomialsExactly) {
  const sound_maps::MapSphere sphere = sphere_of_directions(4);
  ASSERT_EQ(sphere.direction.size(), 32);
  const auto integral = [&](const std::function<double(const Vector3&)>& function) {
    double sum = 0.0;
    for (std::size_t d = 0; d < sphere.direction.size(); ++d) {
      sum += sphere.weight[d] * function(sphere.direction[d]);
    }
    return sum;
  };
  EXPECT_NEAR(integral([](const Vector3&) { return 1.0; }), 4 * pi, 1e-12);
  EXPECT_NEAR(integral([](const Vector3& n) { return n[2] * n[2]; }), 4 * pi / 3, 1e-12);
  EXPECT_NEAR(integral([](const Vector3& n) { return std::pow(n[0], 4) * n[1] * n[1]; }), 4 * pi * 3 / 105, 1e-12);
  EXPECT_GT(sphere.direction.front()[2], 0.8) << "rings begin at the z axis";
  EXPECT_NEAR(sphere.direction.front()[1], 0, 1e-15) << "azimuths begin at the x axis";
}

/// A breathing sphere of unit normal velocity: p = rho c (a/r) ika/(1 + ika) exp(-ik (r - a)), power
/// 2 pi a^2 rho c (ka)^2/(1 + (ka)^2).
TEST(ModalRadiation, OfABreathingSphereIsExact) {
  constexpr double radius = 0.1;
  const std::vector<double> frequencies = {100, 546, 2000};
  const sound_maps::SoundMap map = with_radiation(map_of(radiation::sphere(radius, 12), breathing, frequencies),
                                                  heard_at({{0.3, 0.4, 1.2}}, scene::SurfacePressureModel::pulsating));
  for (std::size_t mode = 0; mode < frequencies.size(); ++mode) {
    const double ka = 2 * pi * frequencies[mode] / 343 * radius;
    const Complex exact = impedance * radius * Complex(0, ka) / Complex(1, ka);
    const Complex heard = map.listeners[0].pressure[mode];
    EXPECT_NEAR(decibels(std::abs(heard), std::abs(exact) / 1.3), 0, 0.1);
    EXPECT_NEAR(std::arg(heard / exact), 0, 0.03) << "after the delay, from the surface";
    for (std::size_t d = 0; d < map.sphere.direction.size(); ++d) {
      const Complex far = map.sphere.pressure[mode * map.sphere.direction.size() + d];
      EXPECT_NEAR(decibels(std::abs(far), std::abs(exact)), 0, 0.15);
      EXPECT_NEAR(std::arg(far / exact * std::polar(1.0, -ka)), 0, 0.03) << "from the centre";
    }
    const double power = 2 * pi * radius * radius * impedance * ka * ka / (1 + ka * ka);
    EXPECT_NEAR(10 * std::log10(map.radiation_decay[mode] / power), 0, 0.15);
  }
  EXPECT_NEAR(map.listeners[0].delay, 1.2 / 343, 2e-6);
}

/// A rigid sphere that moves to and fro with unit velocity: p = rho c cos(theta) (a/r) a ik (1 + 1/(ikr)) s^2/... of
/// order 1; in the far field rho c cos(theta) (a/r) (ka)^2/(2 + 2 ika - (ka)^2) up to the phase.
TEST(ModalRadiation, OfAnOscillatingSphereIsExact) {
  constexpr double radius = 0.1;
  const double frequency = 800;
  const double ka = 2 * pi * frequency / 343 * radius;
  const sound_maps::SoundMap map = with_radiation(map_of(radiation::sphere(radius, 16), along_z, {frequency}),
                                                  heard_at({}, scene::SurfacePressureModel::oscillating));
  const double exact = impedance * radius * ka * ka / std::abs(Complex(2 - ka * ka, 2 * ka));
  for (std::size_t d = 0; d < map.sphere.direction.size(); ++d) {
    const double cosine = map.sphere.direction[d][2];
    EXPECT_NEAR(std::abs(map.sphere.pressure[d]), exact * std::abs(cosine), 0.02 * exact);
  }
  EXPECT_NEAR(10 * std::log10(map.radiation_decay[0] * 6 * impedance / (4 * pi * exact * exact)), 0, 0.15);
}

TEST(ModalRadiation, EndedEarlyKeepsTheLowestModes) {
  const scene::Scene scene = heard_at({{0, 0, 0.5}}, scene::SurfacePressureModel::pulsating);
  sound_maps::SoundMap map = map_of(radiation::sphere(0.1, 4), breathing, {100, 200, 300, 400, 500});
  map.mesh_error = {1, 2, 3, 4, 5};
  const sound_maps::SoundMap whole = with_radiation(map, scene);
  map.sphere = sphere_of_directions(6);
  share_vibrations(map, MPI_COMM_WORLD);
  std::size_t parts = 0;
  add_radiation(map, scene, sphere_patches(map, scene.radiation), MPI_COMM_WORLD,
                [&](std::size_t /*done*/, std::size_t expected) {
                  EXPECT_EQ(expected, 5);
                  return ++parts < 1;
                });
  const auto ranks = static_cast<std::size_t>(parallel::size_of(MPI_COMM_WORLD));  // each has done one
  ASSERT_EQ(map.modes(), ranks);
  EXPECT_EQ(map.mesh_error.size(), ranks);
  EXPECT_EQ(map.material_decay.size(), ranks);
  EXPECT_EQ(map.radiation_decay.size(), ranks);
  EXPECT_EQ(map.shape.size(), ranks * 3 * map.vertices.size());
  EXPECT_EQ(map.listeners[0].pressure.size(), ranks);
  EXPECT_EQ(map.listeners[0].pressure.back(), whole.listeners[0].pressure[ranks - 1]);
  EXPECT_EQ(map.sphere.pressure.back(), whole.sphere.pressure[ranks * map.sphere.direction.size() - 1]);
}

/// A piston in a wall, on its axis: 2 rho c |sin(k/2 (sqrt(z^2 + a^2) - z))|.
TEST(ModalRadiation, OfAPistonInAWallIsExact) {
  constexpr double radius = 0.05;
  sound_maps::SoundMap map = map_of(radiation::disc(radius, 30), along_z, {500, 3000, 6000});
  map.sphere = sphere_of_directions(4);
  share_vibrations(map, MPI_COMM_WORLD);
  add_radiation(map, heard_at({{0, 0, 0.2}, {0, 0, -0.2}}, {}), rigid_wall(), MPI_COMM_WORLD);
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    const double k = 2 * pi * map.frequency[mode] / 343;
    const double exact = 2 * impedance * std::abs(std::sin(k / 2 * (std::hypot(0.2, radius) - 0.2)));
    EXPECT_NEAR(decibels(std::abs(map.listeners[0].pressure[mode]), exact), 0, 0.1) << map.frequency[mode] << " Hz";
    EXPECT_EQ(map.listeners[1].pressure[mode], 0.0) << "behind the wall";
  }
}

/// The field of a breathing and of an oscillating sphere, whatever scene::SurfacePressureModel says.
TEST(BoundaryElements, KnowTheFieldOfAnySphere) {
  constexpr double radius = 0.1;
  for (const bool breathes : {true, false}) {
    const scene::Scene scene = heard_at({{0.0, 0.0, 0.8}}, scene::SurfacePressureModel::plane_wave);
    sound_maps::SoundMap map =
        map_of(radiation::icosphere(radius, 5), breathes ? breathing : along_z, {100, 546, 1500});
    map.sphere = sphere_of_directions(6);
    ASSERT_GT(resolved_frequency(map), 1500);
    share_vibrations(map, MPI_COMM_WORLD);
    add_radiation(map, scene, boundary_elements(map, scene.radiation), MPI_COMM_WORLD);
    for (std::size_t mode = 0; mode < map.modes(); ++mode) {
      const double ka = 2 * pi * map.frequency[mode] / 343 * radius;
      const double kr = 8 * ka;
      const double monopole = impedance / 8 * ka / std::hypot(1, ka);
      const double dipole = impedance / 8 * ka * ka * std::hypot(1, 1 / kr) / std::abs(Complex(2 - ka * ka, 2 * ka));
      EXPECT_NEAR(decibels(std::abs(map.listeners[0].pressure[mode]), breathes ? monopole : dipole), 0, 0.1) << ka;
      const double far =
          impedance * radius * ka * (breathes ? 1 / std::hypot(1, ka) : ka / std::abs(Complex(2 - ka * ka, 2 * ka)));
      const double power = far * far / (2 * impedance) * 4 * pi / (breathes ? 1 : 3);
      EXPECT_NEAR(10 * std::log10(map.radiation_decay[mode] / power), 0, 0.1) << ka;
    }
  }
}

TEST(BoundaryElements, LeaveModesThatTheMeshDoesNotResolveToSpherePatches) {
  const scene::Scene scene = heard_at({}, scene::SurfacePressureModel::oscillating);
  const sound_maps::SoundMap map = map_of(radiation::icosphere(0.1, 2), along_z, {500});
  const double resolved = resolved_frequency(map);
  EXPECT_NEAR(resolved, 343 / (3 * 0.06), 0.1 * resolved);
  const std::vector<double> velocity(3 * map.triangles.size(), 1.0);
  const double above = 2 * pi * 1.01 * resolved;
  EXPECT_EQ(boundary_elements(map, scene.radiation)(above, velocity),
            sphere_patches(map, scene.radiation)(above, velocity));
  EXPECT_NE(boundary_elements(map, scene.radiation)(0.9 * above, velocity),
            sphere_patches(map, scene.radiation)(0.9 * above, velocity));
}

TEST(ModalRadiation, ComesBackFromTheFloor) {
  scene::Scene scene = heard_at({{0, 0, 1}}, scene::SurfacePressureModel::pulsating);
  const sound_maps::SoundMap sphere = map_of(radiation::sphere(0.05, 8), breathing, {300});
  const Complex open = with_radiation(sphere, scene).listeners[0].pressure[0];
  scene.radiation.floor = {.at = {0, 0, -2}, .direction = {0, 0, 1}, .reflection = 0.5};
  const Complex heard = with_radiation(sphere, scene).listeners[0].pressure[0];
  const double k = 2 * pi * 300 / 343;
  EXPECT_NEAR(std::abs(heard / open - (1.0 + 0.5 / 5.0 * std::polar(1.0, -4 * k))), 0, 0.003);
}

TEST(ModalRadiation, IsAbsorbedAndHasADirection) {
  scene::Scene scene = heard_at({{0, 0, 20}}, scene::SurfacePressureModel::pulsating);
  const sound_maps::SoundMap sphere = map_of(radiation::sphere(0.05, 8), breathing, {4000});
  const double open = std::abs(with_radiation(sphere, scene).listeners[0].pressure[0]);
  scene.radiation.air.absorption = true;
  const double absorbed = std::abs(with_radiation(sphere, scene).listeners[0].pressure[0]);
  EXPECT_NEAR(decibels(absorbed, open), -20 * 8.686 * radiation::Atmosphere{}.attenuation(4000), 0.01);
  scene.radiation.air.absorption = false;
  scene.listeners[0].receivers[0].axis = Vector3::UnitZ();  // away from the sphere
  scene.listeners[0].receivers[0].directivity = 0.5;
  EXPECT_LT(std::abs(with_radiation(sphere, scene).listeners[0].pressure[0]), 1e-4 * open);
}

TEST(ModalRadiation, HasTheSameBitsOnAnyNumberOfRanks) {
  const sound_maps::SoundMap sphere = map_of(radiation::sphere(0.1, 4), along_z, {100, 200, 300, 400, 500});
  const scene::Scene scene = heard_at({{0.3, 0, 1}, {0, 1, 0}}, scene::SurfacePressureModel::oscillating);
  const sound_maps::SoundMap together = with_radiation(sphere, scene);
  const sound_maps::SoundMap alone = with_radiation(sphere, scene, MPI_COMM_SELF);
  EXPECT_EQ(together.sphere.pressure, alone.sphere.pressure);
  EXPECT_EQ(together.radiation_decay, alone.radiation_decay);
  EXPECT_EQ(together.listeners[1].pressure, alone.listeners[1].pressure);
}

}  // namespace
}  // namespace idiophone::sound_maps
