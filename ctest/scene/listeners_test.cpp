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

TEST_F(ListenersTest, MicrophonesHavePatterns) {
  const auto directivity = [&](const std::string& pattern) {
    const Scene scene = read(replaced(plate, "mono", "mono, look: [0, 0, -2], pattern: " + pattern));
    const Receiver& receiver = scene.listeners.at(0).receivers.at(0);
    EXPECT_EQ(receiver.axis, Vector3(0, 0, -1));
    return receiver.directivity;
  };
  EXPECT_EQ(directivity("cardioid"), 0.5);
  EXPECT_EQ(directivity("figure_of_eight"), 1.0);
  EXPECT_EQ(directivity("0.75"), 0.75);
  EXPECT_EQ(read(plate).listeners.at(0).receivers.at(0).directivity, 0.0);
}

TEST_F(ListenersTest, PairsOfMicrophonesLookApart) {
  // ORTF: 17 cm and 110 degrees apart. Looking towards y with z up, right is x.
  const Scene scene = read(replaced(
      plate, "mono", "stereo, look: [0, 1, 0], up: [0, 0, 1], pattern: cardioid, separation: 0.17, angle: 110"));
  const auto& [left, right] = std::pair(scene.listeners.at(0).receivers.at(0), scene.listeners.at(0).receivers.at(1));
  EXPECT_TRUE(left.position.isApprox(Vector3(-0.085, 0, 1), 1e-14));
  EXPECT_NEAR(left.axis.x(), -0.8191520442889918, 1e-12);  // sin(55 degrees)
  EXPECT_NEAR(left.axis.y(), 0.5735764363510461, 1e-12);
  EXPECT_NEAR(right.axis.x(), 0.8191520442889918, 1e-12);
  EXPECT_EQ(right.directivity, 0.5);
}

TEST_F(ListenersTest, PatternsThatAreWrongAreAnswered) {
  const auto answer = [&](const std::string& keys) { return mistakes(replaced(plate, "mono", keys)); };
  EXPECT_EQ(
      answer("mono, look: [0, 0, 1], pattern: cardoid"),
      "deck.yaml:10:47: listeners.ear.pattern: must be omni, cardioid, figure_of_eight or a number from 0 (omni) to "
      "1 (figure of eight), found 'cardoid' (did you mean 'cardioid'?)");
  EXPECT_EQ(answer("mono, look: [0, 0, 1], pattern: 1.5"),
            "deck.yaml:10:47: listeners.ear.pattern: must be at least 0 and at most 1, found 1.5");
  EXPECT_THAT(answer("mono, look: [0, 0, 1], pattern: [1]"), testing::HasSubstr("found a list of 1"));
  EXPECT_THAT(answer("mono, pattern: cardioid"), testing::HasSubstr("the key 'look' is missing"));
  EXPECT_THAT(answer("mono, look: [0, 0, 1]"), testing::HasSubstr("an omnidirectional microphone has no axis"));
  const std::string pair = "stereo, look: [0, 0, 1], up: [0, 1, 0], ";
  EXPECT_THAT(answer(pair + "pattern: cardioid"), testing::HasSubstr("the key 'angle' is missing"));
  EXPECT_THAT(answer(pair + "angle: 90"), testing::HasSubstr("omnidirectional microphones have no axis"));
}

TEST_F(ListenersTest, NobodyListensBehindTheFloor) {
  const std::string floor = "radiation: {floor: {at: [0, 0, 0.5], reflection: 0.9}}\n";
  EXPECT_EQ(read(plate + floor).radiation.floor->reflection, 0.9);
  EXPECT_EQ(read(plate + floor).radiation.floor->direction, Vector3::UnitZ());
  EXPECT_EQ(mistakes(replaced(plate, "[0, 0, 1]}", "[0, 0, 0.25]}") + floor),
            "deck.yaml:10:3: listeners.ear: ear is 0.25 m behind radiation.floor at 0 s; move it, or the floor");
  write("dive.csv", "0, 0, 0, 1\n2, 0, 0, 0\n");
  EXPECT_THAT(mistakes(replaced(plate, "position: [0, 0, 1]", "path: dive.csv") + floor),
              testing::HasSubstr("ear is 0.5 m behind radiation.floor at 2 s"));
  EXPECT_THAT(mistakes(plate + "radiation: {floor: {at: [0, 0, 0], reflection: 1.5}}\n"),
              testing::HasSubstr("must be at least -1 and at most 1"));
}

}  // namespace idiophone::scene
