#include "idiophone/air/propagation/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "idiophone/foundation/deck/mistakes.hpp"

namespace idiophone::propagation {

namespace {

constexpr double parts_of_wavelength = 20.0;
constexpr double near_frequency = 1000.0;  // Hz

/// A listener at a time.
struct Moment {
  double time = 0.0;  ///< s
  Vector3 position;   ///< m
};

/// The beginning, then a hundred moments of its path.
std::vector<Moment> moments_of(const scene::Listener& listener, const scene::Receiver& receiver) {
  std::vector<Moment> moments = {{0.0, listener.place(receiver, 0.0).position}};
  constexpr int count = 100;
  for (int i = 0; listener.path && i <= count; ++i) {
    const double last = listener.path->points.back().time;
    const double time = last * i / count;
    if (time > 0.0) {
      moments.push_back({time, listener.place(receiver, time).position});
    }
  }
  return moments;
}

/// The deck's place of a body; none for a recorded one.
deck::Location where_of(const scene::Acoustics& acoustics, const std::string& name) {
  const auto body = std::ranges::find(acoustics.bodies, name, &scene::Body::name);
  return body != acoustics.bodies.end() ? body->where : deck::Location{};
}

/// Adds to warnings and mistakes what it finds about one scene.
class Placement {
 public:
  Placement(const scene::Acoustics& acoustics, const Surroundings& around, Hearing hearing)
      : acoustics_(acoustics), around_(around), hearing_(hearing) {}

  std::vector<std::string> warnings() {
    for (std::size_t body = 0; body < around_.bodies; ++body) {
      check_floor(body);
      check_room(body);
    }
    for (const scene::Listener& listener : acoustics_.listeners) {
      const std::size_t members = listener.head ? 1 : listener.receivers.size();
      for (std::size_t r = 0; r < members; ++r) {
        const scene::Receiver& receiver = listener.receivers[r];
        check(listener, listener.head ? listener.name : receiver.channel, moments_of(listener, receiver));
      }
    }
    mistakes_.raise();
    return warnings_;
  }

 private:
  /// Lowest and highest value of a function of a body's corners.
  template <class Value>
  [[nodiscard]] std::pair<double, double> range(std::size_t body, const Value& value) const {
    std::pair<double, double> found = {std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity()};
    for (Index t = around_.first_triangle[body]; t < around_.first_triangle[body + 1]; ++t) {
      for (const Vector3& corner : around_.corners(t)) {
        found.first = std::min(found.first, value(corner));
        found.second = std::max(found.second, value(corner));
      }
    }
    return found;
  }

  /// The floor reflects what is above it; what is below would be heard as if it were not there.
  void check_floor(std::size_t body) {
    const auto& floor = acoustics_.radiation.floor;
    if (!floor) {
      return;
    }
    const auto [lowest, highest] = range(body, [&](const Vector3& point) { return floor->height(point); });
    if (lowest >= -rounding) {
      return;
    }
    if (lowest + highest < -rounding) {
      mistakes_.add(where_of(acoustics_, around_.names[body]),
                    fmt::format("bodies.{}: more than half of it is behind radiation.floor, down to {:.3g} m; move one "
                                "of the two",
                                around_.names[body], -lowest));
      return;
    }
    warnings_.push_back(
        fmt::format("body {} reaches {:.3g} m behind radiation.floor, which has no meaning there; move one of the two",
                    around_.names[body], -lowest));
  }

  /// Walls reflect what is between them.
  void check_room(std::size_t body) {
    const auto& room = acoustics_.radiation.room;
    if (!room) {
      return;
    }
    const double farthest = range(body, [&](const Vector3& point) { return room->distance_outside(point); }).second;
    if (farthest > rounding) {
      mistakes_.add(where_of(acoustics_, around_.names[body]),
                    fmt::format("bodies.{}: reaches {:.3g} m out of radiation.room; move "
                                "it, or make the room larger",
                                around_.names[body], farthest));
    }
  }

