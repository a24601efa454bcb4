// Rooms in decks: what they say, and what is wrong with them.

#include <cmath>

#include "deck_fixture.hpp"

namespace idiophone::scene {

class RoomTest : public DeckTest {
 protected:
  [[nodiscard]] std::string in(const std::string& keys) const { return plate + "radiation: {room: {" + keys + "}}\n"; }
  const std::string size = "size: [4, 5, 3], corner: [-2, -2, -1], ";
};

TEST_F(RoomTest, HasWallsThatAbsorbAlikeOrEachItsOwnWay) {
  const Room even = *read(in(size + "absorption: 0.2, late: false, images: 5")).radiation.room;
  EXPECT_EQ(even.size, Vector3(4, 5, 3));
  EXPECT_EQ(even.corner, Vector3(-2, -2, -1));
  EXPECT_EQ(even.absorption[5][5], 0.2);
  EXPECT_TRUE(even.absorbs_evenly());
  EXPECT_FALSE(even.late);
  EXPECT_EQ(even.order(), 5);
  const Room octaves = *read(in(size + "absorption: [0.1, 0.1, 0.2, 0.3, 0.4, 0.5]")).radiation.room;
  EXPECT_EQ(octaves.absorption[3][4], 0.4);
  EXPECT_FALSE(octaves.absorbs_evenly());
  const Room walls = *read(in(size + "absorption: {left: 0.1, right: 0.2, front: 0.3, back: 0.4,"
                                     " floor: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], ceiling: 1}"))
                          .radiation.room;
  EXPECT_EQ(walls.absorption[1][0], 0.2);
  EXPECT_EQ(walls.absorption[4][5], 0.6);
  EXPECT_EQ(walls.absorption[5][5], 1.0);
}

TEST_F(RoomTest, ComputesAsManyImagesAsItsAbsorptionNeeds) {
  const auto order = [&](const std::string& keys) { return read(in(size + keys)).radiation.room->order(); };
  EXPECT_EQ(order("absorption: 0.2"), 3);
  EXPECT_EQ(order("absorption: 0.2, late: false"), 10);
  EXPECT_EQ(order("absorption: 0.999"), 2);  // each reflection takes 30 dB
  EXPECT_EQ(order("absorption: 0.9, late: false"), 6);
}

TEST_F(RoomTest, DecaysAsEyringSays) {
  const Room room =
      *read(in(size + "absorption: {left: 0.1, right: 0.1, front: 0.3, back: 0.3, floor: 0.5, ceiling: 0.2}"))
           .radiation.room;
  const double mean = (30 * 0.1 + 24 * 0.3 + 20 * 0.5 + 20 * 0.2) / 94;
  EXPECT_NEAR(6 * std::log(10) / room.decay_rate(2, 343), 24 * std::log(10) * 60 / (343 * -94 * std::log(1 - mean)),
              1e-12);
}

TEST_F(RoomTest, MistakesAreAnsweredWithTheirPlace) {
  EXPECT_EQ(mistakes(in("corner: [0, 0, 0]")),
            "deck.yaml:11:19: radiation.room: the key 'size' is missing\n"
            "deck.yaml:11:19: radiation.room: the key 'absorption' is missing");
  EXPECT_EQ(mistakes(in(size + "absorption: 1.2")),
            "deck.yaml:11:71: radiation.room.absorption: must be at least 0 and at most 1, found 1.2");
  EXPECT_EQ(mistakes(in(size + "absorption: [0.1, 0.2]")),
            "deck.yaml:11:71: radiation.room.absorption: expected a number, or a list of 6 numbers for the octaves at "
            "125, 250, 500, 1000, 2000 and 4000 Hz, found a list of 2");
  EXPECT_EQ(
      mistakes(in(size + "absorption: {left: 0, right: 0, front: 0, back: 0, flor: 0, ceiling: 0}")),
      "deck.yaml:11:71: radiation.room.absorption: the key 'floor' is missing\n"
      "deck.yaml:11:110: radiation.room.absorption.flor: unknown key (did you mean 'floor'?), known here: left, right, "
      "front, back, floor, ceiling");
  EXPECT_THAT(mistakes(in(size + "absorption: 0")),
              testing::HasSubstr("the late field never decays; let the walls absorb more, or give late: false"));
  EXPECT_THAT(mistakes(in(size + "absorption: 0.004")),
              testing::HasSubstr("the late field needs 25.7 s to lose 60 dB, at most 20 s are possible"));
  EXPECT_EQ(mistakes(in(size + "absorption: 0, late: false")), "no mistakes");
  EXPECT_THAT(mistakes(plate + "radiation: {floor: {at: [0, 0, -1]}, room: {" + size + "absorption: 0.1}}\n"),
              testing::HasSubstr("radiation.room: a room has a floor already; give one of room and floor"));
}

TEST_F(RoomTest, NobodyListensOutside) {
  EXPECT_EQ(
      mistakes(in("size: [4, 5, 3], corner: [-2, -2, -2.5], absorption: 0.1")),
      "deck.yaml:10:3: listeners.ear: ear is 0.5 m outside radiation.room at 0 s; move it, or make the room larger");
  write("leave.csv", "0, 0, 0, 1\n2, 2.25, 0, 1\n");
  EXPECT_THAT(mistakes(replaced(in(size + "absorption: 0.1"), "position: [0, 0, 1]", "path: leave.csv")),
              testing::HasSubstr("ear is 0.25 m outside radiation.room at 2 s"));
}

}  // namespace idiophone::scene
