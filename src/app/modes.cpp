// `idiophone modes`: eigenfrequencies and mode shapes of a body.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/app/body_modes.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/record/stored_body.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"
#include "idiophone/study/mode_pictures/mode_pictures.hpp"
#include "mode_bounds.hpp"
#include "mode_table.hpp"
#include "modes_file.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct ModesOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string body;  ///< empty for the first
  int count = 20;    ///< of modes
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  std::optional<double> shift;     ///< Hz below zero
  std::vector<double> references;  ///< Hz; empty for the deck's own
  double tolerance = 100.0;        ///< cents, of matches with references
  bool in_air = false;
  bool bounds = false;
  bool pictures = false;
  eigenmodes::Estimates estimates = eigenmodes::Estimates::quick;  ///< of the mesh's error
  Style style = Style::text;
};

void declare(CLI::App& app, ModesOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_body(app, options.body);
  app.add_option("--modes", options.count, "number of modes, the lowest")->capture_default_str();
  add_renamed(app, "--count", "--modes");
  add_mass(app, options.mass, "lumped, as the motion has it, or consistent");
  app.add_option("--shift", options.shift,
                 "Hz below zero from where the search begins (default: from the body's size)");
  app.add_option("--references", options.references, "Hz,Hz,...: to compare with (default: the deck's)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--tolerance", options.tolerance, "cents, of matches with references")->capture_default_str();
  app.add_flag("--in-air", options.in_air, "with the mass and the resistance of the air (docs/use/modes.md)");
  add_estimates(app, options.estimates);
  const auto ask_for_bounds = [&options] {
    options.bounds = true;
    options.mass = eigenmodes::MassMatrix::consistent;
  };
  app.add_flag_callback("--bounds", ask_for_bounds,
                        "with two-sided bounds, by the consistent mass (docs/method/bounds.md)")
      ->excludes("--mass")
      ->excludes("--in-air");
  app.add_flag("--pictures", options.pictures, "writes pictures of the shapes, too, as NAME_modes.svg");
  add_output_folder(app, options.output, "folder of the results");
  add_json(app, options.style);
}

void check(const ModesOptions& options) {
  const auto refuse = [](const std::string& option, const std::string& wanted, double value) {
    throw std::runtime_error(fmt::format("{} must be {}, not {}", option, wanted, value));
  };
  if (options.count < 1) {
    refuse("--modes", "at least 1", options.count);
  }
  if (options.shift && !(*options.shift >= 0 && std::isfinite(*options.shift))) {
    refuse("--shift", "0 Hz or above", *options.shift);
  }
  if (!(options.tolerance > 0)) {
    refuse("--tolerance", "above 0 cents", options.tolerance);
  }
  for (const double frequency : options.references) {
    if (!(frequency > 0 && std::isfinite(frequency))) {
      refuse("--references", "frequencies above 0 Hz", frequency);
    }
  }
}

/// The scene, named after one of its bodies where it has several, with the references that are wanted.
scene::Scene scene_of(const ModesOptions& options, MPI_Comm communicator) {
  scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  const std::size_t body = scene::find_body(scene.bodies, options.body);
  if (scene.bodies.size() > 1) {
    scene.name += "_" + scene.bodies[body].name;
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

/// Collective.
void estimate(const ModesOptions& options, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
              KnownModes& known, MPI_Comm communicator) {
  if (options.estimates != eigenmodes::Estimates::none && is_stopped(communicator)) {
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

void answer(const ModesOptions& options, const std::string& body, const KnownModes& known, const ModeTable& table) {
  const mesh::Part& part = known.its.part;
  const int rigid_motions = known.its.found.rigid_motions;
  if (options.style == Style::json) {
    print_answer(nlohmann::json{{"body", body},
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
    fmt::print("body {}: {} nodes, {} elements, {} mass, {} rigid motion{}\n", body, part.global_nodes,
               part.global_elements, mass_name(options.mass), rigid_motions, rigid_motions == 1 ? "" : "s");
    print(table);
  }
}

int modes(const ModesOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  check(options);
  const scene::Scene scene = scene_of(options, communicator);
  const scene::Solids solids = scene::Solids(scene).alone(scene::find_body(scene.bodies, options.body));
  const loop::OutputLock lock(options.output, name_of_modes(scene), communicator);
  const std::vector<mesh::Mesh> meshes = bodies::read_meshes(solids.bodies, communicator);
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
  add_air(options, meshes, scene.radiation.air, known, communicator);
  const std::string& body = solids.bodies.front().name;
  write_modes(options.output,
              {.scene = scene,
               .mass = mass_name(options.mass) + (known.air ? " with air" : ""),
               .found = known.its.found,
               .mesh_errors = known.mesh_errors,
               .bounds = known.bounds,
               .facts = facts_of_modes(scene, body, meshes)},
              record::StoredBody(body, known.its.part, known.its.offsets, 0, communicator), communicator);
  parallel::on_root(communicator, [&] {
    const auto kinds = mode_kinds::kinds_of(meshes.front().nodes, known.its.shapes);
    if (options.pictures) {
      draw_modes(options.output / (name_of_modes(scene) + ".svg"), meshes.front(), known.its.found, known.its.shapes,
                 kinds);
    }
    answer(options, body, known,
           {known.its.found.modes, known.mesh_errors, known.air.value_or(AirOfModes{}), known.bounds, kinds,
            references_of(scene), options.tolerance});
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
