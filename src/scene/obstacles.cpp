#include <algorithm>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

constexpr Range positive_length{.above = 0.0, .at_most = 1e6, .unit = "m"};

void read_box(Section& section, Obstacle& box) {
  section.required("size", box.size, positive_length);
  section.optional("rotation", box.rotation, turn);
}

void read_cylinder(Section& section, Obstacle& cylinder) {
  section.optional("direction", cylinder.direction, unit_vector);
  section.required("radius", cylinder.radius, positive_length);
  section.required("length", cylinder.length, positive_length);
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Obstacle& obstacle, const Scene& so_far) {
  using Shape = Obstacle::Shape;
  const Choices<Shape> shapes{{{"half_space", Shape::half_space},
                               {"box", Shape::box},
                               {"sphere", Shape::sphere},
                               {"cylinder", Shape::cylinder},
                               {"surface", Shape::surface}}};
  obstacle.where = node.key_where;
  if (std::ranges::find(so_far.bodies, obstacle.name, &Body::name) != so_far.bodies.end()) {
    mistakes.add(node.key_where, fmt::format("{}: a body is called '{}' already; contacts could not tell the two "
                                             "apart, so choose another name",
                                             node.path, obstacle.name));
  }
  Section section(node, mistakes);
  if (!section.required("shape", obstacle.shape, shapes)) {
    return false;  // the other keys depend on it
  }
  section.required("at", obstacle.at, coordinate);
  switch (obstacle.shape) {
    case Shape::half_space:
      section.optional("direction", obstacle.direction, unit_vector);
      break;
    case Shape::box:
      read_box(section, obstacle);
      break;
    case Shape::sphere:
      section.required("radius", obstacle.radius, positive_length);
      break;
    case Shape::cylinder:
      read_cylinder(section, obstacle);
      break;
    case Shape::surface:
      read_mesh(section, obstacle, {so_far.deck.parent_path()});
      break;
  }
  return section.finish();
}

}  // namespace idiophone::scene
