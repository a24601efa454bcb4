// The pieces that a body falls apart into: which hang together, and how each moves.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breakable.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

using ::testing::ElementsAre;

ON_RANKS(1);

TEST(Pieces, CrossingSurfacesBreakIntoFourPieces) {
  for (const element::Type element : all_elements) {
    SCOPED_TRACE(element::name(element));
    Laboratory lab = breakable(support::block_mesh(element, {0.08, 0.08, 0.02}, {4, 4, 1}),
                               {across_x(0.04), across_y(0.04)}, brittle(10.0));
    lab.begin(bar_step);
    EXPECT_THAT(lab.motion->dynamics().fractures()[0].joined_pieces(), ElementsAre(1, 1, 1, 1));
    std::vector<double> rows;
    for (const Vector3& node : lab.mesh.nodes) {
      const Vector3 velocity = Vector3(0.1, 0.1, 0).cwiseProduct(node - Vector3(0.04, 0.04, 0)) / 0.04;
      rows.insert(rows.end(), {0, 0, 0, velocity.x(), velocity.y(), 0});
    }
    lab.put(rows);
    lab.advance(1000);
    EXPECT_NEAR(broken_area(lab), 2 * 0.08 * 0.02, 1e-12);
    EXPECT_THAT(lab.motion->dynamics().fractures()[0].joined_pieces(), ElementsAre(1, 2, 3, 4));
    for (const mesh::FractureFace& face : lab.mesh.fracture_faces) {
      for (std::size_t k = 0; k < face.shares.size(); ++k) {
        EXPECT_GT((lab.displacement(face.nodes[0][k]) - lab.displacement(face.nodes[1][k])).norm(), 1e-4);
      }
    }
  }
}

TEST(Pieces, PiecesHangTogetherOverOthers) {
  Laboratory lab = breakable(support::block_mesh(element::tet10, {0.09, 0.02, 0.02}, {6, 1, 1}),
                             {across_x(0.03), across_x(0.06)}, brittle(never));
  lab.scene.bodies[0].fracture[1].strength = 10.0;
  lab.begin(bar_step);
  lab.put(rows_of(lab, [](double x) { return std::array{0.0, 0.1 * (x - 0.045)}; }));
  lab.advance(100);
  const auto joined = lab.motion->dynamics().fractures()[0].joined_pieces();
  // The pieces on both sides of the strong surface are still one; their numbers depend on the curve through the mesh.
  const auto piece_at = [&](double x) {
    const auto near = [&](const Vector3& node) { return std::abs(node.x() - x) < 0.01; };
    return lab.mesh.pieces[std::ranges::find_if(lab.mesh.nodes, near) - lab.mesh.nodes.begin()];
  };
  EXPECT_EQ(joined[piece_at(0.0)], joined[piece_at(0.045)]);
  EXPECT_NE(joined[piece_at(0.045)], joined[piece_at(0.09)]);
  EXPECT_EQ(*std::ranges::min_element(joined), 1);
}

/// The motion of a piece by the states of its nodes alone.
struct Sums {
  double mass = 0.0;
  Vector3 centre = Vector3::Zero(), momentum = Vector3::Zero(), angular_momentum = Vector3::Zero();
};
Sums sums_of(const Laboratory& lab, Index piece) {
  const auto masses = lab.motion->dynamics().model(0).masses();
  const auto for_each_node = [&](auto visit) {
    for (std::size_t node = 0; node < masses.size(); ++node) {
      if (lab.mesh.pieces[node] == piece) {
        visit(masses[node], lab.mesh.nodes[node] + lab.displacement(node), Vector3(lab.motion->state()[node].velocity));
      }
    }
  };
  Sums sums;
  for_each_node([&](double mass, const Vector3& place, const Vector3& velocity) {
    sums.mass += mass;
    sums.centre += mass * place;
    sums.momentum += mass * velocity;
  });
  sums.centre /= sums.mass;
  for_each_node([&](double mass, const Vector3& place, const Vector3& velocity) {
    sums.angular_momentum += mass * (place - sums.centre).cross(velocity);
  });
  return sums;
}

// The block spins, and breaks under its centrifugal forces.
TEST(Pieces, EachPieceHasItsOwnMotion) {
  Laboratory lab = breakable(support::block_mesh(element::tet10, {0.09, 0.04, 0.02}, {6, 2, 1}),
                             {across_x(0.03), across_y(0.02)}, brittle(800.0));
  lab.scene.bodies[0].spin = {1, 2, 40};
  lab.scene.bodies[0].velocity = {3, 2, 1};
  lab.begin(bar_step);
  ASSERT_EQ(lab.initial_state.pieces.size(), 4U);
  const auto motion_of_piece = [&](std::size_t piece) {
    return piece_motion(measure(*lab.motion, lab.initial_state)[1 + piece], lab.initial_state, piece);
  };
  for (std::size_t piece = 0; piece < 4; ++piece) {  // as parts of the rigid body
    const BodyMotion seen = motion_of_piece(piece);
    const Vector3 arm = lab.initial_state.pieces[piece].centre - lab.initial_state.centres[0];
    EXPECT_LT((seen.velocity - Vector3(3, 2, 1) - Vector3(1, 2, 40).cross(arm)).norm(), 1e-12);
    EXPECT_LT((seen.angular_velocity - Vector3(1, 2, 40)).norm(), 1e-9);
    EXPECT_LT((seen.centre - lab.initial_state.pieces[piece].centre).norm(), 1e-15);
  }
  lab.advance(4000);
  EXPECT_GT(broken_area(lab), 0.0);
  Vector3 momentum = Vector3::Zero();
  double energy = 0.0;
  for (std::size_t piece = 0; piece < 4; ++piece) {
    const BodyMotion seen = motion_of_piece(piece);
    const Sums expected = sums_of(lab, static_cast<Index>(piece));  // its velocities are half a step older
    EXPECT_NEAR(lab.initial_state.pieces[piece].mass, expected.mass, 1e-12 * expected.mass);
    EXPECT_LT((seen.centre - expected.centre).norm(), 1e-14);
    EXPECT_LT((seen.velocity - expected.momentum / expected.mass).norm(), 1e-3);
    EXPECT_LT((seen.angular_momentum - expected.angular_momentum).norm(), 1e-3 * expected.angular_momentum.norm());
    momentum += lab.initial_state.pieces[piece].mass * seen.velocity;
    energy += seen.kinetic + seen.elastic;
  }
  const BodyMotion whole = lab.observe();
  EXPECT_LT((momentum - lab.initial_state.masses[0] * whole.velocity).norm(), 1e-13 * momentum.norm());
  EXPECT_NEAR(energy, whole.kinetic + whole.elastic, 1e-13 * energy);
}

}  // namespace
}  // namespace idiophone::motion
