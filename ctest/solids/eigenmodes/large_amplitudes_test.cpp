// Modal bodies with large amplitudes against finite elements of the same mesh.

#include <gmock/gmock.h>

#include <numbers>

#include "memory_archive.hpp"
#include "moving.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double strip_thickness = 0.001;

/// A strip that is held at both ends, and pushed for the first eighth of its period.
Moving strip(double stretching_tolerance) {
  Moving moving(block(element::hex(3, 2), {0.1, 0.02, strip_thickness}, {4, 1, 1}), 9, stretching_tolerance);
  moving.body.fix("x0");
  moving.body.fix("x1");
  auto& middle = moving.body.mesh.groups["middle"];
  for (Index node = 0; node < static_cast<Index>(moving.body.mesh.nodes.size()); ++node) {
    if (std::abs(moving.body.mesh.nodes[node][0] - 0.05) < 1e-6) {
      middle.push_back(node);
    }
  }
  moving.push("middle", {0, 0, 120}, 3e-4);
  moving.prepare();
  return moving;
}

/// Largest displacement of a node, m.
double amplitude(Moving& moving, int steps) {
  const auto motion = moving.begin(2e-6, moving.basis);
  double largest = 0.0;
  for (int n = 0; n < steps; ++n) {
    motion->advance();
    motion->update_nodes();
    for (const auto& node : motion->state()) {
      largest = std::max(largest, std::abs(node.displacement[2]));
    }
  }
  return largest;
}

ON_RANKS(1);

TEST(LargeAmplitudes, StripSoundsLikeItsFiniteElements) {
  Moving large = strip(1e-3);
  const double amount = amplitude(large, 750) / strip_thickness;
  EXPECT_GT(amount, 0.8);
  EXPECT_LT(amount, 1.5);
  // The pitch has risen by more than a fifth, so a linear body would be off by half a period at the end.
  const double period = 2 * std::numbers::pi / large.basis[0].frequencies[0];
  EXPECT_LT(difference(large, 0, 2.5 * period, 5e-8, 40), 0.03);
}

TEST(LargeAmplitudes, EnergyComesFromThePulse) {
  Moving moving = strip(1e-3);
  const auto motion = moving.begin(1e-6, moving.basis);
  for (int n = 0; n < 2000; ++n) {
    motion->advance();
  }
  const motion::BodyMotion now = moving.observe(*motion);
  EXPECT_NEAR((now.kinetic + now.elastic) / motion->work().value(), 1.0, 0.01);
}

TEST(LargeAmplitudes, GoesOnFromASavedStateToTheBit) {
  Moving moving = strip(1e-3);
  const auto motion = moving.begin(2e-6, moving.basis, 4);
  const auto other = moving.begin(2e-6, moving.basis, 4);
  const auto advance_to = [](motion::Motion& body, std::int64_t end) {
    while (body.step_number() < end) {
      body.advance();
    }
  };
  const auto saved = [](motion::Motion& body) {
    support::MemoryArchive state(MPI_COMM_SELF);
    body.archive(state, body.step_number());
    return state.blocks;
  };
  advance_to(*motion, 400);
  support::MemoryArchive archive(MPI_COMM_SELF);
  motion->archive(archive, 400);
  archive.restore();
  other->archive(archive, 400);
  advance_to(*motion, 800);
  advance_to(*other, 800);
  EXPECT_EQ(saved(*motion), saved(*other));
}

}  // namespace
}  // namespace idiophone::eigenmodes
