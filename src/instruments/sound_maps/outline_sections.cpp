#include "outline_sections.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/scene/ranges.hpp"
#include "outline_checks.hpp"

namespace idiophone::sound_maps {

using namespace deck;  // values, keys and sections

/// The rule for a point of the plane: a list of two coordinates, m.
struct PlanePoint {};

/// The rule for a hole: of which type of body it is.
struct HoleRule {
  IdealBody::Type type;
};

namespace {

using eigenmodes::PlateEdge;
using Type = IdealBody::Type;

constexpr PlanePoint plane_point;
constexpr deck::Range positive_metres{.above = 0.0, .at_most = 1e3, .unit = "m"};

struct Hole {
  mesh::Contour contour;
  std::vector<PlateEdge> edges;  ///< [sides] of a plate
};

const Choices<PlateEdge>& plate_edges() {
  static const Choices<PlateEdge> choices{
      {{"free", PlateEdge::free}, {"supported", PlateEdge::supported}, {"clamped", PlateEdge::clamped}}};
  return choices;
}

/// One word for all sides, or a list of one for each.
std::vector<PlateEdge> read_edges(Section& section, std::size_t sides, PlateEdge by_default) {
  std::vector<PlateEdge> edges(sides, by_default);
  const Node* node = section.find("edges");
  if (node == nullptr || node->kind != Node::Kind::list) {
    section.optional("edges", by_default, plate_edges());
    edges.assign(sides, by_default);
  } else if (node->children.size() != sides) {
    section.mistakes().add(*node,
                           fmt::format("needs one word, or one for each of the {} sides, from the first corner on; "
                                       "found {}",
                                       sides, describe(*node)));
  } else {
    for (std::size_t side = 0; side < sides; ++side) {
      read(node->children[side], section.mistakes(), edges[side], plate_edges());
    }
  }
  return edges;
}

/// A polygon, or a circle where there is no polygon.
void read_contour(Section& section, mesh::Contour& contour) {
  const Node* polygon = section.find("polygon");
  if (polygon == nullptr) {
    section.required("radius", contour.radius, positive_metres);
    return;
  }
  section.refuse("radius", "belongs to a circle, which has no polygon");
  const bool is_read = section.optional("polygon", contour.polygon, plane_point);
  if (polygon->kind == Node::Kind::list && contour.polygon.size() < 3) {
    section.mistakes().add(*polygon, "needs at least 3 corners");
  } else if (is_read) {
    check_polygon(*polygon, contour.polygon, section.mistakes());
  }
}

/// The largest extent of an outline, m.
double diameter_of(const mesh::Contour& outline) {
  double farthest = 2.0 * outline.radius;
  for (const mesh::Point2& corner : outline.polygon) {
    for (const mesh::Point2& other : outline.polygon) {
      farthest = std::max(farthest, std::hypot(corner[0] - other[0], corner[1] - other[1]));
    }
  }
  return farthest;
}

/// A thirtieth of the diameter where it is not given, m.
void read_size(Section& section, double diameter, double& size) {
  constexpr double most_elements = 500.0;  // along the diameter
  size = diameter / 30.0;
  if (section.optional("size", size, positive_metres) && most_elements * size < diameter) {
    section.mistakes().add(*section.find("size"),
                           fmt::format("makes more than {:g} elements along the diameter; the least size is {:.3g} m",
                                       most_elements, diameter / most_elements));
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, mesh::Point2& point, const PlanePoint& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, fmt::format("expected two coordinates, [x, y], found {}", describe(node)));
  }
  const bool first = read(node.children[0], mistakes, point[0], scene::coordinate);
  return read(node.children[1], mistakes, point[1], scene::coordinate) && first;
}

static Node to_node(const mesh::Point2& point, const PlanePoint& /*rule*/) {
  Node node;
  node.kind = Node::Kind::list;
  node.children = {to_node(point[0], scene::coordinate), to_node(point[1], scene::coordinate)};
  return node;
}

static bool read(const Node& node, Mistakes& mistakes, Hole& hole, const HoleRule& rule) {
  Section section(node, mistakes);
  read_contour(section, hole.contour);
  if (hole.contour.is_circle()) {
    section.optional("at", hole.contour.centre, plane_point);
  } else {
    section.refuse("at", "belongs to a circle; the corners of a polygon say where it is");
  }
  if (rule.type == Type::plate) {
    hole.edges = read_edges(section, hole.contour.sides(), PlateEdge::free);
  } else {
    section.refuse("edges", "belongs to a plate; a membrane is held at its holes");
  }
  return section.finish();
}

void read_sides(Section& section, IdealBody& body) {
  section.required("length", body.length, positive_metres);
  section.required("width", body.width, positive_metres);
}

void read_outline(Section& section, IdealBody& body) {
  mesh::Contour& outline = body.region.outline;
  const std::size_t mistakes = section.mistakes().count();
  if (body.type == Type::plate && section.find("polygon") == nullptr && section.find("radius") == nullptr) {
    read_sides(section, body);
    outline.polygon = {{0, 0}, {body.length, 0}, {body.length, body.width}, {0, body.width}};
  } else {
    for (const char* side : {"length", "width"}) {
      section.refuse(side, "belongs to a rectangular plate, which has neither polygon nor radius");
    }
    read_contour(section, outline);
  }
  if (body.type == Type::plate) {
    body.edges = {read_edges(section, outline.sides(), PlateEdge::supported)};
  }
  std::vector<Hole> holes;
  section.optional("holes", holes, HoleRule{body.type});
  for (const Hole& hole : holes) {
    body.region.holes.push_back(hole.contour);
    if (body.type == Type::plate) {
      body.edges.push_back(hole.edges);
    }
  }
  if (section.mistakes().count() == mistakes && !holes.empty()) {
    check_holes(*section.find("holes"), body.region, section.mistakes());
  }
  read_size(section, diameter_of(outline), body.size);
}

}  // namespace idiophone::sound_maps
