#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <numeric>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/triangle_point.hpp"

namespace idiophone::mesh {

namespace {

TrianglePoints corners_of(const Mesh& mesh, const Triangle& triangle) {
  TrianglePoints corners;
  std::ranges::transform(triangle, corners.begin(), [&](Index node) { return mesh.nodes[node]; });
  return corners;
}

/// The point of the surface that is nearest to a place.
struct Foot {
  Triangle triangle{};
  TrianglePoints corners;
  Vector3 weights = Vector3::Zero();
  Vector3 position = Vector3::Zero();
};

/// Of equally near triangles, the first.
Foot foot_on_surface(const Mesh& mesh, const Vector3& point) {
  Foot best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.outer_surface()) {
    const TrianglePoints corners = corners_of(mesh, triangle);
    const Vector3 weights = nearest_weights(corners, point);
    const Vector3 position = at_weights(corners, weights);
    if (const double distance = (position - point).norm(); distance < smallest) {
      smallest = distance;
      best = {.triangle = triangle, .corners = corners, .weights = weights, .position = position};
    }
  }
  return best;
}

/// A patch of the nodes with a share above zero, scaled so that all shares add up to 1.
Patch patch_of(const std::vector<std::pair<Index, double>>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0,
                                     [](double total, const auto& entry) { return total + entry.second; });
  Patch patch;
  for (const auto& [node, weight] : weights) {
    if (weight > 0.0) {
      patch.nodes.push_back(node);
      patch.shares.push_back(weight / sum);
    }
  }
  return patch;
}

Patch point_patch(const Foot& foot) {
  std::vector<std::pair<Index, double>> weights;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    weights.emplace_back(foot.triangle[corner], foot.weights[static_cast<Index>(corner)]);
  }
  std::ranges::sort(weights);
  return patch_of(weights);
}

Patch disc_patch(const Mesh& mesh, const scene::PatchPlace& place) {
  const std::vector<double> area = nodal_areas(mesh.outer_surface(), mesh.nodes);
  std::vector<std::pair<Index, double>> weights;
  for (std::size_t node = 0; node < area.size(); ++node) {
    if (area[node] > 0.0 && (mesh.nodes[node] - place.at).norm() <= place.radius) {
      weights.emplace_back(static_cast<Index>(node), area[node]);
    }
  }
  return patch_of(weights);
}

}  // namespace

Patch find_patch(const Mesh& mesh, const scene::PatchPlace& place) {
  const Foot foot = foot_on_surface(mesh, place.at);
  const double distance = (foot.position - place.at).norm();
  if (!(distance <= 0.1 * longest_edge(foot.corners))) {
    throw deck::DeckError(place.where, fmt::format("the point {} m isn't on the body's surface; the nearest point that "
                                                   "is, {:.3g} m away, is {}",
                                                   to_text(place.at), distance, to_text(foot.position)));
  }
  Patch patch = place.radius > 0.0 ? disc_patch(mesh, place) : point_patch(foot);
  if (patch.nodes.empty()) {
    throw deck::DeckError(place.where,
                          fmt::format("no surface node lies within {:.3g} m of {}: use a radius above the triangles' "
                                      "edges, which are {:.3g} m there, or 0 for the one triangle at the point",
                                      place.radius, to_text(place.at), longest_edge(foot.corners)));
  }
  return patch;
}

}  // namespace idiophone::mesh
