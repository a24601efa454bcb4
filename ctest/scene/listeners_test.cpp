#include "deck_fixture.hpp"

namespace idiophone::scene {

using ListenersTest = DeckTest;

TEST_F(ListenersTest, EarsAreAcrossTheViewingDirection) {
  // Looking down (-z) with the head's top towards y, the right ear is towards (-z) x y = x.
  const Scene scene = read(replaced(plate, "mono", "stereo, look: [0, 0, -3], up: [0, 5, 4], separation: 0.5"));
  ASSERT_EQ(scene.listeners.size(), 1U);
  ASSERT_EQ(scene.listeners[0].receivers.size(), 2U);
  const auto& [left, right] = std::pair(scene.listeners[0].receivers[0], scene.listeners[0].receivers[1]);
  EXPECT_EQ(left.channel, "ear.left");
  EXPECT_EQ(right.channel, "ear.right");
  EXPECT_TRUE(left.position.isApprox(Vector3(-0.25, 0.0, 1.0), 1e-15)) << left.position.transpose();
  EXPECT_TRUE(right.position.isApprox(Vector3(0.25, 0.0, 1.0), 1e-15)) << right.position.transpose();
}

TEST_F(ListenersTest, EarsAreTwentyCentimetresApart) {
  const Scene scene = read(replaced(plate, "mono", "stereo, look: [1, 2, 3], up: [0, 0, 1]"));
  const auto& receivers = scene.listeners.at(0).receivers;
  const Vector3 across = receivers.at(1).position - receivers.at(0).position;
  EXPECT_NEAR(across.norm(), 0.2, 1e-15);
  EXPECT_NEAR(across.dot(Vector3(1, 2, 3)), 0.0, 1e-15);
  EXPECT_NEAR(across.z(), 0.0, 1e-15);
}

TEST_F(ListenersTest, MonoIsOnePoint) {
  const Listener listener = read(plate).listeners.at(0);
  ASSERT_EQ(listener.receivers.size(), 1U);
  EXPECT_EQ(listener.receivers[0].channel, "ear");
  EXPECT_EQ(listener.receivers[0].position, Vector3(0, 0, 1));
  EXPECT_EQ(listener.where.line, 10);
  EXPECT_EQ(listener.where.column, 3);
}

}  // namespace idiophone::scene
