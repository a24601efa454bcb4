// `idiophone modes`: eigenfrequencies and mode shapes of a body.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/app/body_modes.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/record/stored_body.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"
#include "idiophone/study/mode_pictures/mode_pictures.hpp"
#include "mode_table.hpp"

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

std::vector<partials::References> references_of(const scene::Scene& scene) {
  std::vector<partials::References> all;
  for (const auto& [name, frequencies] : scene.references) {
    all.push_back({name, frequencies});
  }
  return all;
}

/// Writes NAME_modes.svg.
void draw(const std::filesystem::path& path, const mesh::Mesh& mesh, const eigenmodes::Modes& found,
          const std::vector<std::vector<double>>& shapes, const std::vector<std::string>& kinds) {
  std::vector<std::string> titles;
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    titles.push_back(fmt::format("{}: {:.5g} Hz {}", mode + 1, found.modes[mode].frequency, kinds[mode]));
  }
  web::write_page(path.string(), mode_pictures::svg_of_modes({mesh.nodes, mesh.surface}, shapes, titles));
}

std::string name_of_result(const scene::Scene& scene) {
  return scene.name + "_modes";
}

/// What the modes are of: the deck and the mesh of the body, on rank 0.
nlohmann::json facts_of(const scene::Scene& scene, const std::string& body, const std::vector<mesh::Mesh>& meshes) {
  nlohmann::json facts;
  if (!meshes.empty()) {
    facts["deck"] = scene::resolved_deck(scene.deck, scene.overrides);
    facts["bodies"][body]["mesh_hash"] = meshes.front().hash;
  }
  return facts;
}

/// Writes NAME_modes.h5 and NAME_modes.xdmf. Collective.
/// @param facts  rank 0's
void write(const eigenmodes::Modes& found, const std::vector<double>& mesh_errors, const scene::Scene& scene,
           const record::StoredBody& body, const nlohmann::json& facts, const ModesOptions& options,
           MPI_Comm communicator) {
  const auto path = options.output / (name_of_result(scene) + ".h5");
  auto result =
      results::ResultFile::create(path, {scene.name, program_version, scene.deck_text, scene.overrides}, communicator);
  result.note("/run", facts);
  body.add_mesh(result);
  results::BodyModes modes;
  modes.body = body.name();
  modes.nodes = &body.nodes();
  modes.mass = mass_name(options.mass) + (options.in_air ? " with air" : "");
  modes.rigid_motions = found.rigid_motions;
  modes.mesh_errors = mesh_errors;
  for (const eigenmodes::Mode& mode : found.modes) {
    modes.frequencies.push_back(mode.frequency);
    modes.damping_ratios.push_back(mode.damping_ratio);
    modes.decay_times.push_back(mode.decay_time);
    modes.shapes.emplace_back(mode.shape);
  }
  result.add_modes(modes);
  for (const auto& reference : scene.references) {
    result.add_reference(reference.name, reference.frequencies);
  }
  result.flush();
}

int modes(const ModesOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  check(options);
  const scene::Scene scene = scene_of(options, communicator);
  const scene::Solids solids = scene::Solids(scene).alone(scene::find_body(scene.bodies, options.body));
  const loop::OutputLock lock(options.output, name_of_result(scene), communicator);
  const std::vector<mesh::Mesh> meshes = bodies::read_meshes(solids.bodies, communicator);
  parallel::on_root(communicator, [&] {
    if (options.pictures) {
      mode_pictures::require_drawable(meshes.front().surface.size());
    }
  });
  BodyModes its = find_body_modes(solids, meshes,
                                  {.count = options.count, .mass = options.mass, .shift = options.shift}, communicator);
  const mesh::Part& part = its.part;
  eigenmodes::Modes& found = its.found;
  std::vector<std::vector<double>>& shapes = its.shapes;
  const std::vector<double> mesh_errors =
      estimated_mesh_errors(options.estimates, options.mass, solids, meshes, shapes, communicator);
  AirOfModes air;
  if (options.in_air) {
    air = take_air(found, shapes, meshes, scene.radiation.air, communicator);
    shapes = eigenmodes::whole_shapes(found, part, communicator);
  } else if (parallel::is_root(communicator)) {
    warn_of_air(found, shapes, meshes.front(), scene.radiation.air);
  }
  const std::string& body = solids.bodies.front().name;
  write(found, mesh_errors, scene, record::StoredBody(body, part, its.offsets, 0, communicator),
        facts_of(scene, body, meshes), options, communicator);
  std::vector<std::string> kinds;
  parallel::on_root(communicator, [&] {
    kinds = mode_kinds::kinds_of(meshes.front().nodes, shapes);
    if (options.pictures) {
      draw(options.output / (name_of_result(scene) + ".svg"), meshes.front(), found, shapes, kinds);
    }
  });
  const ModeTable table = {found.modes, mesh_errors, air, kinds, references_of(scene), options.tolerance};
  if (parallel::is_root(communicator) && options.style == Style::json) {
    const nlohmann::json answer = {{"body", body},
                                   {"nodes", part.global_nodes},
                                   {"elements", part.global_elements},
                                   {"mass", mass_name(options.mass)},
                                   {"in_air", options.in_air},
                                   {"rigid_motions", found.rigid_motions},
                                   {"tolerance", options.tolerance},
                                   {"modes", to_json(table)}};
    print_answer(answer);
  } else if (parallel::is_root(communicator)) {
    fmt::print("body {}: {} nodes, {} elements, {} mass, {} rigid motion{}\n", body, part.global_nodes,
               part.global_elements, mass_name(options.mass), found.rigid_motions, found.rigid_motions == 1 ? "" : "s");
    print(table);
  }
  return loop::exit_finished;
}

}  // namespace

Command modes_command() {
  return make_command<ModesOptions>("modes", "find the eigenfrequencies and mode shapes of a body", Ranks::any, declare,
                                    modes);
}

}  // namespace idiophone::app
