#include "repair.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "idiophone/foundation/types.hpp"
#include "part_parameters.hpp"
#include "refusal.hpp"
#include "surface_wrap.hpp"
#include "triangles.hpp"

namespace idiophone::mesher {

namespace {

using Vertices = Eigen::Map<const Eigen::Matrix3Xd>;

Vertices vertices_of(const Surface& surface) {
  return {surface.coordinates.data(), 3, static_cast<Eigen::Index>(surface.coordinates.size() / 3)};
}

/// The places of the present model's nodes, by their tags.
std::map<std::size_t, Vector3> node_places() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::map<std::size_t, Vector3> places;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    places.emplace(tags[i], Vector3(&coordinates[3 * i]));
  }
  return places;
}

/// The triangles of the present model, with their vertices only. Vertices at one place are one.
Surface present_surface() {
  constexpr int triangle = 2;  // gmsh's number of the type
  gmsh::model::mesh::removeDuplicateNodes();
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(triangle, tags, nodes);
  if (nodes.empty()) {
    throw Refusal("it has no triangles");
  }
  const std::map<std::size_t, Vector3> places = node_places();
  std::map<std::size_t, std::size_t> numbers;
  Surface surface;
  for (const std::size_t node : nodes) {
    const auto [found, is_new] = numbers.try_emplace(node, numbers.size());
    surface.triangles.push_back(found->second);
    if (is_new) {
      const Vector3& place = places.at(node);
      if (!place.allFinite()) {
        throw Refusal("it is damaged: a vertex is nowhere (its coordinates are not finite)");
      }
      surface.coordinates.insert(surface.coordinates.end(), place.begin(), place.end());
    }
  }
  return surface;
}

double longest_side(const Surface& surface) {
  const Vertices vertices = vertices_of(surface);
  return (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).maxCoeff();
}

/// By the divergence theorem; nothing for a surface that is not closed, or whose triangles do not face one way.
std::optional<double> volume_of(const Surface& surface) {
  const Vertices vertices = vertices_of(surface);
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  double volume = 0.0;
  for (std::size_t first = 0; first < surface.triangles.size(); first += 3) {
    const std::array corners = {surface.triangles[first], surface.triangles[first + 1], surface.triangles[first + 2]};
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{corners.at(i), corners.at((i + 1) % 3)}];
    }
    volume += vertices.col(corners[0]).dot(vertices.col(corners[1]).cross(vertices.col(corners[2]))) / 6.0;
  }
  const bool is_closed = std::ranges::all_of(uses, [&](const auto& edge) {
    const auto opposite = uses.find({edge.first.second, edge.first.first});
    return edge.second == 1 && opposite != uses.end() && opposite->second == 1;
  });
  return is_closed ? std::optional(std::abs(volume)) : std::nullopt;
}

struct Wrap {
  Surface surface;
  double gap = 0.0;
};

/// All lengths are in the file's unit.
/// @param size  of the elements
/// @param gap   0: the narrowest that gives the surface an inside
Wrap wrap_of(const Surface& damaged, double size, double gap) {
  const double length = longest_side(damaged);
  if (!(length > 0.0)) {
    throw Refusal("all of its triangles are at one place");
  }
  const double narrowest = gap > 0.0 ? gap : std::max(size / 2.0, length / 60.0);
  const double widest = gap > 0.0 ? gap : std::max(narrowest, length / 5.0);
  const double edge = size / 2.0;  // collapsing to this length leaves few edges longer than `size`
  double tried = narrowest / 2.0;
  do {
    tried *= 2.0;
    if (Surface surface = wrapped(damaged, {.gap = tried, .edge = edge}); !surface.triangles.empty()) {
      return {.surface = std::move(surface), .gap = tried};
    }
  } while (2.0 * tried <= widest);
  throw Refusal(fmt::format(
      "its surface has no inside, although openings up to {:.3g} times its length are closed. Close wider ones by the "
      "key `gap` of `meshing`. A sheet needs a `thickness` instead",
      tried / length));
}

std::string note_on(const Surface& damaged, const Wrap& wrap, double scale) {
  const double volume = volume_of(wrap.surface).value();
  const std::optional<double> before = volume_of(damaged);
  const std::string change = before
                                 ? fmt::format("{:+.2f} % of what the file's triangles enclose (overlaps count twice)",
                                               100.0 * (volume / *before - 1.0))
                                 : "while the file's triangles are not closed and enclose nothing";
  return fmt::format(
      "a closed surface of {} triangles replaces the file's {}. It closes openings up to {:.3g} m and encloses {:.5g} "
      "m3, {}",
      wrap.surface.triangles.size() / 3, damaged.triangles.size() / 3, scale * wrap.gap, std::pow(scale, 3) * volume,
      change);
}

std::string in_metres(const std::array<double, 3>& place, double scale) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", scale * place[0], scale * place[1], scale * place[2]);
}

void replace_model(Surface surface) {
  gmsh::model::remove();
  gmsh::model::add("wrap");
  for (std::size_t& vertex : surface.triangles) {
    ++vertex;
  }
  add_triangles(surface.coordinates, surface.triangles);
}

}  // namespace

std::vector<std::string> wrap_triangles(const mesh::MeshingRequest& request) {
  if (request.dimension != 3) {
    throw Refusal(
        "`repair` makes a solid of it, but the body has a `thickness`, which makes a wall. Leave one of them out");
  }
  const double scale = scale_of(request);
  const Surface damaged = present_surface();
  const double size = size_of(request).value_or(longest_side(damaged) / 20.0);
  Wrap wrap = wrap_of(damaged, size, request.gap / scale);
  if (const auto place = crossing(wrap.surface)) {
    throw Refusal(fmt::format(
        "the closed surface that replaces its triangles would cross itself at {}, because walls there are thinner than "
        "the elements. Give a smaller `size`, or a wider `gap`",
        in_metres(*place, scale)));
  }
  std::vector<std::string> notes = {note_on(damaged, wrap, scale)};
  replace_model(std::move(wrap.surface));
  return notes;
}

void explain_failure(double scale) {
  const auto place = crossing(present_surface());
  if (!place) {
    throw std::runtime_error("no triangles cross each other");
  }
  throw Refusal(
      fmt::format("its surface crosses itself, for example at {}. {}", in_metres(*place, scale), how_to_repair));
}

}  // namespace idiophone::mesher
