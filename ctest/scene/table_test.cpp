#include "deck_fixture.hpp"

namespace idiophone::scene {

class TableTest : public DeckTest {
 protected:
  [[nodiscard]] std::string answer(const std::string& csv) const {
    write("force.csv", csv);
    return mistakes(deck);
  }

  const std::string deck = replaced(plate, "duration: 1.0e-3", "shape: table, table: force.csv");
};

TEST_F(TableTest, HasRowsOfTimeAndValue) {
  write("force.csv", "# time in s, value\n0, 0\r\n\n  1.5e-3 ,\t-2.5  # the peak\n4e-3,0");
  const Signal signal = read(deck).pulses.at(0).signal;
  EXPECT_EQ(signal.shape, Signal::Shape::table);
  EXPECT_THAT(signal.table,
              testing::ElementsAre(std::array{0.0, 0.0}, std::array{1.5e-3, -2.5}, std::array{4e-3, 0.0}));
}

TEST_F(TableTest, RowsThatAreWrongAreAnsweredWithTheirPlace) {
  EXPECT_EQ(answer("0, 0\n1\n"), "DIR/force.csv:2:2: expected a comma between time and value, found ''");
  EXPECT_EQ(answer("0, 0\n1; 2\n"), "DIR/force.csv:2:2: expected a comma between time and value, found '; 2'");
  EXPECT_EQ(answer("time, value\n0, 0\n1, 1\n"), "DIR/force.csv:1:1: expected a time (s), found 'time, value'");
  EXPECT_EQ(answer("0, 0\n1, x\n"), "DIR/force.csv:2:4: expected a value, found 'x'");
  EXPECT_EQ(answer("0, 0\n1, \n"), "DIR/force.csv:2:4: expected a value, found ''");
  EXPECT_EQ(answer("0, 0\n1, nan\n"), "DIR/force.csv:2:4: expected a value, found 'nan'");
  EXPECT_EQ(answer("0, 0\n1, 2, 3\n"), "DIR/force.csv:2:5: unexpected ', 3' after the value");
  EXPECT_EQ(answer("0, 0\n 1, 1\n 1, 2\n"), "DIR/force.csv:3:2: times must ascend; 1 s does not follow 1 s");
  EXPECT_EQ(answer("-1, 0\n1, 1\n"), "DIR/force.csv:1:1: the time must be at least 0 s, found -1");
  EXPECT_EQ(answer("0, x\n1, y\n"),
            "DIR/force.csv:1:4: expected a value, found 'x'\nDIR/force.csv:2:4: expected a value, found 'y'");
}

TEST_F(TableTest, NeedsTwoRows) {
  const std::string answer_to_short = "deck.yaml:8:65: loads.tap.table: needs at least 2 rows 'time, value', found ";
  EXPECT_EQ(answer(""), answer_to_short + "0 in DIR/force.csv");
  EXPECT_EQ(answer("0, 1\n"), answer_to_short + "1 in DIR/force.csv");
}

TEST_F(TableTest, SomethingElseAltogetherIsAnsweredTenTimes) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += "not a table\n";
  }
  const std::string answers = answer(text);
  EXPECT_EQ(std::ranges::count(answers, '\n'), 9);
}

}  // namespace idiophone::scene
