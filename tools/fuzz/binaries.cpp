#include <gmsh.h>

#include <algorithm>

#include "flat_checksum.hpp"
#include "gmsh_extract.hpp"
#include "head_reader.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "osc_packet.hpp"
#include "readers.hpp"
#include "refusal.hpp"
#include "triangles.hpp"

namespace idiophone::fuzz {

namespace {

using File = std::filesystem::path;

void read_sound(const File& file) {
  static_cast<void>(spectra::read_sound_file(file));
}

void read_midi(const File& file) {
  static_cast<void>(drivers::read_midi_file(file));
  static_cast<void>(drivers::read_midi_messages(file));
}

/// As a keyboard sends them.
void read_messages(const File& file) {
  const std::string bytes = deck::read_text(file);
  constexpr std::size_t longest = 4;
  for (std::size_t first = 0; first < bytes.size(); first += longest) {
    const std::string message = bytes.substr(first, longest);
    static_cast<void>(drivers::midi_message({reinterpret_cast<const unsigned char*>(message.data()), message.size()}));
  }
}

void read_packet(const File& file) {
  std::string packet = deck::read_text(file);
  drivers::read_osc_packet(packet, [](const std::string& /*path*/, const drivers::OscArguments& /*arguments*/) {});
}

/// What idiophone_gmsh answers.
void read_mesh(const File& file) {
  scene::Body body;
  body.mesh = "plate.geo";
  body.element.kind = element::Kind::tet4;
  const mesh::MeshingAnswer answer = mesh::answer_from(deck::read_text(file));
  static_cast<void>(mesh::extract(body, answer));
}

std::string mutated_answer(std::string bytes, mutants::Random& random) {
  static const std::string tetrahedron =
      to_bytes(mesh::MeshingAnswer{.objections = {},
                                   .node_tags = {1, 2, 3, 4},
                                   .coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
                                   .elements = {{"Tetrahedron 4", 4, 4, {1}, {1, 2, 3, 4}}},
                                   .groups = {{"rim", 1, {1, 2, 3}, {1, 2, 3}, {}}},
                                   .views = {{"density", 0, 1, {1, 2}, {1.0, 2.0}}},
                                   .notes = {"a note"}});
  return bytes.size() < sizeof(double) ? tetrahedron : mutants::mutated_bytes(std::move(bytes), random);
}

void read_obj(const File& file) {
  gmsh::clear();
  try {
    mesher::open_obj(file.string(), "");
  } catch (const mesher::Refusal&) {  // which idiophone_gmsh prints
  }
}

/// A voice for engines. It gets a right checksum, so that its contents are read.
void read_voice(const File& file) {
  const std::string bytes = mutants::with_right_checksum(deck::read_text(file));
  static_cast<void>(sound_maps::read_voice(bytes, file.string()));
}

/// The same of a proxy.
void read_proxy(const File& file) {
  const std::string bytes = mutants::with_right_checksum(deck::read_text(file));
  static_cast<void>(proxies::read_proxy(bytes, file.string()));
}

/// The triangles of a glTF file.
void read_model(const File& file) {
  gmsh::clear();
  try {
    mesher::open_model(file.string(), "");
  } catch (const mesher::Refusal&) {  // which idiophone_gmsh prints
  }
}

}  // namespace

std::vector<Reader> binary_readers() {
  return {{"sound", ".wav", read_sound, mutants::mutated_bytes},
          {"midi", ".mid", read_midi, mutants::mutated_bytes},
          {"messages", ".bytes", read_messages, mutants::mutated_bytes, false},
          {"osc", ".osc", read_packet, mutants::mutated_bytes, false},
          {"mesh", ".answer", read_mesh, mutated_answer, false},
          {"obj", ".obj", read_obj, mutants::mutated_text, false},
          {"model", ".glb", read_model, mutants::mutated_bytes, false},
          {"voice", ".voice", read_voice, mutants::mutated_bytes},
          {"proxy", ".proxy", read_proxy, mutants::mutated_bytes},
          {"head", ".sofa", mutants::read_head, mutants::mutated_bytes}};
}

}  // namespace idiophone::fuzz
