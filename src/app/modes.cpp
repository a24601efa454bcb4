// `idiophone modes`: eigenfrequencies and mode shapes of a body, or of bodies that joints tie together.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "answer.hpp"
#include "idiophone/app/body_modes.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"
#include "idiophone/study/mode_pictures/mode_pictures.hpp"
#include "mode_bounds.hpp"
#include "mode_table.hpp"
#include "modes_file.hpp"
#include "modes_options.hpp"
#include "named_modes.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

/// The body that is wanted and those that joints tie to it, named after it where the deck has others, with the
/// references that are wanted.
scene::Scene scene_of(const ModesOptions& options, MPI_Comm communicator) {
  const scene::Scene deck = bodies::read_deck(options.deck, options.overrides, communicator);
  scene::Scene scene = scene::assembly_of(deck, scene::find_body(deck.bodies, options.body));
  if (scene.bodies.size() < deck.bodies.size()) {
    scene.name += "_" + scene.bodies.front().name;
  }
  if (!options.references.empty()) {
    scene.references = {{"references", options.references}};
  }
  return scene;
}

/// The modes of a body, and what is said of them.
struct KnownModes {
  BodyModes its;
  std::vector<double> mesh_errors;  ///< [modes] cents; empty without
  std::optional<AirOfModes> air;
  std::optional<eigenmodes::FrequencyBounds> bounds;
  std::vector<std::string> kinds;     ///< [modes] empty texts for unknown ones
  std::vector<std::string> left_out;  ///< by a signal: "8 of 20 modes"
};

constexpr const char* estimates_in_words = "estimates of the error of the mesh";

/// After a signal, those that are done. Collective.
KnownModes find(const ModesOptions& options, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                MPI_Comm communicator) {
  KnownModes known;
  WatchedWork search("modes", options.style, communicator);
  const int count = options.bounds ? eigenmodes::modes_for_bounds(options.count) : options.count;
  known.its = find_body_modes(solids, meshes,
                              {.count = count, .mass = options.mass, .shift = options.shift, .watch = search.watch()},
                              communicator);
  search.note_left_out(known.left_out);
  return known;
}

/// Collective.
void bound(const ModesOptions& options, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
           KnownModes& known, MPI_Comm communicator) {
  if (is_stopped(communicator)) {
    known.left_out.emplace_back("the bounds of all modes");
    return;
  }
  known.bounds = take_bounds(known.its, options.count, solids, meshes, communicator);
}

/// With a log where it is not possible. Collective.
void estimate(const ModesOptions& options, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
              KnownModes& known, MPI_Comm communicator) {
  if (options.estimates == eigenmodes::Estimates::none) {
    return;
  }
  if (const std::string why = eigenmodes::why_no_estimates(solids); !why.empty()) {
    parallel::on_root(communicator, [&] { spdlog::info("the error of the mesh is not estimated: {}", why); });
    return;
  }
  if (is_stopped(communicator)) {
    known.left_out.emplace_back(std::string("all ") + estimates_in_words);
    return;
  }
  WatchedWork work(estimates_in_words, options.style, communicator);
  known.mesh_errors = estimated_mesh_errors(options.estimates, options.mass, solids, meshes, known.its.shapes,
                                            communicator, work.watch());
  work.note_left_out(known.left_out);
}

/// With --in-air; else a warning where the air matters. Collective.
void add_air(const ModesOptions& options, const std::vector<mesh::Mesh>& meshes, const scene::AirProperties& air,
             KnownModes& known, MPI_Comm communicator) {
  eigenmodes::Modes& found = known.its.found;
  if (!options.in_air) {
    parallel::on_root(communicator, [&] { warn_of_air(found, known.its.shapes, meshes.front(), air); });
    return;
  }
  if (is_stopped(communicator)) {
    known.left_out.emplace_back("the air of all modes");
    return;
  }
  WatchedWork work("modes in air", options.style, communicator);
  known.air = take_air(found, known.its.shapes, meshes, air, communicator, work.watch());
  work.note_left_out(known.left_out);
  known.its.shapes = eigenmodes::whole_shapes(found, known.its.part, communicator);
}

