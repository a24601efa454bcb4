// A light, stiff plate on springs, which a blow makes oscillate, in air that takes its energy away.

#include "coupled_air.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "block_mesh.hpp"
#include "coupled_system.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;
using ::testing::HasSubstr;

const Vector3 size(0.1, 0.1, 0.03);         // of the plate, m
constexpr double plate_density = 20.0;      // of the plate, kg/m3
constexpr double plate_frequency = 1000.0;  // on its springs, without air, Hz

scene::Scene plate_on_springs() {
  scene::Scene scene;
  scene.name = "plate";
  scene.time.duration = 0.1;
  scene.materials = {{"foam", 5e8, 0.2, plate_density, {}, {}}};
  scene::Body& body = scene.bodies.emplace_back();
  body.name = "plate";
  body.element = element::tet10;
  const Vector3 below(size[0] / 2, size[1] / 2, 0.0), above(size[0] / 2, size[1] / 2, size[2]);
  body.supports.push_back(
      {.name = "springs",
       .place = {.at = below, .radius = 0.1, .where = {}},
       .stiffness = plate_density * size.prod() * std::pow(2.0 * std::numbers::pi * plate_frequency, 2)});
  scene::ForcePulse& blow = scene.pulses.emplace_back();
  blow.place = {.at = above, .radius = 0.1, .where = {}};
  blow.force = Vector3(0.0, 0.0, -1.0);
  blow.signal.duration = 5e-4;
  scene.audio.rate = 22050;
  scene.audio.max_frequency = 10000.0;
  scene.radiation.model = scene::RadiationModel::waves;
  scene.radiation.grid = {.cell = 0.01, .margin = 0.005, .back = true};
  scene.radiation.visibility.reset();
  scene::Listener& listener = scene.listeners.emplace_back();
  listener.name = "ear";
  listener.receivers.push_back({.channel = "ear", .position = Vector3(0.5, 0.3, 0.2)});
  return scene;
}

/// Energy that leaves through the box around the plate, on one rank.
class EnergyFlow {
 public:
  explicit EnergyFlow(const System& system)
      : period_(1.0 / system.scene().audio.rate),
        density_(system.scene().radiation.air.density),
        box_(system.grid().field(), system.grid().plan().enclosure),
        gradient_(box_.patches()),
        velocity_(box_.patches()) {}

  /// Adds what left in the last audio sample.
  void add() {
    const surface::Emission& air = box_.emission();
    for (std::size_t patch = 0; patch < velocity_.size(); ++patch) {
      velocity_[patch] -= (gradient_[patch] + air.pressure_gradient[patch]) / 2.0 / density_ * period_;
      gradient_[patch] = air.pressure_gradient[patch];
      energy_ += air.area[patch] * air.surface_pressure[patch] * velocity_[patch] * period_;
    }
  }

  [[nodiscard]] double energy() const { return energy_; }

 private:
  double period_, density_;  // s, kg/m3
  waves::EnclosingBox box_;
  std::vector<double> gradient_, velocity_;  // outwards, Pa/m and m/s
  double energy_ = 0.0;
};

/// The body of a scene moves by its rigid motion and so many modes.
scene::Scene with_modes(scene::Scene scene, int count) {
  scene.bodies.front().modal = {.up_to = {}, .count = count, .where = {}};
  return scene;
}

constexpr double apart = 0.12;  // from plate to plate, m

/// A scene's plate, and another one of finite elements beside it.
scene::Scene with_another_plate(scene::Scene scene) {
  scene::Body other = scene.bodies.front();
  other.name = "other";
  other.modal.reset();
  other.supports.front().place.at[0] += apart;
  scene.bodies.push_back(std::move(other));
  return scene;
}