  void check(const scene::Listener& listener, const std::string& channel, const std::vector<Moment>& moments) {
    if (check_inside(listener, channel, moments)) {
      return;
    }
    check_distance(channel, moments);
    if (hearing_ == Hearing::straight_ways) {
      check_ways(channel, moments.front().position);
    }
  }

  /// @return whether it is inside something at some time
  bool check_inside(const scene::Listener& listener, const std::string& channel, const std::vector<Moment>& moments) {
    for (const auto& [time, position] : moments) {
      for (std::size_t part = 0; part < around_.names.size(); ++part) {
        if (!around_.is_inside(part, position)) {
          continue;
        }
        const std::string inside = fmt::format("{} is inside {}", channel, around_.names[part]);
        if (time == 0.0) {
          mistakes_.add(listener.where,
                        fmt::format("listeners.{}: {}, where there is no air; move it outside", listener.name, inside));
        } else {
          warnings_.push_back(fmt::format(
              "listener {} at {:.3g} s, if that has not moved: there is no air, and the sound has no meaning", inside,
              time));
        }
        return true;
      }
    }
    return false;
  }

  /// Of the surface's triangles or the grid's cells, m.
  [[nodiscard]] double resolution(const Surroundings::Nearest& nearest) const {
    return hearing_ == Hearing::grid ? acoustics_.radiation.grid.cell : nearest.edge;
  }

  void check_distance(const std::string& channel, const std::vector<Moment>& moments) {
    if (hearing_ == Hearing::exact) {
      return;
    }
    const double reach = acoustics_.radiation.air.speed / parts_of_wavelength;  // m Hz
    const bool obstacles_scatter = hearing_ == Hearing::grid;
    const std::size_t parts = obstacles_scatter ? around_.names.size() : around_.bodies;
    for (std::size_t part = 0; part < parts; ++part) {
      Surroundings::Nearest nearest{.distance = std::numeric_limits<double>::infinity()};
      for (const Moment& moment : moments) {
        const Surroundings::Nearest now = around_.nearest(part, moment.position);
        nearest = now.distance < nearest.distance ? now : nearest;
      }
      if (nearest.distance >= std::max(reach / near_frequency, resolution(nearest))) {
        continue;
      }
      const double frequency = std::min(reach / nearest.distance, acoustics_.audio.max_frequency);
      warnings_.push_back(fmt::format(
          "listener {} is {:.3g} m from {}: nearer than a twentieth of a wavelength of all sound up to {:.0f} Hz, "
          "where levels can be wrong (the {} there are {:.3g} m long); move it away, or let idiophone radiate "
          "compute the pressure (docs/use/listeners.md)",
          channel, nearest.distance, around_.names[part], frequency, hearing_ == Hearing::grid ? "cells" : "triangles",
          resolution(nearest)));
    }
  }

  void check_ways(const std::string& channel, const Vector3& position) {
    for (std::size_t body = 0; body < around_.bodies; ++body) {
      for (std::size_t part = 0; part < around_.names.size(); ++part) {
        const double share = part == body ? 0.0 : around_.share_behind(part, body, position);
        if (share <= 0.5) {
          continue;
        }
        warnings_.push_back(fmt::format(
            "{} stands in the way from {:.0f} % of {} to listener {}: {}. Radiation model waves bends sound around it",
            around_.names[part], 100.0 * share, around_.names[body], channel,
            acoustics_.radiation.visibility ? "it blocks that sound at all frequencies"
                                            : "without radiation.visibility that sound goes through it"));
      }
    }
  }

  static constexpr double rounding = 1e-9;  // m

  const scene::Acoustics& acoustics_;
  const Surroundings& around_;
  Hearing hearing_;
  deck::Mistakes mistakes_;
  std::vector<std::string> warnings_;
};

}  // namespace

Hearing hearing_of(const scene::Radiation& radiation) {
  return radiation.model == scene::RadiationModel::waves ? Hearing::grid : Hearing::straight_ways;
}

std::vector<std::string> placement_warnings(const scene::Acoustics& acoustics, const Surroundings& around,
                                            Hearing hearing) {
  return Placement(acoustics, around, hearing).warnings();
}

}  // namespace idiophone::propagation
