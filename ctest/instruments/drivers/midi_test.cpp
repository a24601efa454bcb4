#include "idiophone/instruments/drivers/midi.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "temporary_file.hpp"

namespace idiophone::drivers {

namespace {

class MidiFile : public testing::Test {
 protected:
  void write(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }
  support::TemporaryFile file_{"notes.mid"};
  const std::filesystem::path file = file_.path();
};

TEST_F(MidiFile, HasNotesAtTheirTimes) {
  using namespace std::string_literals;
  const std::string track =
      "\x00\xff\x51\x03\x0f\x42\x40"s  // 1 s a quarter
      "\x00\x90\x3c\x40"s              // note 60, velocity 64
      "\x60\x80\x3c\x00"s              // off after a quarter, which is 96 ticks
      "\x30\x90\x40\x7f"s              // note 64, half a quarter later
      "\x00\x90\x3c\x00"s              // velocity 0: off
      "\x00\xff\x2f\x00"s;
  std::string midi = "MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00"s;
  midi += static_cast<char>(track.size());
  write(midi + track);
  const std::vector<Note> notes = read_midi_file(file);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].number, 60);
  EXPECT_EQ(notes[0].velocity, 64);
  EXPECT_NEAR(notes[0].time, 0.0, 1e-9);
  EXPECT_EQ(notes[1].number, 64);
  EXPECT_NEAR(notes[1].time, 1.5, 1e-9);
}

TEST_F(MidiFile, IsRefusedIfItIsNone) {
  write("no MIDI");
  EXPECT_THROW(static_cast<void>(read_midi_file(file)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(read_midi_file("/nonexistent.mid")), std::runtime_error);
}

TEST_F(MidiFile, IsRefusedIfATrackHasNoEnd) {  // at which libsmf ends the process
  using namespace std::string_literals;
  write("MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00\x04\x00\x90\x3c\x64"s);
  EXPECT_THROW(static_cast<void>(read_midi_file(file)), std::runtime_error);
}

}  // namespace

}  // namespace idiophone::drivers
