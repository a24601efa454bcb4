// A body in contact with itself: against two bodies of the same shape, and on a strip whose ends meet.

#include <gtest/gtest.h>

#include <cmath>

#include "cell_neighbours.hpp"
#include "overlapping_blocks.hpp"
#include "parts.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

/// Bonds of friction are as soft as the largest depth of all nodes of a side: of one body, that is of both pieces.
scene::Contact damped() {
  scene::Contact contact;
  contact.damping = 1e-4;
  return contact;
}

constexpr double layer = 1e6;       // Pa/m
constexpr double time_step = 1e-5;  // s

/// The skins of two blocks as that of one body in two pieces.
Skin united(const Block& first, const Block& second) {
  const auto nodes = static_cast<Index>(first.skin.nodes.size());
  Skin skin = first.skin;
  skin.areas.insert(skin.areas.end(), second.skin.areas.begin(), second.skin.areas.end());
  skin.exterior.insert(skin.exterior.end(), second.skin.exterior.begin(), second.skin.exterior.end());
  for (std::array<Index, 4> cell : second.skin.cells) {
    std::ranges::for_each(cell, [&](Index& node) { node += nodes; });
    skin.cells.push_back(cell);
  }
  skin.nodes.resize(skin.areas.size());
  std::iota(skin.nodes.begin(), skin.nodes.end(), 0);
  return skin;
}

std::vector<Index> all_cells(const Skin& skin) {
  std::vector<Index> all(skin.cells.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Two blocks that press on each other along z, as one body.
struct TwoPieces {
  TwoPieces()
      : upper(
            element::tet4, {0.7, 0.8, 0.5}, {2, 1, 1},
            [shake = Shaker(0.02)](const Vector3& x) mutable { return Vector3(shake(x) + Vector3(0.13, 0.11, 0.45)); }),
        lower(element::tet4, {1, 1, 0.5}, {2, 2, 1}, Shaker(0.02)),
        skin(united(upper, lower)),
        side(skin),
        interaction({}, layer, time_step, side, side) {
    turn(Eigen::Matrix3d::Identity());
    interaction.choose_candidates(all_cells(skin), all_cells(skin), 1.0);
    compute(interaction);
  }

  /// Puts both where they are after a turn from the beginning.
  void turn(const Eigen::Matrix3d& rotation) {
    std::size_t place = 0;
    for (const Block* block : {&upper, &lower}) {
      for (const Vector3& x : block->side.position) {
        side.position[place++] = rotation * x;
      }
    }
  }

  Block upper;
  Block lower;
  Skin skin;
  Side side;
  Interaction interaction;
};

Eigen::Matrix3d rotation(double degrees, const Vector3& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
}

/// A strip of 12 cells along x, bent to a ring by more than one turn: its ends lie in each other.
Vector3 on_ring(const Vector3& x) {
  const double radius = 2.0 + x.z();
  const double angle = 1.05 * 2 * M_PI * x.x() / 12;
  return {radius * std::sin(angle), x.y(), radius * std::cos(angle)};
}

struct Ring {
  Ring()
      : strip(element::tet4, {12, 1, 0.5}, {24, 2, 1},
              [shake = Shaker(0.01)](const Vector3& x) mutable { return shake(on_ring(x)); }),
        interaction({}, layer, time_step, strip.side, strip.side) {
    interaction.choose_candidates(strip.cells(), strip.cells(), 0.05);
    compute(interaction);
  }
  Block strip;
  Interaction interaction;
};

ON_RANKS(1);

TEST(SelfContact, OfTwoPiecesIsThatOfTwoBodies) {
  Block upper(element::tet10, {0.7, 0.8, 0.5}, {2, 1, 1}, [shake = Shaker(0.02)](const Vector3& x) mutable {
    return Vector3(shake(x) + Vector3(0.33, 0.41, 0.45));
  });
  Block lower(element::tet4, {1, 1, 0.5}, {2, 2, 1}, Shaker(0.02));
  const Skin skin = united(upper, lower);
  Side both(skin);
  std::size_t place = 0;
  for (Side* side : {&upper.side, &lower.side}) {
    for (std::size_t node = 0; node < side->position.size(); ++node, ++place) {
      side->velocity[node] = Vector3(side == &upper.side ? 1 : 0, 2, -1) + 0.1 * side->position[node];
      both.position[place] = side->position[node];
      both.velocity[place] = side->velocity[node];
    }
  }
  Interaction of_two(damped(), layer, time_step, upper.side, lower.side);
  of_two.choose_candidates(upper.cells(), lower.cells(), 1.0);
  compute(of_two, BondUpdate::stretch);
  Interaction of_one(damped(), layer, time_step, both, both);
  of_one.choose_candidates(all_cells(skin), all_cells(skin), 1.0);
  compute(of_one, BondUpdate::stretch);

  ASSERT_GT(of_two.energy(), 0.0);
  EXPECT_NEAR(of_one.energy(), of_two.energy(), 1e-13 * of_two.energy());
  const double scale = of_two.motion().force.norm();
  place = 0;
  for (const Side* side : {&upper.side, &lower.side}) {
    for (std::size_t node = 0; node < side->position.size(); ++node, ++place) {
      EXPECT_NEAR((both.force[place] - side->force[node]).norm(), 0.0, 1e-13 * scale);
    }
  }
  // The upper block is the one that the contact presses towards larger x + y/2 + z/4.
  EXPECT_NEAR((of_one.motion().force - of_two.motion().force).norm(), 0.0, 1e-13 * scale);
  EXPECT_GT(of_one.motion().force.z(), 0.0);
  EXPECT_NEAR(of_one.motion().overlap, of_two.motion().overlap, 1e-15);
}

TEST(SelfContact, ReportsTheForceOnTheSamePartWhileABodyTurns) {
  for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(1, 2, 0.5)}) {
    TwoPieces body;
    const Vector3 force = body.interaction.motion().force, normal = body.interaction.motion().normal;
    ASSERT_GT(force.z(), 0.9 * force.norm());
    for (int degrees = 0; degrees < 360; degrees += 5) {
      const Eigen::Matrix3d turned = rotation(degrees, axis);
      body.turn(turned);
      compute(body.interaction);
      ASSERT_LT((body.interaction.motion().force - turned * force).norm(), 1e-9 * force.norm()) << degrees;
      ASSERT_LT((body.interaction.motion().normal - turned * normal).norm(), 1e-9) << degrees;
    }
  }
}

