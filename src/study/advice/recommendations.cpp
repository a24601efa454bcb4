#include "idiophone/study/advice/recommendations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/element/deck_keys.hpp"
#include "idiophone/run/loop/facts.hpp"

namespace idiophone::advice {

namespace {

std::optional<accuracy::Recommendation> recommended(const bodies::Preparation& ready, std::size_t b, element::Kind kind,
                                                    const accuracy::Accuracy& wanted) {
  if (accuracy::without_rules(ready.scene.bodies[b], ready.statistics[b])) {
    return {};
  }
  const mesh::Statistics& mesh = ready.statistics[b];
  return accuracy::recommend(kind, accuracy::extents(mesh), mesh.volume,
                             ready.scene.materials[ready.scene.bodies[b].material], wanted);
}

/// Processor time of a second of sound with the present mesh without mass scaling, s: recommended meshes have none.
double present_seconds(const bodies::Preparation& ready, std::size_t b) {
  return accuracy::seconds_of(ready.statistics[b], ready.scene.bodies[b].element, ready.initial_state.steps[b].step) *
         ready.initial_state.scaling[b].gain;
}

/// What a body has that recommendations leave out, by the deck's keys.
std::vector<std::string> left_out(const scene::Body& body) {
  std::vector<std::string> keys;
  if (!body.fixed.empty()) {
    keys.emplace_back("fixed");
  }
  if (!body.driven.empty()) {
    keys.emplace_back("driven");
  }
  if (body.mass_scaling) {
    keys.emplace_back("mass_scaling");
  }
  if (!body.regions.empty()) {
    keys.emplace_back(body.has_layers() ? "layers" : "materials");
  }
  return keys;
}

std::string description(const accuracy::Recommendation& found, double present) {
  return fmt::format(
      "{}, cells of {:.3g} m, {} layer{}: about {:.1f} cents, {:.3g} CPU-seconds per second of sound, "
      "{:.3g} times the present mesh",
      element::deck_keys(found.cells.type), found.cells.size, found.layers, found.layers == 1 ? "" : "s", found.error,
      found.seconds, found.seconds / present);
}

}  // namespace

void print_recommendation(const bodies::Preparation& ready, std::size_t b, const accuracy::Accuracy& wanted) {
  if (!ready.initial_state.steps[b].is_limited()) {
    return;  // held rigid: no pitch
  }
  if (const auto kind = accuracy::without_rules(ready.scene.bodies[b], ready.statistics[b])) {
    spdlog::info(
        "body {}: no mesh is recommended for {}, as there is no rule for their pitch: make the mesh finer until the "
        "errors that `idiophone modes` estimates are small enough",
        ready.scene.bodies[b].name, *kind);
    return;
  }
  const auto hex = recommended(ready, b, element::Kind::hex, wanted);
  const auto tet10 = recommended(ready, b, element::Kind::tet10, wanted);
  const bool is_swept = element::lines_through(ready.scene.bodies[b].element) > 0;
  const std::string start = fmt::format("body {}: for {:.3g} cents up to {:.0f} Hz", ready.scene.bodies[b].name,
                                        wanted.cents, wanted.frequency);
  const double present = present_seconds(ready, b);
  const bool hex_is_cheaper = hex && (!tet10 || hex->seconds < tet10->seconds);
  if (hex_is_cheaper) {
    spdlog::info("{}{}: {}", start, is_swept ? "" : ", if it can be swept", description(*hex, present));
  }
  if (!(hex_is_cheaper && is_swept)) {
    spdlog::info(
        "{}{}: {}", start, hex_is_cheaper ? ", otherwise" : "",
        tet10 ? description(*tet10, present) : "no mesh of tet10 with at most 500 cells along it and 8 layers");
  }
  if (const auto keys = left_out(ready.scene.bodies[b]); !keys.empty()) {
    spdlog::info("body {}: the recommendation leaves these keys out: {} (docs/use/mesh_guide.md)",
                 ready.scene.bodies[b].name, fmt::join(keys, ", "));
  }
}

nlohmann::json recommendation_facts(const bodies::Preparation& ready, std::size_t b, const accuracy::Accuracy& wanted) {
  nlohmann::json facts = nlohmann::json::object();
  if (!ready.initial_state.steps[b].is_limited()) {
    return facts;
  }
  facts["left_out"] = left_out(ready.scene.bodies[b]);
  for (const element::Kind kind : {element::Kind::hex, element::Kind::tet10}) {
    const auto found = recommended(ready, b, kind, wanted);
    if (!found) {
      continue;
    }
    const element::Type type = found->cells.type;
    auto& entry = facts[std::string(element::name(type))];
    entry = {{"size", found->cells.size},
             {"layers", found->layers},
             {"error", found->error},
             {"processor_seconds", found->seconds},
             {"relative_cost", found->seconds / present_seconds(ready, b)}};
    loop::add_order(entry, type);
  }
  return facts;
}

}  // namespace idiophone::advice