std::vector<std::string> names_of(std::span<const scene::Body> bodies) {
  std::vector<std::string> names;
  std::ranges::transform(bodies, std::back_inserter(names), &scene::Body::name);
  return names;
}

/// Whether the modes of the only body come in pairs. Those of a wood or a crystal do not.
bool is_round(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes) {
  return meshes.size() == 1 && mode_kinds::is_round(meshes.front().nodes) &&
         std::ranges::all_of(scene.bodies.front().all_regions(), [&](const scene::MaterialRegion& region) {
           return scene.materials[region.material].is_isotropic();
         });
}

void answer(const ModesOptions& options, const KnownModes& known, const ModeTable& table) {
  const std::vector<std::string>& names = table.bodies;
  const mesh::Part& part = known.its.part;
  const int rigid_motions = known.its.found.rigid_motions;
  if (options.style == Style::json) {
    print_answer(nlohmann::json{{"body", names.front()},
                                {"bodies", names},
                                {"nodes", part.global_nodes},
                                {"elements", part.global_elements},
                                {"mass", mass_name(options.mass)},
                                {"in_air", known.air.has_value()},
                                {"rigid_motions", rigid_motions},
                                {"bounds", known.bounds ? bounds_facts(*known.bounds) : nlohmann::json()},
                                {"tolerance", options.tolerance},
                                {"stopped", known.left_out},
                                {"modes", to_json(table)}});
  } else {
    fmt::print("{} {}: {} nodes, {} elements, {} mass, {} rigid motion{}\n", names.size() > 1 ? "bodies" : "body",
               fmt::join(names, ", "), part.global_nodes, part.global_elements, mass_name(options.mass), rigid_motions,
               rigid_motions == 1 ? "" : "s");
    print(table);
  }
}

int modes(const ModesOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  check(options);
  const scene::Scene scene = scene_of(options, communicator);
  const scene::Solids solids(scene);
  const bool has_joints = !scene.joints.empty();
  if (has_joints) {
    refuse_with_joints(options, solids);
  }
  const loop::OutputLock lock(options.output, name_of_modes(scene), communicator);
  const std::vector<mesh::Mesh> meshes = bodies::read_meshes(solids, communicator);
  parallel::on_root(communicator, [&] {
    if (options.pictures) {
      mode_pictures::require_drawable(meshes.front().surface.size());
    }
  });
  KnownModes known = find(options, solids, meshes, communicator);
  if (options.bounds) {
    bound(options, solids, meshes, known, communicator);
  }
  estimate(options, solids, meshes, known, communicator);
  if (!has_joints) {
    add_air(options, meshes, scene.radiation.air, known, communicator);
  }
  known.kinds = kinds_of(known.its, scene, meshes, communicator);
  write_modes(options.output,
              {.scene = scene,
               .mass = mass_name(options.mass) + (known.air ? " with air" : ""),
               .found = known.its.found,
               .mesh_errors = known.mesh_errors,
               .bounds = known.bounds,
               .kinds = known.kinds,
               .facts = facts_of_modes(scene, meshes)},
              known.its.part, known.its.offsets, communicator);
  parallel::on_root(communicator, [&] {
    if (options.pictures) {
      draw_modes(options.output / (name_of_modes(scene) + ".svg"), meshes.front(), known.its.found, known.its.shapes,
                 known.kinds);
    }
    answer(options, known,
           {known.its.found.modes, known.mesh_errors, known.air.value_or(AirOfModes{}), known.bounds, known.kinds,
            names_of(scene.bodies), references_of(scene), options.tolerance, is_round(scene, meshes)});
    if (!known.left_out.empty()) {
      say_left_out(known.left_out);
    }
  });
  return known.left_out.empty() ? loop::exit_finished : loop::exit_resumable;
}

}  // namespace

Command modes_command() {
  return make_command<ModesOptions>("modes", "find the eigenfrequencies and mode shapes of a body", Ranks::any, declare,
                                    modes);
}

}  // namespace idiophone::app
