#include "deck_fixture.hpp"
#include "idiophone/foundation/spectra/wav.hpp"

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
  EXPECT_EQ(answer("0, 0\ntime, value\n1, 1\n"), "DIR/force.csv:2:1: expected a time (s), found 'time, value'");
  EXPECT_EQ(answer("0, 0\n1, x\n"), "DIR/force.csv:2:4: expected a value, found 'x'");
  EXPECT_EQ(answer("0, 0\n1, \n"), "DIR/force.csv:2:4: expected a value, found ''");
  EXPECT_EQ(answer("0, 0\n1, nan\n"), "DIR/force.csv:2:4: expected a value, found 'nan'");
  EXPECT_EQ(answer("0, 0\n1, 2, 3\n"), "DIR/force.csv:2:5: unexpected ', 3' after the value: a row has 2 numbers");
  EXPECT_EQ(answer("0, 0\n 1, 1\n 1, 2\n"), "DIR/force.csv:3:2: times must ascend; 1 s does not follow 1 s");
  EXPECT_EQ(answer("-1, 0\n1, 1\n"), "DIR/force.csv:1:1: the time must be at least 0 s, found -1");
  EXPECT_EQ(answer("0, x\n1, y\n"),
            "DIR/force.csv:1:4: expected a value, found 'x'\nDIR/force.csv:2:4: expected a value, found 'y'");
}

TEST_F(TableTest, AHeaderHasTheUnits) {
  const auto table_of = [&](const std::string& csv, const std::string& text) {
    write("force.csv", csv);
    return read(text).pulses.at(0).signal.table;
  };
  const std::string directed = replaced(deck, "force: [0, 0, -20]", "force: [0, 0, -1]");
  const auto rows = testing::ElementsAre(std::array{0.0, 0.0}, std::array{1.5e-3, 2500.0});
  EXPECT_THAT(table_of("# measured\n time/ms, force/kN\n0, 0\n1.5, 2.5\n", directed), rows);
  EXPECT_THAT(table_of("time (us), hammer force (N)\r\n0, 0\n1500, 2500\n", directed), rows);
  EXPECT_THAT(table_of("time [s], value\n0, 0\n1.5e-3, 2500\n", deck), rows);
  EXPECT_THAT(table_of("\xEF\xBB\xBFtime/ms, force/kN\r\n0, 0\r\n1.5, 2.5\r\n", directed), rows) << "of a spreadsheet";
}

TEST_F(TableTest, AHeaderThatIsWrongIsAnsweredWithItsPlace) {
  EXPECT_EQ(answer("time, value\n0, 0\n1, 1\n"),
            "DIR/force.csv:1:1: expected a row 'time, value' or a header with units, such as 'time/s, force/N', found "
            "'time, value'");
  EXPECT_EQ(answer("# x\n  time/min, force/N\n0, 0\n1, 1\n"),
            "DIR/force.csv:2:3: 'min' is no unit of a time here; take s, ms or us");
  EXPECT_EQ(answer("time/s, force/lbf\n0, 0\n1, 1\n"),
            "DIR/force.csv:1:1: 'lbf' is no unit of a value here; take N, mN, kN or 1");
}

TEST_F(TableTest, NewtonsNeedAForceOfLengthOne) {
  const std::string newtons = "time/s, force/N\n0, 0\n1, 1\n";
  EXPECT_EQ(answer(newtons),
            "deck.yaml:8:31: loads.tap.force: the table has newtons, so that this must be a direction of length 1, but "
            "it has 20");
  EXPECT_EQ(mistakes(replaced(deck, "{at: [0, 0, 0], force: [0, 0, -20],", "{type: wind, velocity: [1, 0, 0],")),
            "deck.yaml:8:63: loads.tap.table: has newtons, but this is no force: leave the unit of its values out");
}

TEST_F(TableTest, ARecordingHasAValueForEachSample) {
  const std::vector<double> samples = {0.0, 0.25, -0.5, 0.0};
  spectra::write_wav(folder / "hammer.wav", samples, {.rate = 8000});
  const std::string recorded = replaced(plate, "duration: 1.0e-3", "shape: table, table: hammer.wav");
  EXPECT_THAT(read(recorded).pulses.at(0).signal.table,
              testing::ElementsAre(std::array{0.0, 0.0}, std::array{1.25e-4, 0.25}, std::array{2.5e-4, -0.5},
                                   std::array{3.75e-4, 0.0}));
  spectra::write_wav(folder / "hammer.wav", samples, {.rate = 8000, .channels = 2});
  EXPECT_THAT(mistakes(recorded), testing::HasSubstr("must have one channel of at least 2 samples"));
  write("hammer.wav", "no sound");
  EXPECT_THAT(mistakes(recorded), testing::HasSubstr("loads.tap.table: "));
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
