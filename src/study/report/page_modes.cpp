#include "page_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/mode_reader.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"
#include "idiophone/study/mode_pictures/mode_pictures.hpp"
#include "outer_surface.hpp"
#include "same_body.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

constexpr std::size_t most_drawn_triangles = 100'000;  // of all pictures of a body: 5 MB of the page

std::vector<Vector3> positions_of(const results::FramedBody& mesh) {
  std::vector<Vector3> nodes;
  for (std::size_t at = 0; at + 2 < mesh.nodes.size(); at += 3) {
    nodes.emplace_back(mesh.nodes[at], mesh.nodes[at + 1], mesh.nodes[at + 2]);
  }
  return nodes;
}

/// How many modes of a surface are drawn.
std::size_t pictures_of(std::size_t triangles, std::size_t modes) {
  return triangles > mode_pictures::most_triangles
             ? 0
             : std::min(modes, most_drawn_triangles / std::max<std::size_t>(1, triangles));
}

json modes_of_body(const results::StoredModes& stored, const results::FramedBody& mesh) {
  const std::vector<Vector3> nodes = positions_of(mesh);
  const std::vector<Triangle> triangles = surface_of(mesh);
  const std::vector<std::string> kinds = stored.kinds ? *stored.kinds : mode_kinds::kinds_of(nodes, stored.shapes);
  const std::size_t drawn = pictures_of(triangles.size(), stored.shapes.size());
  json modes = json::array();
  for (std::size_t mode = 0; mode < stored.shapes.size(); ++mode) {
    const std::string title = fmt::format("{}: {:.5g} Hz {}", mode + 1, stored.frequencies[mode], kinds[mode]);
    const double decay_time = stored.decay_times[mode];
    const double mesh_error = stored.mesh_errors.empty() ? std::nan("") : stored.mesh_errors[mode];
    modes.push_back(
        {{"frequency", stored.frequencies[mode]},
         {"decay_time", std::isfinite(decay_time) ? json(decay_time) : json()},
         {"mesh_error", std::isfinite(mesh_error) ? json(mesh_error) : json()},
         {"kind", kinds[mode]},
         {"picture", mode < drawn ? mode_pictures::svg_of_modes({nodes, triangles}, {stored.shapes[mode]}, {title})
                                  : std::string()}});
  }
  return {{"body", stored.body}, {"left_out", stored.shapes.size() - drawn}, {"modes", modes}};
}

void add_file(const std::filesystem::path& file, const json& run, json& all) {
  const json facts = json::parse(contents::describe_as_json(file)).value("run", json::object());
  const results::FrameReader meshes(file);
  for (const results::StoredModes& stored : results::read_modes(file)) {
    const auto mesh = std::ranges::find(meshes.bodies(), stored.body, &results::FramedBody::name);
    const std::string difference = difference_of_body(run, facts, stored.body);
    if (!difference.empty()) {
      all["notes"].push_back(fmt::format(
          "The modes of {} in {} are left out: {}. `idiophone modes` with the deck of this run makes them anew.",
          stored.body, file.filename().string(), difference));
    } else if (mesh != meshes.bodies().end()) {
      all["bodies"].push_back(modes_of_body(stored, *mesh));
    }
  }
}

}  // namespace

json modes_beside(const std::filesystem::path& result, const json& run) {
  const std::string name = result.stem().string();
  std::vector<std::string> files = {name + "_modes.h5"};
  const json bodies = run.value("bodies", json::object());  // items() refers to it
  for (const auto& [body, facts] : bodies.items()) {
    files.push_back(fmt::format("{}_{}_modes.h5", name, body));
  }
  json all = {{"bodies", json::array()}, {"notes", json::array()}};
  for (const std::string& file : files) {
    if (const auto path = result.parent_path() / file; std::filesystem::exists(path)) {
      add_file(path, run, all);
    }
  }
  return all;
}

}  // namespace idiophone::report
