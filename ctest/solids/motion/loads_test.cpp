#include "idiophone/solids/motion/loads.hpp"

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

ON_RANKS(1);

// So the states of its nodes need not be brought up to date.
TEST(Loads, APulseThatIsOverActsOnNoNodes) {
  Laboratory lab(support::block_mesh(element::tet4, {0.3, 0.2, 0.1}, {3, 2, 1}));
  lab.push("x1", {1, 0, 0}, 0.002);
  lab.scene.pulses[0].signal.start = 0.001;
  const Loads loads(lab.scene, lab.part, lab.attachments);
  EXPECT_EQ(loads.nodes(0.0), lab.mesh.groups.at("x1"));
  EXPECT_EQ(loads.nodes(0.003), lab.mesh.groups.at("x1"));
  EXPECT_TRUE(loads.nodes(0.0031).empty());
}

}  // namespace
}  // namespace idiophone::motion
