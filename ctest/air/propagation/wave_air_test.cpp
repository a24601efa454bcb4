// A cube that pulsates on a grid: where it is small compared with the waves, p = S P'(t - R/c)/(4 pi R c), with its
// surface S and P = z v.

#include "wave_air.hpp"
#include "idiophone/scene/scene.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "checkpointed.hpp"
#include "ranks.hpp"
#include "stages.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;
using ::testing::HasSubstr;

constexpr double edge = 0.04;  // of the cube, m
constexpr double cube_area = 6 * edge * edge;
constexpr double peak = 5.0;     // of P, Pa
constexpr double width = 5e-4;   // of the pulse, s
constexpr double middle = 3e-3;  // of the pulse, s
constexpr std::int64_t steady_sample = -2;
constexpr std::size_t heard_samples = 70;

/// The cube about the origin, its triangles dealt to so many ranks.
propagation::AudibleSurface cube(int rank, int ranks) {
  propagation::AudibleSurface surface;
  surface.bodies = {"cube"};
  surface.first_triangle = {0, 12};
  surface.first_vertex = {0, 8};
  for (Index vertex = 0; vertex < 8; ++vertex) {
    surface.vertex_ids.push_back(vertex);
    surface.reference.emplace_back(edge * ((vertex & 1) - 0.5), edge * ((vertex >> 1 & 1) - 0.5),
                                   edge * ((vertex >> 2 & 1) - 0.5));
  }
  Index number = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Index along = 1 << axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const auto& triangle : {mesh::Triangle{along, along + u, along + u + v},
                                 {along, along + u + v, along + v},
                                 {0, u + v, u},
                                 {0, v, u + v}}) {
      if (number++ % ranks == rank) {
        surface.triangle_ids.push_back(number - 1);
        surface.triangles.push_back(triangle);
      }
    }
  }
  return surface;
}

class WaveAirTest : public ::testing::Test {
 protected:
  WaveAirTest() {
    scene_.audio.rate = 8000;
    scene_.audio.dc_loss = 0.1;
    scene_.radiation.model = scene::RadiationModel::waves;
    scene_.radiation.grid.cell = 0.01;
    scene_.radiation.visibility.reset();
  }

  void listen_at(const Vector3& place) {
    auto& listener = scene_.listeners.emplace_back();
    listener.name = "ear";
    listener.receivers.push_back({.channel = "ear", .position = place});
  }

  /// What a microphone at a distance should hear in an audio sample, Pa.
  [[nodiscard]] double exact(double distance, double sample) const {
    const double x = (sample / scene_.audio.rate - distance / scene_.radiation.air.speed - middle) / width;
    return -cube_area * peak * x * std::exp(-0.5 * x * x) / width /
           (4.0 * std::numbers::pi * distance * scene_.radiation.air.speed);
  }

  [[nodiscard]] static surface::SurfaceMotion motion(const propagation::AudibleSurface& surface, double shift) {
    surface::SurfaceMotion motion;
    motion.pressure.resize(padded(surface.triangles.size()));
    for (const Vector3& vertex : surface.reference) {
      motion.position.insert(motion.position.end(), {vertex[0] + shift, vertex[1], vertex[2]});
    }
    motion.position.resize(surface::SurfaceMotion::position_length(surface.reference.size()));
    return motion;
  }

  /// Audio samples from `begin` to before `end`, in which the cube moves along x, m/s.
  void propagate(WaveAir& air, const propagation::AudibleSurface& surface, std::int64_t begin, std::int64_t end,
                 double speed = 0.0) const {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      const double time = static_cast<double>(sample) / scene_.audio.rate;
      surface::Emission emission;
      emission.resize(padded(surface.triangles.size()));
      const double x = (time - middle) / width;
      std::fill_n(emission.pressure.begin(), surface.triangles.size(), peak * std::exp(-0.5 * x * x));
      air.propagate(sample, emission, motion(surface, speed * time));
    }
  }

  /// What all listeners hear of the cube on the ranks of a communicator; nothing on other ranks than 0.
  [[nodiscard]] std::vector<std::vector<double>> hear(MPI_Comm communicator, double speed = 0.0,
                                                      accelerator::Accelerator* accelerator = nullptr) const {
    const auto surface = cube(parallel::rank_of(communicator), parallel::size_of(communicator));
    WaveAir air(scene_, surface, steady_sample, stages(), communicator, accelerator);
    air.start(steady_sample, motion(surface, 0.0));
    const std::int64_t end = heard_samples - air.final_before(0) + 1;
    propagate(air, surface, steady_sample + 1, end, speed);
    return air.take(heard_samples);
  }

  scene::Scene scene_;
};

