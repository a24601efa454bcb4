#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/timbre/playing/playing.hpp"
#include "ranks.hpp"
#include "sheet_map.hpp"
#include "strictness.hpp"
#include "temporary_file.hpp"
#include "test_host.hpp"

namespace idiophone::plugin {

namespace {

using testing::HasSubstr;

/// A map of the sheet in a file.
class MapFile {
 public:
  explicit MapFile(const std::string& body) : file_(body + ".map.h5") {
    sound_maps::write_sound_map(file_.path(), sound_maps::sheet(body));
  }
  [[nodiscard]] std::string path() const { return file_.path().string(); }

 private:
  support::TemporaryFile file_;
};

float& control(TestHost& host, const std::string& symbol) {
  const auto* const port = std::ranges::find(control_ports, symbol, &ControlPort::symbol);
  return host.controls.at(static_cast<std::size_t>(port - control_ports.begin()));
}

/// A key that is struck at an audio sample.
struct Key {
  std::uint32_t sample;
  unsigned char number, velocity;
};

const std::vector<Key> keys = {{500, 60, 127}, {2350, 67, 64}, {5050, 60, 1}, {5100, 67, 100}};
constexpr std::uint32_t samples = 12000;

/// What the plugin makes of the keys, without its latency.
std::vector<float> sound_of(TestHost& host, std::uint32_t block) {
  std::vector<float> sound;
  const std::uint32_t end = samples + static_cast<std::uint32_t>(host.latency());
  for (std::uint32_t first = 0; first < end; first += block) {
    for (const Key& key : keys) {
      if (key.sample >= first && key.sample < first + block) {
        host.send_midi(key.sample - first, {0x90, key.number, key.velocity});
      }
    }
    const std::vector<float> more = host.run(block);
    sound.insert(sound.end(), more.begin(), more.end());
  }
  return {sound.begin() + 2 * host.latency(), sound.begin() + 2 * static_cast<std::ptrdiff_t>(end)};
}

/// The same keys as a MIDI file, with 480 ticks of 50 audio samples in a quarter.
std::string midi_file() {
  std::string track;
  std::uint32_t before = 0;
  for (const Key& key : keys) {
    const std::uint32_t ticks = (key.sample - before) / 50;
    before = key.sample;
    track += {static_cast<char>(ticks), '\x90', static_cast<char>(key.number), static_cast<char>(key.velocity)};
  }
  track += std::string("\0\xff\x2f\0", 4);
  return std::string("MThd\0\0\0\6\0\0\0\1\1\xe0MTrk\0\0\0", 21) + static_cast<char>(track.size()) + track;
}

/// What `play --output` makes of them: the key 67 strikes a body of its own, tuned as the plugin tunes it.
std::vector<float> played(const MapFile& low, const MapFile& high) {
  const std::string blow = fmt::format("at: [0.15, 0.125, 0], direction: [0, 0, -1], mass: {}, hardness: {}, speed: {}",
                                       double{0.02F}, double{1e8F}, 2);
  const support::TemporaryFile score(
      "score.yaml", fmt::format("duration: {}\n"
                                "listener: {{type: stereo, position: [0.1, 0.1, 1], look: [0, 0, -1], up: [0, 1, 0]}}\n"
                                "events: [{{time: 0, type: tune, body: high, size: {}}}]\n"
                                "notes: [{{note: 60, body: low, {}}}, {{note: 67, body: high, {}}}]\n"
                                "wav_full_scale: 1\n",
                                samples / 48000.0, std::exp2(-7 / 12.0), blow, blow));
  const support::TemporaryFile midi("keys.mid", midi_file());
  const support::TemporaryFile sound("keys.wav");
  timbre::PlaySettings settings;
  settings.files = {low.path(), high.path()};
  settings.score = score.path();
  settings.midi = midi.path().string();
  settings.output = sound.path();
  settings.rate = 48000;
  timbre::play(settings);
  const auto channels = spectra::read_sound_file(sound.path()).channels;
  std::vector<float> interleaved;
  for (std::size_t i = 0; i < channels.at(0).size(); ++i) {
    interleaved.push_back(static_cast<float>(channels.at(0)[i]));
    interleaved.push_back(static_cast<float>(channels.at(1)[i]));
  }
  return interleaved;
}

float loudest(const std::vector<float>& sound) {
  float most = 0.0F;
  for (const float sample : sound) {
    most = std::max(most, std::isfinite(sample) ? std::abs(sample) : std::numeric_limits<float>::infinity());
  }
  return most;
}

/// A block with a key in it, and what follows.
float loudness_of_key(TestHost& host, unsigned char key) {
  host.send_midi(3, {0x90, key, 100});
  float most = 0.0F;
  for (int block = 0; block < 40; ++block) {  // also of a listener at 17 m
    most = std::max(most, loudest(host.run(128)));
  }
  return most;
}

}  // namespace

ON_RANKS(1);

TEST(Plugin, SoundsToTheBitAsPlayWritesTheSameMidi) {
  const MapFile low("low"), high("high");
  const std::vector<float> expected = played(low, high);
  ASSERT_EQ(expected.size(), 2 * samples);
  ASSERT_GT(loudest(expected), 0.0F);
  for (const auto& [work, block] :
       {std::pair{Work::after_the_block, 128}, {Work::at_once, 100}, {Work::at_once, 1500}}) {
    TestHost host(work, block);
    control(host, "keyboard") = 1.0F;
    control(host, "place_x") = 0.5F;
    control(host, "place_y") = 0.25F;
    host.send_map(1, low.path());
    host.run(64);
    EXPECT_EQ(host.latency(), (block + 63) / 64 * 64);
    EXPECT_EQ(sound_of(host, static_cast<std::uint32_t>(block)), expected) << "blocks of " << block;
  }
}

TEST(Plugin, NeverLocksOrAllocatesInTheAudioThread) {
  const MapFile first("first"), second("second");
  TestHost host(Work::after_the_block, 128);
  const long before = AudioThread::offences();
  host.send_map(1, first.path());
  host.run(128);
  for (int block = 0; block < 120; ++block) {
    host.send_midi(7, {0x90, static_cast<unsigned char>(40 + block % 50), 100});
    host.send_midi(90, {0x80, static_cast<unsigned char>(40 + block % 50), 0});
    control(host, "mass") = block % 2 == 0 ? 0.02F : 0.03F;
    control(host, "size") = 1.0F + 0.01F * static_cast<float>(block % 3);
    control(host, "listener_x") = 0.1F * static_cast<float>(block % 5);
    control(host, "keyboard") = block < 90 ? 0.0F : 2.0F;
    if (block == 60) {
      host.send_map(2, second.path());
      host.send_map(3, "/no/such/map.h5");
    }
    if (block == 80) {
      host.send_question();
    }
    EXPECT_LT(loudest(host.run(128)), 1e6F);
  }
  EXPECT_EQ(AudioThread::offences() - before, 0);
}

TEST(Plugin, CountsWhatAnAudioThreadMustNotDo) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has functions of its own";
#endif
  const long before = AudioThread::offences();
  {
    const AudioThread audio;
    std::vector<double> memory(100);
    asm volatile("" : : "r"(memory.data()) : "memory");
  }
  EXPECT_EQ(AudioThread::offences() - before, 2);
}

