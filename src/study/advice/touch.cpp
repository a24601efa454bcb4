#include "idiophone/study/advice/touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace idiophone::advice {

namespace {

constexpr double collision = 1e-3;         // s: longer than blows of hard and of soft mallets last
constexpr std::size_t most_places = 5000;  // of a side; of more nodes, some are left out

/// Places of a skin that lie on the surface, as numbers of its nodes.
std::vector<Index> surface_places(const contact::Skin& skin) {
  std::vector<Index> all;
  for (Index place = 0; place < std::ssize(skin.nodes); ++place) {
    if (skin.areas[place] > 0) {
      all.push_back(place);
    }
  }
  const std::size_t stride = 1 + all.size() / most_places;
  std::vector<Index> some;
  for (std::size_t i = 0; i < all.size(); i += stride) {
    some.push_back(all[i]);
  }
  return some;
}

/// The normal of a skin at one of its nodes: of the faces there, by their areas.
Vector3 normal_at(const contact::Skin& skin, Index place, std::span<const Vector3> positions) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t c = 0; c < skin.cells.size(); ++c) {
    const auto& cell = skin.cells[c];
    for (std::size_t f = 0; f < 4; ++f) {
      if (skin.exterior[c].at(f) == 0 || cell.at(f) == place || std::ranges::find(cell, place) == cell.end()) {
        continue;
      }
      const auto at = [&](std::size_t corner) { return positions[skin.nodes[cell.at((f + corner) % 4)]]; };
      const Vector3 normal = (at(2) - at(1)).cross(at(3) - at(1));
      sum += normal.dot(at(0) - at(1)) > 0 ? Vector3(-normal) : normal;
    }
  }
  return sum;
}

Gap gap_to_shape(const contact::Skin& skin, const contact::RigidShape& shape, std::span<const Vector3> positions) {
  Gap gap{.width = std::numeric_limits<double>::infinity()};
  for (const Index place : surface_places(skin)) {
    const Vector3& x = positions[skin.nodes[place]];
    for (std::size_t part = 0; part + 1 < shape.first_plane.size(); ++part) {
      const auto planes = std::span(shape.planes)
                              .subspan(shape.first_plane[part], shape.first_plane[part + 1] - shape.first_plane[part]);
      const auto nearest = std::ranges::max_element(planes, {}, [&](const auto& plane) { return plane.distance(x); });
      if (const double distance = nearest->distance(x); distance < gap.width) {
        gap = {distance, -distance * nearest->normal, nearest->normal};
      }
    }
  }
  gap.width = std::max(gap.width, 0.0);
  return gap;
}

Gap gap_to_body(const contact::Skin& first, const contact::Skin& second, std::span<const Vector3> positions) {
  const std::vector<Index> mine = surface_places(first), others = surface_places(second);
  double nearest = std::numeric_limits<double>::infinity();  // squared
  Index from = 0, to = 0;
  for (const Index place : mine) {
    for (const Index other : others) {
      const double square = (positions[second.nodes[other]] - positions[first.nodes[place]]).squaredNorm();
      if (square < nearest) {
        nearest = square;
        from = place;
        to = other;
      }
    }
  }
  const Vector3 across = positions[second.nodes[to]] - positions[first.nodes[from]];
  const Vector3 between =
      normal_at(second, to, positions).normalized() - normal_at(first, from, positions).normalized();
  const Vector3 normal = between.isZero() ? Vector3(-across.normalized()) : Vector3(between.normalized());
  return {std::max(0.0, -across.dot(normal)), across, normal};
}

bool is_held(const scene::Body& body) {
  return !body.fixed.empty() || !body.driven.empty() || !body.supports.empty();
}

/// Whether something besides gravity moves a body, in a way that is not known before the run.
bool is_moved(const scene::Solids& solids, std::size_t body) {
  const scene::Body& moved = solids.bodies[body];
  const auto acts = [&](const auto& load) { return load.body == body; };
  return !moved.driven.empty() || std::ranges::any_of(solids.pulses, acts) ||
         std::ranges::any_of(solids.plucks, acts) || std::ranges::any_of(solids.bows, acts) ||
         std::ranges::any_of(solids.winds, [&](const scene::Wind& wind) { return wind.body.value_or(body) == body; });
}

/// The first time at which a gap closes that changes with this speed and acceleration, s; infinity for never.
double closing_time(double gap, double speed, double acceleration) {
  const double never = std::numeric_limits<double>::infinity();
  if (gap <= 0) {
    return 0.0;
  }
  const double square = speed * speed - 2 * gap * acceleration;
  if (square < 0 || (acceleration >= 0 && speed >= 0)) {
    return never;
  }
  const double divisor = std::sqrt(square) - speed;  // both roots without cancellation
  return divisor > 0 ? 2 * gap / divisor : never;
}

}  // namespace

Gap find_gap(const scene::Contact& contact, const contact::ContactSurfaces& surfaces,
             std::span<const Vector3> positions) {
  const contact::Skin& first = surfaces.skins[contact.body];
  return contact.other ? gap_to_body(first, surfaces.skins[*contact.other], positions)
                       : gap_to_shape(first, surfaces.shapes[*contact.obstacle], positions);
}

TouchingTime touching_time(const scene::Solids& solids, const scene::Contact& contact, const Gap& gap, double no_gap,
                           double duration) {
  double speed = 0.0, acceleration = 0.0;
  bool is_free = false, is_shaken = false;
  const auto add = [&](std::size_t body, double sign) {
    const scene::Body& moving = solids.bodies[body];
    is_shaken = is_shaken || is_moved(solids, body);
    if (!is_held(moving)) {
      is_free = true;
      speed += sign * moving.velocity.dot(gap.normal);
      acceleration += sign * solids.gravity.dot(gap.normal);
    }
  };
  add(contact.body, 1.0);
  if (contact.other) {
    add(*contact.other, -1.0);
  }
  const bool is_closed = gap.width <= no_gap;
  if (!is_free) {
    return {.duration = duration, .is_certain = is_closed};
  }
  const bool is_pressed = acceleration < 0;
  if (is_shaken) {
    return {.duration = duration, .is_pressed = is_pressed};
  }
  const double begin = std::min(duration, closing_time(is_closed ? 0.0 : gap.width, speed, acceleration));
  if (!is_pressed) {
    return {.begin = begin, .duration = std::min(collision, duration - begin)};
  }
  return {.begin = begin, .duration = duration - begin, .is_certain = is_closed && speed <= 0, .is_pressed = true};
}

double touching_share(const scene::Material& material, double acceleration, double extent) {
  constexpr double slow_bounce = 0.02;  // m/s
  return std::min(1.0, acceleration * extent / (std::sqrt(material.young / material.density) * slow_bounce));
}

}  // namespace idiophone::advice
