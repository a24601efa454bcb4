#include "modes_file.hpp"

#include <fmt/format.h>

#include "idiophone/foundation/version.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/record/stored_body.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/study/mode_pictures/mode_pictures.hpp"
#include "mode_bounds.hpp"

namespace idiophone::app {

std::string name_of_modes(const scene::Scene& scene) {
  return scene.name + "_modes";
}

nlohmann::json facts_of_modes(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes) {
  nlohmann::json facts;
  if (!meshes.empty()) {
    facts["deck"] = scene::resolved_deck(scene.deck, scene.overrides);
  }
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    facts["bodies"][scene.bodies[b].name]["mesh_hash"] = meshes[b].hash;
  }
  return facts;
}

namespace {

/// Those of one body; the file's shapes must outlive them.
results::BodyModes modes_of_body(const ModesFile& file, const record::StoredBody& body, const mesh::Part& all,
                                 std::size_t number) {
  const mesh::BodyPart& part = all.bodies[number];
  results::BodyModes modes;
  modes.body = body.name();
  modes.nodes = &body.nodes();
  modes.mass = file.mass;
  modes.rigid_motions = file.found.rigid_motions;
  modes.mesh_errors = file.mesh_errors;
  modes.kinds = file.kinds;
  for (const eigenmodes::Mode& mode : file.found.modes) {
    modes.frequencies.push_back(mode.frequency);
    modes.damping_ratios.push_back(mode.damping_ratio);
    modes.decay_times.push_back(mode.decay_time);
    modes.kinetic_shares.push_back(mode.kinetic_shares[number]);
    modes.shapes.emplace_back(
        std::span(mode.shape).subspan(3UL * part.owned_begin, 3UL * (part.owned_end - part.owned_begin)));
  }
  return modes;
}

}  // namespace

void write_modes(const std::filesystem::path& folder, const ModesFile& file, const mesh::Part& part,
                 const mesh::Offsets& offsets, MPI_Comm communicator) {
  const scene::Scene& scene = file.scene;
  auto result =
      results::ResultFile::create(folder / (name_of_modes(scene) + ".h5"),
                                  {scene.name, program_version, scene.deck_text, scene.overrides}, communicator);
  result.note("/run", file.facts);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const record::StoredBody body(scene.bodies[b].name, part, offsets, b, communicator);
    body.add_mesh(result);
    result.add_modes(modes_of_body(file, body, part, b));
    if (file.bounds) {
      result.note(fmt::format("/modes/{}/bounds", body.name()), bounds_facts(*file.bounds));
    }
  }
  for (const auto& reference : scene.references) {
    result.add_reference(reference.name, reference.frequencies);
  }
  result.flush();
}

void draw_modes(const std::filesystem::path& path, const mesh::Mesh& mesh, const eigenmodes::Modes& found,
                const std::vector<std::vector<double>>& shapes, const std::vector<std::string>& kinds) {
  std::vector<std::string> titles;
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    titles.push_back(fmt::format("{}: {:.5g} Hz {}", mode + 1, found.modes[mode].frequency, kinds[mode]));
  }
  web::write_page(path.string(), mode_pictures::svg_of_modes({mesh.nodes, mesh.surface}, shapes, titles));
}

}  // namespace idiophone::app
