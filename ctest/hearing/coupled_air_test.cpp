// A light, stiff plate on springs, which a blow makes oscillate, in air that takes its energy away.

#include "coupled_air.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "block_mesh.hpp"
#include "checkpointed.hpp"
#include "idiophone/source/finite_element_source.hpp"
#include "stages.hpp"

namespace idiophone::hearing {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

const Vector3 size(0.1, 0.1, 0.03);   // of the plate, m
constexpr double density = 20.0;      // of the plate, kg/m3
constexpr double frequency = 1000.0;  // on its springs, without air, Hz

scene::Scene plate_on_springs() {
  scene::Scene scene;
  scene.name = "plate";
  scene.time.duration = 0.1;
  scene.materials = {{"foam", 5e8, 0.2, density, {}, {}}};
  scene::Body& body = scene.bodies.emplace_back();
  body.name = "plate";
  body.element = element::tet10;
  const Vector3 below(size[0] / 2, size[1] / 2, 0.0), above(size[0] / 2, size[1] / 2, size[2]);
  body.supports.push_back({.name = "springs",
                           .place = {.at = below, .radius = 0.1, .where = {}},
                           .stiffness = density * size.prod() * std::pow(2.0 * std::numbers::pi * frequency, 2)});
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

/// The plate on the ranks of a communicator, coupled to its air.
class System {
 public:
  System(const scene::Scene& scene, MPI_Comm communicator)
      : communicator_(communicator),
        ready_(source::prepare(scene, meshes(communicator), communicator)),
        source_(ready_, stages(), communicator),
        air_(ready_.scene, source_.surface(), source_.first_sample(), stages(), communicator),
        emission_(padded_emission(source_.surface().triangles.size())) {
    source_.couple(air_);
  }

  void start() {
    source_.start(motion_);
    air_.start(source_.first_sample(), motion_);
  }

  void advance(std::int64_t samples) {
    for (std::int64_t i = 0; i < samples; ++i) {
      source_.advance(motion_);
      air_.propagate(source_.first_sample() + ++advanced_, emission_, motion_);
    }
  }

  void archive(parallel::Archive& archive) {
    archive.root("advanced", advanced_);
    source_.archive(archive);
    air_.archive(archive);
  }

  /// Audio samples of sound, on rank 0.
  std::vector<std::vector<double>> take(std::int64_t samples) {
    advance(samples - air_.final_before(0) - source_.first_sample() - advanced_);
    return air_.take(samples);
  }

  source::FiniteElementSource& source() { return source_; }
  [[nodiscard]] const WaveGrid& grid() const { return air_.grid(); }
  [[nodiscard]] const scene::Scene& scene() const { return ready_.scene; }

 private:
  static std::vector<mesh::Mesh> meshes(MPI_Comm communicator) {
    if (!parallel::is_root(communicator)) {
      return {};
    }
    return {support::block_mesh(element::tet10, size, {3, 3, 1})};
  }
  static surface::Emission padded_emission(std::size_t triangles) {
    surface::Emission emission;
    emission.resize(padded(triangles));
    return emission;
  }

  MPI_Comm communicator_;
  source::Preparation ready_;
  source::FiniteElementSource source_;
  CoupledAir air_;
  surface::SurfaceMotion motion_;
  surface::Emission emission_;
  std::int64_t advanced_ = 0;
};

/// Energy that leaves through the box around the plate, on one rank.
class EnergyFlow {
 public:
  explicit EnergyFlow(const System& system)
      : period_(1.0 / system.scene().audio.rate),
        density_(system.scene().radiation.air.density),
        box_(system.grid().field().slab(), system.grid().plan().enclosure),
        gradient_(box_.patches()),
        velocity_(box_.patches()) {}

  /// Adds what left in the last audio sample.
  void add(const System& system) {
    const surface::Emission& air = box_.emission(system.grid().field());
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

TEST(CoupledAir, TakesTheEnergyThatLeavesThroughTheBox) {
  if (ranks() > 1) {
    GTEST_SKIP() << "one rank suffices";
  }
  System system(plate_on_springs(), MPI_COMM_SELF);
  system.start();
  EnergyFlow flow(system);
  for (int sample = 0; sample < 1250; ++sample) {
    system.advance(1);
    flow.add(system);
  }
  const source::Observation seen = system.source().observe_now();
  EXPECT_LT(seen.kinetic() + seen.elastic(), 0.01 * seen.work);
  EXPECT_NEAR(flow.energy() / seen.work, 1.0, 0.02);
}

TEST(CoupledAir, HasTheSameBitsOnAnyRanksAndFromAnArchive) {
  constexpr std::int64_t samples = 60;
  const scene::Scene scene = plate_on_springs();
  System alone(scene, MPI_COMM_SELF);
  alone.start();
  const auto expected = alone.take(samples);

  System system(scene, MPI_COMM_WORLD);
  system.start();
  system.advance(33);
  const Folder folder;
  const auto checkpoint = save(folder, system);
  System resumed(scene, MPI_COMM_WORLD);
  restore(checkpoint, MPI_COMM_WORLD, resumed);
  const auto together = system.take(samples);
  const auto rest = resumed.take(samples);
  if (rank() == 0) {
    EXPECT_NE(expected.at(0), std::vector<double>(samples));
    EXPECT_EQ(together, expected);
    EXPECT_EQ(rest, expected);
  }
}

TEST(CoupledAir, RefusesAListenerInTheBox) {
  scene::Scene scene = plate_on_springs();
  scene.listeners.front().receivers.front().position = Vector3(0.05, 0.05, 0.05);
  System system(scene, MPI_COMM_WORLD);
  system.start();
  EXPECT_THAT(error_of([&] { system.advance(1); }), HasSubstr("must not be inside the box"));
}

}  // namespace
}  // namespace idiophone::hearing
