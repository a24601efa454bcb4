// Where bodies and listeners may stand.

#include "idiophone/air/propagation/placement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Adds a cuboid between two corners, in two triangles a side.
void add_cuboid(Surroundings& around, const std::string& name, const Vector3& low, const Vector3& high) {
  std::vector<Vector3> nodes;
  for (const int i : {0, 1, 2, 3, 4, 5, 6, 7}) {
    nodes.emplace_back((i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
                       (i & 4) != 0 ? high[2] : low[2]);
  }
  const std::vector<mesh::Triangle> faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                             {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  around.add(name, nodes, faces);
}

/// A cube with edges of 0.1 m around the origin, a wall from x = 0.5 to 0.6 m, and one listener.
class Placement : public testing::Test {
 protected:
  Placement() {
    scene.bodies.emplace_back().name = "cube";
    scene.bodies.front().where = {"cube.yaml", 3, 1};
    add_cuboid(around, "cube", Vector3::Constant(-0.05), Vector3::Constant(0.05));
    add_cuboid(around, "wall", {0.5, -2, -2}, {0.6, 2, 2});
    around.bodies = 1;
    scene.listeners.emplace_back().name = "ear";
    scene.listeners.front().where = {"cube.yaml", 7, 1};
    scene.listeners.front().receivers.emplace_back().channel = "ear";
  }

  std::vector<std::string> warnings(const Vector3& listener, Hearing hearing = Hearing::straight_ways) {
    scene.listeners.front().receivers.front().position = listener;
    return placement_warnings(scene, around, hearing);
  }

  std::string mistake(const Vector3& listener) {
    try {
      static_cast<void>(warnings(listener, Hearing::exact));
    } catch (const deck::DeckError& error) {
      return error.what();
    }
    return "";
  }

  scene::Scene scene;
  Surroundings around;
};

ON_RANKS(1);

TEST_F(Placement, RefusesListenersInsideBodiesAndObstacles) {
  EXPECT_EQ(mistake({0.04, -0.01, 0.049}),
            "cube.yaml:7:1: listeners.ear: ear is inside cube, where there is no air; move it outside");
  EXPECT_THAT(mistake({0.55, 1, 1}), HasSubstr("inside wall"));
  EXPECT_EQ(mistake({0.0, 0.0, 0.0501}), "");
}

TEST_F(Placement, WarnsNearASurfaceUpToTheFrequencyOfTwentyDistances) {
  EXPECT_THAT(warnings({0, 0, 0.052}),
              ElementsAre(AllOf(HasSubstr("ear is 0.002 m from cube"), HasSubstr("of all sound up to 8575 Hz"))));
  EXPECT_THAT(warnings({0, 0, 0.052}, Hearing::exact), IsEmpty());
  EXPECT_THAT(warnings({0, 0, 0.3}), IsEmpty());
  EXPECT_THAT(warnings({0, 0, 0.12}), ElementsAre(HasSubstr("the triangles there are 0.141 m long")));
  scene.radiation.grid.cell = 0.03;
  EXPECT_THAT(warnings({0, 0, 0.12}, Hearing::grid), IsEmpty());
  EXPECT_THAT(warnings({0, 0, 0.07}, Hearing::grid), ElementsAre(HasSubstr("the cells there are 0.03 m long")));
}

TEST_F(Placement, WarnsOfAWayThroughAnotherPart) {
  EXPECT_THAT(warnings({8, 0, 0}), ElementsAre(AllOf(HasSubstr("wall stands in the way from 100 % of cube"),
                                                     HasSubstr("blocks that sound"))));
  EXPECT_THAT(warnings({8, 0, 0}, Hearing::grid), IsEmpty());
  scene.radiation.visibility.reset();
  EXPECT_THAT(warnings({8, 0, 0}), ElementsAre(HasSubstr("goes through it")));
  EXPECT_THAT(warnings({-3, 0, 0}), IsEmpty());
}

TEST_F(Placement, WarnsOfAPathThroughABody) {
  scene.listeners.front().path = {.points = {{0.0, Vector3(-1, 0, 0)}, {2.0, Vector3(0.3, 0, 0)}}, .where = {}};
  EXPECT_THAT(warnings({-1, 0, 0}), ElementsAre(HasSubstr("listener ear is inside cube at 1.4")));
}

TEST_F(Placement, RefusesABodyThatIsMostlyBehindTheFloor) {
  scene.radiation.floor = scene::Floor{.at = Vector3(0, 0, -0.04)};
  EXPECT_THAT(warnings({0, 0, 1}), ElementsAre("body cube reaches 0.01 m behind radiation.floor, which has no meaning "
                                               "there; move one of the two"));
  scene.radiation.floor->at.z() = 0.01;
  EXPECT_THAT(mistake({0, 0, 1}), HasSubstr("cube.yaml:3:1: bodies.cube: more than half of it is behind"));
}

}  // namespace
}  // namespace idiophone::propagation