TEST(Plugin, ProjectsKeepTheirMaps) {
  const MapFile map("kept");
  TestHost host(Work::after_the_block, 128);
  host.send_map(2, map.path());
  host.send_map(5, "/no/such/map.h5");
  host.run(128);
  EXPECT_THAT(host.log(), HasSubstr("/no/such/map.h5"));

  TestHost opened(Work::after_the_block, 128);
  opened.restore(host.save());
  EXPECT_THAT(opened.log(), HasSubstr("/no/such/map.h5"));
  opened.send_question();
  opened.run(128);
  opened.run(128);
  EXPECT_EQ(opened.answers().at(2), map.path());
  EXPECT_EQ(opened.answers().at(5), "/no/such/map.h5");
  EXPECT_EQ(opened.answers().at(1), "");
  EXPECT_GT(loudness_of_key(opened, 60), 0.0F);
  EXPECT_EQ(opened.save(), host.save());
}

TEST(Plugin, StaysQuietWithoutAMapAndOutOfRange) {
  const MapFile map("quiet");
  const support::TemporaryFile text("text.map.h5", "this is no map");
  TestHost host(Work::after_the_block, 128);
  EXPECT_EQ(loudness_of_key(host, 60), 0.0F);
  host.send_map(1, text.path());
  EXPECT_EQ(loudness_of_key(host, 60), 0.0F);
  EXPECT_THAT(host.log(), HasSubstr("text.map.h5"));
  host.send_map(1, map.path());
  host.run(128);
  EXPECT_EQ(loudness_of_key(host, 20), 0.0F);  // no key of a piano
  EXPECT_GT(loudness_of_key(host, 60), 0.0F);
  host.send_map(1, "");
  host.run(128);
  EXPECT_EQ(loudness_of_key(host, 60), 0.0F);
}

TEST(Plugin, LimitsControlsToTheirRanges) {
  const MapFile map("limits");
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30F}) {
    TestHost host(Work::after_the_block, 128);
    host.controls.fill(value);
    control(host, "full_scale") = 1.0F;
    host.send_map(1, map.path());
    host.run(128);
    const float loudness = loudness_of_key(host, 60);
    EXPECT_GT(loudness, 0.0F) << value;
    EXPECT_LT(loudness, 1e9F) << value;
  }
}

TEST(Plugin, HasThePortsOfItsDescription) {
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/src/plugin/bundle/idiophone.ttl");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (std::size_t i = 0; i < control_ports.size(); ++i) {
    const ControlPort& port = control_ports.at(i);
    const std::size_t symbol = text.find(fmt::format("lv2:symbol \"{}\"", port.symbol));
    ASSERT_NE(symbol, std::string::npos) << port.symbol;
    const auto number_after = [&](const std::string& key, std::size_t from) {
      return std::stof(text.substr(text.find(key, from) + key.size()));
    };
    EXPECT_EQ(number_after("lv2:index", text.rfind("lv2:index", symbol)), static_cast<float>(5 + i)) << port.symbol;
    EXPECT_EQ(number_after("lv2:minimum", symbol), port.least) << port.symbol;
    EXPECT_EQ(number_after("lv2:maximum", symbol), port.most) << port.symbol;
    EXPECT_EQ(number_after("lv2:default", symbol), port.usual) << port.symbol;
  }
}

}  // namespace idiophone::plugin
