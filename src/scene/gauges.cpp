#include <algorithm>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Gauge::Point& point, const Choices<std::size_t>& bodies) {
  Section section(node, mistakes);
  if (bodies.words.size() > 1) {
    section.required("body", point.body, bodies);
  } else {
    section.optional("body", point.body, bodies);
  }
  read_place(section, point.place);
  return section.finish();
}

namespace {

/// Whether the points are as many as the quantity needs, all different, and those of a strain on one body.
void check_points(const Node& node, Mistakes& mistakes, const Gauge& gauge) {
  const std::size_t needed = Gauge::points_of(gauge.quantity);
  if (gauge.points.size() != needed) {
    mistakes.add(node, fmt::format("this type has {} points, found {}", needed, gauge.points.size()));
    return;
  }
  for (std::size_t i = 0; i < needed; ++i) {
    const Gauge::Point &one = gauge.points[i], &next = gauge.points[(i + 1) % needed];
    if (one.body == next.body && one.place.at == next.place.at) {
      mistakes.add(node, "two of the points are the same");
      return;
    }
    if (gauge.quantity == Gauge::Quantity::strain && one.body != next.body) {
      mistakes.add(node, "a strain is that of one body; choose type distance for two bodies");
      return;
    }
  }
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Gauge& gauge, const Scene& so_far) {
  using Quantity = Gauge::Quantity;
  const Choices<Quantity> quantities{{{"distance", Quantity::distance},
                                      {"strain", Quantity::strain},
                                      {"angle", Quantity::angle},
                                      {"curvature", Quantity::curvature}}};
  Section section(node, mistakes);
  const bool has_type = section.required("type", gauge.quantity, quantities);
  if (section.required("points", gauge.points, names_of(so_far.bodies)) && has_type) {
    check_points(*section.find("points"), mistakes, gauge);
  }
  return section.finish();
}

}  // namespace idiophone::scene
