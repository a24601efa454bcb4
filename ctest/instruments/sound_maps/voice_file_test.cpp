// Voice files: what is written comes back to the bit; what is foreign or damaged is refused.

#include "idiophone/instruments/sound_maps/voice_file.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"
#include "shared_folder.hpp"
#include "small_map.hpp"

namespace idiophone::sound_maps {
namespace {

using ::testing::HasSubstr;

ON_RANKS(1);

std::string refusal_of(const std::string& bytes) {
  return support::error_of([&] { (void)read_voice(bytes, "bell.voice"); });
}

TEST(VoiceFile, ComesBackToTheBit) {
  SoundMap map = small_map();
  map.stretching = {.linear = {1, 2}, .quadratic = {1, 2, 2, 1.0 / 3}, .rotation = {2, 1, 1, 3}};
  const SoundMap read = read_voice(voice_file(map), "bell.voice");
  EXPECT_EQ(read.body, map.body);
  EXPECT_EQ(read.kind, map.kind);
  ASSERT_TRUE(read.material.has_value());
  EXPECT_EQ(read.material->name, "steel");
  EXPECT_EQ(read.material->poisson, 0.3);
  EXPECT_EQ(read.mass, map.mass);
  EXPECT_EQ(read.centre, map.centre);
  EXPECT_EQ(read.frequency, map.frequency);
  EXPECT_EQ(read.material_decay, map.material_decay);
  EXPECT_EQ(read.radiation_decay, map.radiation_decay);
  EXPECT_EQ(read.stretching.quadratic, map.stretching.quadratic);
  EXPECT_EQ(read.stretching.rotation, map.stretching.rotation);
  EXPECT_EQ(read.vertices, map.vertices);
  EXPECT_EQ(read.triangles, map.triangles);
  EXPECT_EQ(read.shape, map.shape);
  ASSERT_EQ(read.listeners.size(), 1);
  EXPECT_EQ(read.listeners[0].pressure, map.listeners[0].pressure);
  EXPECT_EQ(read.sphere.rings, 2);
  EXPECT_EQ(read.sphere.direction, map.sphere.direction);
  EXPECT_EQ(read.sphere.pressure, map.sphere.pressure);
  EXPECT_EQ(voice_file(read), voice_file(map));
}

/// The format does not depend on the machine, and files stay readable.
TEST(VoiceFile, BeginsWithItsNameAndVersion) {
  const std::string bytes = voice_file(small_map());
  EXPECT_EQ(bytes.substr(0, 20), std::string("IDIOPHONE VOICE\n\1\0\0\0", 20));
  EXPECT_EQ(bytes.substr(28, 12), std::string("\4\0\0\0\0\0\0\0deck", 12));
}

TEST(VoiceFile, RefusesWhatIsForeignOrDamaged) {
  const std::string bytes = voice_file(small_map());
  EXPECT_THAT(refusal_of(""), HasSubstr("bell.voice is no voice file"));
  EXPECT_THAT(refusal_of("\x89HDF\r\n\x1a\n and so on"), HasSubstr("it does not begin as one"));
  std::string newer = bytes;
  newer[16] = 2;
  EXPECT_THAT(refusal_of(newer), HasSubstr("version 2, and this library reads version 1"));
  std::string damaged = bytes;
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  EXPECT_THAT(refusal_of(damaged), HasSubstr("its checksum is wrong"));
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_NE(refusal_of(bytes.substr(0, length)), "");
  }
}

}  // namespace
}  // namespace idiophone::sound_maps
