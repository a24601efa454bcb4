// A surface whose vertices are moved by an accelerator sounds as that of the processor. Any OpenCL device will do.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "idiophone/air/surface/accelerated_surface.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

ON_RANKS(1);

/// A strip of triangles whose vertices all move in ways of their own, and turn far.
class AcceleratedSurfaceTest : public ::testing::Test {
 protected:
  static constexpr int vertices = 21;

  void SetUp() override {
    try {
      accelerator = std::make_unique<accelerator::Accelerator>("0");
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
    for (int vertex = 0; vertex < vertices; ++vertex) {
      reference.emplace_back(0.01 * vertex, 0.02 * (vertex % 2), 0.001 * (vertex % 3));
      if (vertex >= 2) {
        triangles.push_back({vertex - 2, vertex - 1, vertex});
      }
    }
  }

  static double displacement(int vertex, int axis, int read) {
    return 0.004 * std::sin(0.11 * read + 0.9 * vertex + axis) + 1e-4 * read * (axis - 1);
  }
  void displace(Surface& surface, int read) const {
    for (int i = 0; i < 3 * vertices; ++i) {
      surface.displacements()[i] = displacement(i / 3, i % 3, read);
    }
  }
  /// Two groups of vertices, of bodies whose nodes have another order.
  void displace(AcceleratedSurface& there, int read) {
    constexpr int first = 8;
    std::vector<double> of_nodes(4 * vertices, 1e9);
    std::vector<Index> nodes;
    for (int vertex = 0; vertex < vertices; ++vertex) {
      nodes.push_back(vertices - 1 - vertex);
      for (int axis = 0; axis < 3; ++axis) {
        of_nodes[4 * nodes[vertex] + axis] = displacement(vertex, axis, read);
      }
    }
    const accelerator::Array<double> all(*accelerator, std::span<const double>(of_nodes));
    const std::span<const Index> numbers(nodes);
    there.displace(0, {*accelerator, numbers.first(first)}, all);
    there.displace(first, {*accelerator, numbers.subspan(first)}, all);
  }
  /// One audio sample of each.
  void advance(Surface& surface, SurfaceMotion& motion, int sample) {
    for (int read = 0; read < surface.sampling().reads_per_sample(); ++read) {
      displace(surface, sample * surface.sampling().reads_per_sample() + read + 1);
      surface.read();
    }
    surface.take(motion);
  }
  void advance(AcceleratedSurface& there, SurfaceMotion& motion, int sample, int reads) {
    for (int read = 0; read < reads; ++read) {
      displace(there, sample * reads + read + 1);
      there.read();
    }
    there.take(motion);
  }
  static void expect_same(const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 1e-11 * (1.0 + std::abs(expected[i]))) << i;
    }
  }

  std::unique_ptr<accelerator::Accelerator> accelerator;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Vector3> reference;
};

class SamplingsOnAccelerator : public AcceleratedSurfaceTest, public ::testing::WithParamInterface<Sampling> {};

TEST_P(SamplingsOnAccelerator, EmitsWhatTheProcessorDoesAlsoInTurns) {
  const int reads = GetParam().reads_per_sample();
  Surface expected(triangles, reference, GetParam()), state(triangles, reference, GetParam());
  SurfaceMotion of_processor, found;
  displace(expected, 0);
  displace(state, 0);
  const std::vector<double> velocities(3 * vertices, 2.0);
  expected.start(velocities);
  state.start(velocities);
  AcceleratedSurface there(*accelerator, triangles, state);
  there.load();
  for (int sample = 0; sample < 20; ++sample) {
    advance(expected, of_processor, sample);
    if (sample >= 9 && sample < 12) {
      advance(state, found, sample);  // goes on from what is saved, and back
    } else {
      advance(there, found, sample, reads);
    }
    expect_same(found.pressure, of_processor.pressure);
    expect_same(found.position, of_processor.position);
    if (sample == 8) {
      there.save();
    } else if (sample == 11) {
      there.load();
    }
  }
}

// Fewer reads in an audio sample than are held, as many, and more.
INSTANTIATE_TEST_SUITE_P(Reads, SamplingsOnAccelerator,
                         ::testing::Values(Sampling{.steps_per_sample = 6, .steps_per_read = 1},
                                           Sampling{.steps_per_sample = 8, .steps_per_read = 1},
                                           Sampling{.steps_per_sample = 42, .steps_per_read = 2}));

TEST_F(AcceleratedSurfaceTest, IsTakenAfterAllReadsOfAnAudioSample) {
  Surface surface(triangles, reference, {});
  surface.start();
  AcceleratedSurface there(*accelerator, triangles, surface);
  SurfaceMotion motion;
  EXPECT_THROW(there.take(motion), std::logic_error);
}

}  // namespace
}  // namespace idiophone::surface