/// A block for each body, beside each other.
std::vector<mesh::Mesh> blocks(const scene::Scene& scene, const Vector3& extent, const std::array<int, 3>& cells) {
  std::vector<mesh::Mesh> meshes;
  for (const scene::Body& body : scene.bodies) {
    mesh::Mesh mesh = support::block_mesh(element::tet10, extent, cells);
    for (Vector3& node : mesh.nodes) {
      node[0] += apart * static_cast<double>(meshes.size());
    }
    mesh.indivisible = body.modal.has_value();
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

System plate(const scene::Scene& scene, MPI_Comm communicator) {
  return {scene, blocks(scene, size, {3, 3, 1}), communicator};
}

/// The energy that left through the box over the work of the blow, when nearly all of it has left.
double energy_through_box(const scene::Scene& scene) {
  System system = plate(scene, MPI_COMM_SELF);
  system.start();
  EnergyFlow flow(system);
  for (int sample = 0; sample < 1250; ++sample) {
    system.advance(1);
    flow.add();
  }
  const bodies::Observation seen = system.source().observe_now();
  EXPECT_LT(seen.kinetic() + seen.elastic(), 0.01 * seen.work);
  return flow.energy() / seen.work;
}

ON_RANKS(1);

TEST(CoupledAir, TakesTheEnergyThatLeavesThroughTheBox) {
  EXPECT_NEAR(energy_through_box(plate_on_springs()), 1.0, 0.02);
}

TEST(CoupledAir, TakesTheEnergyOfAModalBodyThatLeavesThroughTheBox) {
  EXPECT_NEAR(energy_through_box(with_modes(plate_on_springs(), 6)), 1.0, 0.02);
}

/// A free, thin plate that a blow at a corner makes vibrate, its lowest mode at 1.1 kHz in air.
scene::Scene thin_plate() {
  scene::Scene scene = plate_on_springs();
  scene.materials.front().young = 1e8;
  scene.bodies.front().supports.clear();
  scene.pulses.front().place = {.at = Vector3::Zero(), .radius = 0.01, .where = {}};
  scene.pulses.front().force *= 0.01;
  scene.time.steps_per_sample = 42;
  return scene;
}

TEST(CoupledAir, ActsOnAModalBodyAsOnItsFiniteElements) {
  constexpr std::int64_t samples = 400;
  const auto sound = [](const scene::Scene& scene) {
    System system(scene, blocks(scene, Vector3(0.1, 0.1, 0.01), {4, 4, 1}), MPI_COMM_SELF);
    system.start();
    return system.take(samples).front();
  };
  const std::vector<double> expected = sound(thin_plate());
  const std::vector<double> modal = sound(with_modes(thin_plate(), 40));
  double difference = 0.0, square = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    square += expected[i] * expected[i];
    difference += (modal[i] - expected[i]) * (modal[i] - expected[i]);
  }

  EXPECT_LT(std::sqrt(difference / square), 0.01);
}

/// On so many ranks, and from an archive.
void require_the_same_bits(const scene::Scene& scene) {
  constexpr std::int64_t samples = 60;
  System alone = plate(scene, MPI_COMM_SELF);
  alone.start();
  const auto expected = alone.take(samples);

  System system = plate(scene, MPI_COMM_WORLD);
  system.start();
  system.advance(33);
  const Folder folder;
  const auto checkpoint = save(folder, system);
  System resumed = plate(scene, MPI_COMM_WORLD);
  restore(checkpoint, MPI_COMM_WORLD, resumed);
  const auto together = system.take(samples);
  const auto rest = resumed.take(samples);
  if (rank() == 0) {
    EXPECT_NE(expected.at(0), std::vector<double>(samples));
    EXPECT_EQ(together, expected);
    EXPECT_EQ(rest, expected);
  }
}

ON_RANKS(1, 3);

TEST(CoupledAir, HasTheSameBitsOnAnyRanksAndFromAnArchive) {
  require_the_same_bits(plate_on_springs());
}

TEST(CoupledAir, HasTheSameBitsWithAModalBody) {
  require_the_same_bits(with_another_plate(with_modes(plate_on_springs(), 6)));
}

TEST(CoupledAir, RefusesAListenerInTheBox) {
  scene::Scene scene = plate_on_springs();
  scene.listeners.front().receivers.front().position = Vector3(0.05, 0.05, 0.05);
  System system = plate(scene, MPI_COMM_WORLD);
  system.start();
  EXPECT_THAT(error_of([&] { system.advance(1); }), HasSubstr("must not be inside the box"));
}

}  // namespace
}  // namespace idiophone::propagation
