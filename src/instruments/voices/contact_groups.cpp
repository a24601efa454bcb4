// Which bodies touch each other.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "contact_group.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"

namespace idiophone::voices {

namespace {

/// The points of a contact, with the directions of the force on their bodies.
struct DirectedPoint {
  score::PointOfBody point;
  Vector3 direction;
};

std::vector<DirectedPoint> points_of(const score::BodyContact& contact) {
  std::vector<DirectedPoint> points = {{.point = contact.point, .direction = contact.direction}};
  if (contact.other) {
    points.push_back({.point = *contact.other, .direction = -contact.direction});
  }
  return points;
}

/// Which bodies touch each other, also through others.
DisjointSets touching(std::size_t bodies, std::span<const score::BodyContact> contacts) {
  DisjointSets sets(bodies);
  for (const score::BodyContact& contact : contacts) {
    if (contact.other) {
      sets.join(static_cast<Index>(contact.point.body), static_cast<Index>(contact.other->body));
    }
  }
  return sets;
}

void require_room(std::span<const std::unique_ptr<MapBody>> bodies, std::span<const score::BodyContact> contacts) {
  constexpr std::size_t most = resonators::PointContacts::most_staying;
  std::vector<std::size_t> points(bodies.size());
  for (const score::BodyContact& contact : contacts) {
    for (const DirectedPoint& one : points_of(contact)) {
      if (++points[one.point.body] > most) {
        throw std::runtime_error(
            fmt::format("contacts: {} has more than {} points of contact", bodies[one.point.body]->map().body, most));
      }
    }
  }
}

resonators::ElasticContact::Mass mass_of(const score::BodyContact& contact) {
  return contact.mass ? resonators::ElasticContact::Mass{.mass = contact.mass->mass, .load = contact.mass->load}
                      : resonators::ElasticContact::Mass{};
}

/// @param members  of the group, in its order
StageContact stage_contact(const score::BodyContact& contact, std::span<const std::unique_ptr<MapBody>> bodies,
                           std::span<const std::size_t> members, int rate) {
  std::vector<StageContact::Point> points;
  for (const auto& [point, direction] : points_of(contact)) {
    const auto number = static_cast<std::size_t>(std::ranges::find(members, point.body) - members.begin());
    points.push_back({.body = number, .point = bodies[point.body]->contact_point(point.at, direction)});
  }
  return {
      .contact = std::make_unique<resonators::ElasticContact>(contact.elasticity, contact.gap, mass_of(contact), rate),
      .points = std::move(points)};
}

}  // namespace

std::vector<std::unique_ptr<ContactGroup>> contact_groups(std::span<const std::unique_ptr<MapBody>> bodies,
                                                          std::span<const score::BodyContact> contacts,
                                                          std::size_t channels, int rate) {
  require_room(bodies, contacts);
  DisjointSets sets = touching(bodies.size(), contacts);
  const auto first_of = [&](std::size_t body) { return static_cast<std::size_t>(sets.root(static_cast<Index>(body))); };
  std::vector<std::unique_ptr<ContactGroup>> groups;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (first_of(body) != body) {
      continue;
    }
    std::vector<std::size_t> members;
    std::vector<Player*> players;
    for (std::size_t member = body; member < bodies.size(); ++member) {
      if (first_of(member) == body) {
        members.push_back(member);
        players.push_back(&bodies[member]->player());
      }
    }
    std::vector<StageContact> stage_contacts;
    for (const score::BodyContact& contact : contacts) {
      if (first_of(contact.point.body) == body) {
        stage_contacts.push_back(stage_contact(contact, bodies, members, rate));
      }
    }
    groups.push_back(std::make_unique<ContactGroup>(std::move(players), std::move(stage_contacts), channels, rate));
  }
  return groups;
}

}  // namespace idiophone::voices
