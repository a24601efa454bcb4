#include "idiophone/instruments/drivers/midi.hpp"

namespace idiophone::drivers {

std::optional<MidiMessage> midi_message(std::span<const unsigned char> bytes) {
  using Kind = MidiMessage::Kind;
  constexpr int release = 0x80, press = 0x90, pressure = 0xd0, bend = 0xe0;
  constexpr int middle_of_bend = 8192;
  if (bytes.size() < 2) {
    return {};
  }
  const int kind = bytes[0] & 0xf0, first = bytes[1] & 0x7f;
  if (kind == pressure) {
    return MidiMessage{.kind = Kind::pressure, .value = first};
  }
  if (bytes.size() < 3) {
    return {};
  }
  const int second = bytes[2] & 0x7f;
  if (kind == press && second > 0) {
    return MidiMessage{.kind = Kind::press, .number = first, .value = second};
  }
  if (kind == release || kind == press) {  // a velocity of 0 releases the key
    return MidiMessage{.kind = Kind::release, .number = first};
  }
  if (kind == bend) {
    return MidiMessage{.kind = Kind::bend, .value = 128 * second + first - middle_of_bend};
  }
  return {};
}

}  // namespace idiophone::drivers
