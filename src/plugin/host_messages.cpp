#include "host_messages.hpp"

#include <fmt/format.h>
#include <lv2/atom/util.h>
#include <lv2/midi/midi.h>
#include <lv2/patch/patch.h>

#include <algorithm>

namespace idiophone::plugin {

Uris::Uris(const Host& host)
    : midi(host.number(LV2_MIDI__MidiEvent)),
      path(host.number(LV2_ATOM__Path)),
      urid(host.number(LV2_ATOM__URID)),
      object(host.number(LV2_ATOM__Object)),
      sequence(host.number(LV2_ATOM__Sequence)),
      patch_get(host.number(LV2_PATCH__Get)),
      patch_set(host.number(LV2_PATCH__Set)),
      patch_property(host.number(LV2_PATCH__property)),
      patch_value(host.number(LV2_PATCH__value)),
      maps() {
  for (std::size_t slot = 0; slot < map_slots; ++slot) {
    maps.at(slot) = host.number(fmt::format("{}#map{}", plugin_uri, slot + 1).c_str());
  }
}

namespace {

HostMessage read_choice(const LV2_Atom_Object& object, const Uris& uris) {
  const LV2_Atom *property = nullptr, *value = nullptr;
  lv2_atom_object_get(&object, uris.patch_property, &property, uris.patch_value, &value, 0);
  if (property == nullptr || property->type != uris.urid || value == nullptr || value->type != uris.path) {
    return {};
  }
  const auto* slot = std::ranges::find(uris.maps, reinterpret_cast<const LV2_Atom_URID*>(property)->body);
  const std::string_view body(static_cast<const char*>(LV2_ATOM_BODY_CONST(value)), value->size);
  const std::string_view path = body.substr(0, body.find('\0'));
  if (slot == uris.maps.end() || path.size() >= longest_path) {
    return {};
  }
  return MapChoice{.slot = static_cast<std::size_t>(slot - uris.maps.begin()), .path = path};
}

}  // namespace

HostMessage read_message(const LV2_Atom& atom, const Uris& uris) {
  if (atom.type == uris.midi) {
    const std::span bytes(static_cast<const unsigned char*>(LV2_ATOM_BODY_CONST(&atom)), atom.size);
    const std::optional<drivers::MidiMessage> message = drivers::midi_message(bytes);
    return message ? HostMessage(*message) : HostMessage();
  }
  if (atom.type != uris.object || atom.size < sizeof(LV2_Atom_Object_Body)) {
    return {};
  }
  const auto& object = reinterpret_cast<const LV2_Atom_Object&>(atom);
  if (object.body.otype == uris.patch_get) {
    return MapQuestion{};
  }
  return object.body.otype == uris.patch_set ? read_choice(object, uris) : HostMessage();
}

Answers::Answers(LV2_Atom_Forge& forge, LV2_Atom_Sequence& port, const Uris& uris) : forge_(forge), uris_(uris) {
  lv2_atom_forge_set_buffer(&forge_, reinterpret_cast<std::uint8_t*>(&port), port.atom.size);
  lv2_atom_forge_sequence_head(&forge_, &frame_, 0);
}

bool Answers::add(const MapChoice& choice) {
  constexpr std::size_t most_around = 128;  // bytes around a path: event, object, two properties
  if (forge_.size - forge_.offset < choice.path.size() + most_around) {
    return false;
  }
  LV2_Atom_Forge_Frame object{};
  lv2_atom_forge_frame_time(&forge_, 0);
  lv2_atom_forge_object(&forge_, &object, 0, uris_.patch_set);
  lv2_atom_forge_key(&forge_, uris_.patch_property);
  lv2_atom_forge_urid(&forge_, uris_.maps.at(choice.slot));
  lv2_atom_forge_key(&forge_, uris_.patch_value);
  lv2_atom_forge_path(&forge_, choice.path.data(), static_cast<std::uint32_t>(choice.path.size()));
  lv2_atom_forge_pop(&forge_, &object);
  return true;
}

}  // namespace idiophone::plugin
