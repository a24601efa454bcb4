#pragma once
// What a host says to the plugin in its event port, and what the plugin answers: MIDI, and the files of maps as
// parameters (patch:Set, patch:Get).

#include <lv2/atom/atom.h>
#include <lv2/atom/forge.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <variant>

#include "host.hpp"
#include "idiophone/instruments/drivers/midi.hpp"

namespace idiophone::plugin {

inline constexpr const char* plugin_uri = "urn:idiophone:plugin";
inline constexpr std::size_t map_slots = 8;        ///< files of sound maps that a plugin can have
inline constexpr std::size_t longest_path = 4096;  ///< bytes

/// The numbers that a host gives to URIs.
struct Uris {
  explicit Uris(const Host& host);

  LV2_URID midi, path, urid, object, sequence;
  LV2_URID patch_get, patch_set, patch_property, patch_value;
  std::array<LV2_URID, map_slots> maps;  ///< the parameters map1, map2, ...
};

/// A map is to come from a file.
struct MapChoice {
  std::size_t slot = 0;
  std::string_view path{};  ///< empty: no map
};

/// The host asks for the files of maps.
struct MapQuestion {};

using HostMessage = std::variant<std::monostate, drivers::MidiMessage, MapChoice, MapQuestion>;

/// @return nothing for a message that is not for this plugin
[[nodiscard]] HostMessage read_message(const LV2_Atom& atom, const Uris& uris);

/// Writes answers into the event port of an audio block. Allocates nothing.
class Answers {
 public:
  /// @param port  whose atom has the size of the room in it
  Answers(LV2_Atom_Forge& forge, LV2_Atom_Sequence& port, const Uris& uris);

  /// False if there is no room.
  bool add(const MapChoice& choice);

  void end() { lv2_atom_forge_pop(&forge_, &frame_); }

 private:
  LV2_Atom_Forge& forge_;
  const Uris& uris_;
  LV2_Atom_Forge_Frame frame_{};
};

}  // namespace idiophone::plugin
