// `idiophone mesh`: the mesh of a body as a file that decks name instead of the geometry.

#include <spdlog/spdlog.h>

#include <stdexcept>

#include "command.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "other_file.hpp"

namespace idiophone::app {

namespace {

struct MeshOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::string body;              ///< of the deck; empty for the first
  std::filesystem::path output;  ///< to write; empty for BODY.mesh.h5
};

void declare(CLI::App& app, MeshOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_body(app, options.body);
  add_output_file(app, options.output, "the mesh to write, FILE.h5 (default: NAME.mesh.h5 of the body)");
}

/// The mesh must not be written over one that the deck reads.
void require_new_file(const std::filesystem::path& output, const scene::Scene& scene) {
  const auto require = [&](const std::filesystem::path& mesh) {
    require_other_file(output, mesh, "give the mesh another name with --output");
  };
  for (const scene::Body& body : scene.bodies) {
    require(body.mesh);
  }
  for (const scene::Obstacle& obstacle : scene.obstacles) {
    require(obstacle.mesh);
  }
}

int write_mesh(const MeshOptions& options) {
  if (!options.output.empty() && options.output.extension() != ".h5") {
    throw std::runtime_error(fmt::format("--output {}: the name of a mesh must end in .h5", options.output.string()));
  }
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  const scene::Body& body = scene.bodies[scene::find_body(scene.bodies, options.body)];
  const std::filesystem::path output =
      options.output.empty() ? std::filesystem::path(body.name + ".mesh.h5") : options.output;
  require_new_file(output, scene);
  const mesh::StoredMesh stored = mesh::storable_mesh(body);
  for (const std::string& note : stored.mesh.notes) {
    spdlog::warn("body {}: {}", body.name, note);
  }
  mesh::write_mesh_file(output, stored, {scene.name, program_version, scene.deck_text, scene.overrides});
  spdlog::info("{}: body {}, {} nodes, {} {} elements, {} groups", output.string(), body.name, stored.mesh.nodes.size(),
               stored.mesh.element_count(), element::name(stored.mesh.element), stored.mesh.groups.size());
  return loop::exit_finished;
}

}  // namespace

Command mesh_command() {
  return make_command<MeshOptions>("mesh", "write the mesh of a body to a file that decks name as a body's mesh",
                                   Ranks::one, declare, write_mesh);
}

}  // namespace idiophone::app
