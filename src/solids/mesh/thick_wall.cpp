#include "thick_wall.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "directors.hpp"
#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::mesh {

namespace {

/// The smallest |x| with a + b x + c x^2 = 0; infinite where there is none.
double nearest_root(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  const double larger = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b)) / 2;  // c times the other root
  return discriminant < 0.0 || larger == 0.0 ? std::numeric_limits<double>::infinity() : std::abs(a / larger);
}

/// Requires the wall's volume element, (x,1 + z d,1) x (x,2 + z d,2) . d at a height z, to keep its sign up to z = h/2.
void check_thickness(const scene::Body& body, const SurfaceMesh& surface, const std::vector<Vector3>& directors) {
  const QuadrilateralGradient gradient(surface.order);
  double limit = std::numeric_limits<double>::infinity();  // m
  Index culprit = 0;
  for (Index number = 0; number < std::ssize(surface.element_tags); ++number) {
    const auto nodes = surface.quadrilateral(number);
    for (Index at = 0; at < std::ssize(nodes); ++at) {
      const auto [x1, x2] = gradient(nodes, at, surface.nodes);
      const auto [d1, d2] = gradient(nodes, at, directors);
      const Vector3& d = directors[nodes[at]];
      const double thickest =
          2 * nearest_root(x1.cross(x2).dot(d), (x1.cross(d2) + d1.cross(x2)).dot(d), d1.cross(d2).dot(d));
      if (thickest < limit) {
        limit = thickest;
        culprit = number;
      }
    }
  }
  if (!(*body.thickness < limit)) {
    throw deck::DeckError(
        body.thickness_where,
        fmt::format("a wall of {:.6g} m folds in {}, because the surface curves or bends too sharply there: the "
                    "thickness must be below {:.6g} m",
                    *body.thickness, quadrilateral_text(surface, culprit), limit));
  }
}

/// Thickness of each layer of the wall, m.
std::vector<double> layers_of(const scene::Body& body) {
  std::vector<double> layers;
  std::ranges::transform(body.regions, std::back_inserter(layers), &scene::MaterialRegion::thickness);
  return body.has_layers() ? layers : std::vector{*body.thickness};
}

/// Heights of the nodes of a column over the surface, evenly spaced within a layer, m. [order x layers + 1]
std::vector<double> heights_of(const scene::Body& body, int order) {
  std::vector<double> heights;
  double below = 0.0;
  for (const double layer : layers_of(body)) {
    const double middle = below + layer / 2 - *body.thickness / 2;
    for (int k = heights.empty() ? 0 : 1; k <= order; ++k) {
      heights.push_back(middle + (static_cast<double>(k) / order - 0.5) * layer);
    }
    below += layer;
  }
  return heights;
}

/// Nodes of the column of each of the surface's nodes: [nodes + 1] where each begins.
/// @param count  of nodes in a column
std::vector<Index> columns(const std::vector<Vector3>& directors, std::size_t count) {
  std::vector<Index> begins = {0};
  for (const Vector3& director : directors) {
    begins.push_back(begins.back() + (director.isZero(0.0) ? 1 : static_cast<Index>(count)));
  }
  return begins;
}

/// Appends the hexahedra of one layer.
/// @param begins  of the columns
void add_layer(const SurfaceMesh& surface, const std::vector<Index>& begins, Index layer, GmshMesh& result) {
  result.element_tags.insert(result.element_tags.end(), surface.element_tags.begin(), surface.element_tags.end());
  for (Index number = 0; number < std::ssize(surface.element_tags); ++number) {
    for (Index k = layer * surface.order; k <= (layer + 1) * surface.order; ++k) {
      for (const Index node : surface.quadrilateral(number)) {
        result.mesh.elements.push_back(begins[node] + k);
      }
    }
  }
}

}  // namespace

GmshMesh thick_wall(const scene::Body& body, const SurfaceMesh& surface) {
  const std::vector<Vector3> directors = directors_of(body, surface);
  check_thickness(body, surface, directors);
  const std::vector<double> heights = heights_of(body, surface.order);
  const std::vector<Index> begins = columns(directors, heights.size());

  GmshMesh result;
  Mesh& wall = result.mesh;
  wall.element = element::hex(surface.order, surface.order);
  for (std::size_t node = 0; node < surface.nodes.size(); ++node) {
    const Index count = begins[node + 1] - begins[node];
    for (Index k = 0; k < count; ++k) {
      wall.nodes.emplace_back(surface.nodes[node] + heights[k] * directors[node]);
      result.node_tags.push_back(surface.node_tags[node]);
    }
  }
  for (Index layer = 0; layer < std::ssize(layers_of(body)); ++layer) {
    add_layer(surface, begins, layer, result);
    if (body.has_layers()) {
      wall.regions.insert(wall.regions.end(), surface.element_tags.size(), layer);
    }
  }
  for (const auto& [name, nodes] : surface.groups) {
    auto& group = wall.groups[name];
    for (const Index node : nodes) {
      for (Index number = begins[node]; number < begins[node + 1]; ++number) {
        group.push_back(number);
      }
    }
  }
  return result;
}

}  // namespace idiophone::mesh