TEST(SelfContact, ReportsOneOfTwoForcesByTheDirectionInWhichTheTouchBegins) {
  TwoPieces body;
  const Vector3 force = body.interaction.motion().force;
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Eigen::Matrix3d turned = rotation(degrees, {0.2, 1, 0});
    const double sign = (turned * force).dot(towards_first) > 0 ? 1 : -1;
    body.interaction.release();
    body.turn(turned);
    body.interaction.choose_candidates(all_cells(body.skin), all_cells(body.skin), 1.0);
    compute(body.interaction);
    ASSERT_LT((body.interaction.motion().force - sign * turned * force).norm(), 1e-9 * force.norm()) << degrees;
  }
}

TEST(SelfContact, OfAStripActsWhereItsEndsMeet) {
  Ring ring;
  ASSERT_GT(ring.interaction.energy(), 0.0);
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  double scale = 0.0;
  for (const Index node : ring.strip.side.touched) {
    const Vector3& force = ring.strip.side.force[node];
    const double along = ring.strip.mesh.nodes[ring.strip.skin.nodes[node]].x();
    EXPECT_GT(std::abs(along - 6), 4.0);
    sum += force;
    moment += ring.strip.side.position[node].cross(force);
    scale += force.norm();
  }
  EXPECT_LT(sum.norm(), 1e-13 * scale);
  EXPECT_LT(moment.norm(), 1e-12 * scale);
}

TEST(SelfContact, ForceIsTheGradientOfTheEnergy) {
  Ring ring;
  Side& side = ring.strip.side;
  const std::vector<Index> touched = side.touched;
  const std::vector<Vector3> force = side.force;
  double largest = 0.0;
  for (const Index node : touched) {
    largest = std::max(largest, force[node].norm());
  }
  ASSERT_GT(largest, 0.0);
  for (const Index node : touched) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double small = 1e-6;
      double& x = side.position[node][axis];
      const double before = x;
      x = before + small;
      compute(ring.interaction);
      const double above = ring.interaction.energy();
      x = before - small;
      compute(ring.interaction);
      const double below = ring.interaction.energy();
      x = before;
      EXPECT_NEAR(force[node][axis], -(above - below) / (2 * small), 1e-6 * largest);
    }
  }
}

TEST(SelfContact, OfABodyInItsShapeHasNoForce) {
  for (const element::Type element : {element::tet4, element::tet10, element::hex(3, 2)}) {
    Block block(element, {4, 2, 1}, {8, 4, 2}, [](const Vector3& x) { return x; });
    Interaction interaction({}, layer, time_step, block.side, block.side);
    interaction.choose_candidates(block.cells(), block.cells(), 0.01);
    compute(interaction);
    EXPECT_EQ(interaction.energy(), 0.0);
    EXPECT_TRUE(block.side.touched.empty());
  }
}

TEST(CellNeighbours, ShareANodeOrANeighbour) {
  const Block strip(element::tet4, {12, 1, 1}, {12, 1, 1}, [](const Vector3& x) { return x; });
  CellNeighbours neighbours(strip.skin);
  const auto column = [&](Index cell) {
    double middle = 0.0;
    for (const Index node : strip.skin.cells[cell]) {
      middle += strip.side.position[node].x() / 4;
    }
    return static_cast<int>(middle);
  };
  for (const Index cell : strip.cells()) {
    neighbours.look_from(cell);
    for (const Index other : strip.cells()) {
      const int apart = std::abs(column(cell) - column(other));
      if (apart != 2) {  // there it depends on how the cells are cut
        EXPECT_EQ(neighbours.is_near(other), apart < 2) << cell << ' ' << other;
      }
    }
  }
}

}  // namespace
}  // namespace idiophone::contact