/// Largest difference over the largest value.
double error(const std::vector<double>& heard, const std::function<double(double)>& exact) {
  double largest = 0.0, wrong = 0.0;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    largest = std::max(largest, std::abs(exact(static_cast<double>(i))));
    wrong = std::max(wrong, std::abs(heard[i] - exact(static_cast<double>(i))));
  }
  return wrong / largest;
}

ON_RANKS(1, 3);

TEST_F(WaveAirTest, IsHeardOutsideTheGridAndInside) {
  listen_at(Vector3(0.6, -0.5, 0.4));
  listen_at(Vector3(0.03, 0.031, -0.029));
  const auto heard = hear(MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_LT(error(heard.at(0), [&](double sample) { return exact(std::sqrt(0.77), sample); }), 0.04);
    EXPECT_LT(error(heard.at(1), [&](double sample) { return exact(0.052, sample); }), 0.1);
  }
}

TEST_F(WaveAirTest, ReflectsFromTheFloor) {
  scene_.radiation.floor = {.at = Vector3(0, 0, -0.05), .direction = Vector3::UnitZ(), .reflection = 1.0};
  listen_at(Vector3(0.8, 0.0, -0.05));
  const auto heard = hear(MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_LT(error(heard.at(0), [&](double sample) { return 2.0 * exact(std::hypot(0.8, 0.05), sample); }), 0.05);
  }
}

TEST_F(WaveAirTest, IsHeardAlikeFromAnAccelerator) {
  std::unique_ptr<accelerator::Accelerator> accelerator;
  try {
    accelerator = std::make_unique<accelerator::Accelerator>("0");
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  scene_.radiation.grid.margin = 0.02;
  listen_at(Vector3(0.6, -0.5, 0.4));
  listen_at(Vector3(0.03, 0.031, -0.029));
  const auto expected = hear(MPI_COMM_WORLD, 1.0), heard = hear(MPI_COMM_WORLD, 1.0, accelerator.get());
  for (std::size_t ear = 0; rank() == 0 && ear < heard.size(); ++ear) {
    EXPECT_LT(error(heard[ear], [&](double sample) { return expected[ear][static_cast<std::size_t>(sample)]; }), 1e-5);
  }
}

TEST_F(WaveAirTest, HasTheSameBitsOnAnyRanksAndFromAnArchive) {
  scene_.radiation.grid.margin = 0.02;
  listen_at(Vector3(0.6, -0.5, 0.4));
  constexpr double speed = 1.5;  // m/s
  const auto alone = hear(MPI_COMM_SELF, speed);
  const auto together = hear(MPI_COMM_WORLD, speed);

  const Folder folder;
  const auto surface = cube(rank(), ranks());
  const auto make = [&] { return WaveAir(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD); };
  WaveAir air = make();
  air.start(steady_sample, motion(surface, 0.0));
  propagate(air, surface, steady_sample + 1, 33, speed);
  const auto checkpoint = save(folder, air);
  WaveAir resumed = make();
  restore(checkpoint, MPI_COMM_WORLD, resumed);
  propagate(resumed, surface, 33, heard_samples - resumed.final_before(0) + 1, speed);
  const auto rest = resumed.take(heard_samples);
  if (rank() == 0) {
    EXPECT_EQ(together, alone);
    EXPECT_EQ(rest, alone);
  }
}

TEST_F(WaveAirTest, SoundsTheSameWhileTheBodyMoves) {
  scene_.radiation.grid.margin = 0.02;
  listen_at(Vector3(0.0, 0.0, 0.8));
  const auto at_rest = hear(MPI_COMM_WORLD);
  const auto moving = hear(MPI_COMM_WORLD, 1.5);
  if (rank() == 0) {
    EXPECT_LT(error(moving.at(0), [&](double sample) { return at_rest.at(0)[static_cast<std::size_t>(sample)]; }),
              0.02);
  }
}

TEST_F(WaveAirTest, RefusesABodyThatLeavesTheGrid) {
  listen_at(Vector3(0.6, -0.5, 0.4));
  EXPECT_THAT(error_of([&] { static_cast<void>(hear(MPI_COMM_WORLD, 20.0)); }), HasSubstr("a body leaves the grid"));
}

}  // namespace
}  // namespace idiophone::propagation
