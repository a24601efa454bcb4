#include "given_velocities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "idiophone/foundation/deck/csv.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "velocity_file.hpp"

namespace idiophone::harmonic {

namespace {

/// The vertices of a body, by their places.
class Vertices {
 public:
  Vertices(const AcousticSurface& surface, std::size_t body) : places_(surface.boundary.vertices) {
    const auto first = surface.boundary.triangles.begin();
    for (auto at = first + surface.first_triangle[body]; at != first + surface.first_triangle[body + 1]; ++at) {
      numbers_.insert(numbers_.end(), at->begin(), at->end());
      const Vector3 &a = places_[(*at)[0]], &b = places_[(*at)[1]], &c = places_[(*at)[2]];
      shortest_edge_ = std::min({shortest_edge_, (a - b).norm(), (b - c).norm(), (c - a).norm()});
    }
    keep_each_once(numbers_);
  }

  [[nodiscard]] const std::vector<Index>& numbers() const { return numbers_; }
  [[nodiscard]] const Vector3& place(Index number) const { return places_[number]; }

  /// Reports a place that is farther from all vertices than a hundredth of the shortest edge.
  Index find(const VelocityRow& row, deck::Mistakes& mistakes) {
    const auto [known, is_new] = found_.try_emplace({row.place.x(), row.place.y(), row.place.z()}, 0);
    if (is_new) {
      const auto distance = [&](Index number) { return (places_[number] - row.place).norm(); };
      known->second = std::ranges::min(numbers_, {}, distance);
      if (distance(known->second) > 0.01 * shortest_edge_) {
        const Vector3& nearest = places_[known->second];
        mistakes.add(row.where,
                     fmt::format("no vertex of the body is here; the nearest one is at {}, {}, {}, {:.3g} m away",
                                 nearest.x(), nearest.y(), nearest.z(), distance(known->second)));
      }
    }
    return known->second;
  }

 private:
  const std::vector<Vector3>& places_;
  std::vector<Index> numbers_;
  std::map<std::array<double, 3>, Index> found_;
  double shortest_edge_ = std::numeric_limits<double>::infinity();
};

/// Reports the first vertex that has no velocity at a frequency, and frequencies at which nothing moves.
void check_each_frequency(const std::map<double, VertexVelocities>& velocities, const Vertices& vertices,
                          const deck::Location& where, deck::Mistakes& mistakes) {
  if (velocities.empty()) {
    mistakes.add(where, "has no velocities");
  }
  for (const auto& [frequency, of_vertex] : velocities) {
    if (std::ranges::all_of(of_vertex, [](const auto& entry) { return entry.second.isZero(0.0); })) {
      mistakes.add(where, fmt::format("all velocities at {} Hz are 0", frequency));
    }
    for (const Index number : vertices.numbers()) {
      if (!of_vertex.contains(number)) {
        const Vector3& place = vertices.place(number);
        mistakes.add(where,
                     fmt::format("{} of {} vertices of the body have no row at {} Hz; the first is at {}, {}, {}",
                                 vertices.numbers().size() - of_vertex.size(), vertices.numbers().size(), frequency,
                                 place.x(), place.y(), place.z()));
        break;
      }
    }
  }
}

}  // namespace

std::map<double, VertexVelocities> read_velocities(const std::filesystem::path& file, const AcousticSurface& surface,
                                                   std::size_t body) {
  deck::Mistakes mistakes;
  const std::vector<VelocityRow> rows =
      file.extension() == ".h5" ? hdf5_velocities(file, mistakes) : csv_velocities(file, mistakes);
  mistakes.raise();
  Vertices vertices(surface, body);
  std::map<double, VertexVelocities> velocities;
  for (const VelocityRow& row : rows) {
    if (!(row.frequency > 0.0)) {
      mistakes.add(row.where, fmt::format("the frequency must be above 0 Hz, not {}", row.frequency));
    }
    const bool is_new = velocities[row.frequency].emplace(vertices.find(row, mistakes), row.velocity).second;
    if (!is_new) {
      mistakes.add(row.where, fmt::format("a row before has the same vertex at {} Hz", row.frequency));
    }
    if (mistakes.count() >= deck::most_mistakes_of_a_table) {
      break;
    }
  }
  mistakes.raise();
  check_each_frequency(velocities, vertices, {file.string(), 1, 1}, mistakes);
  mistakes.raise();
  return velocities;
}

}  // namespace idiophone::harmonic
