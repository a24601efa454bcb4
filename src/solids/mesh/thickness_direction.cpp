#include "thickness_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "checks.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// What an edge is.
enum class Role : std::uint8_t { unknown, across, in_plane };

using ElementEdges = std::array<std::array<std::size_t, 4>, 3>;  ///< [direction] the numbers of the parallel edges

/// Numbers the edges between corners.
struct Edges {
  explicit Edges(const Mesh& mesh) {
    const element::ReferenceElement& reference = element::reference(mesh.element);
    std::map<std::pair<Index, Index>, std::size_t> numbers;
    for (Index element = 0; element < mesh.element_count(); ++element) {
      const auto nodes = mesh.element_nodes(element);
      ElementEdges& mine = of_element.emplace_back();
      std::array<std::size_t, 3> found = {0, 0, 0};
      for (const auto& [a, b] : reference.edges) {
        int direction = 0;
        (reference.nodes[b] - reference.nodes[a]).cwiseAbs().maxCoeff(&direction);
        const std::pair<Index, Index> ends = std::minmax(nodes[a], nodes[b]);
        const auto [place, is_new] = numbers.emplace(ends, lengths.size());
        if (is_new) {
          lengths.push_back((mesh.nodes[ends.second] - mesh.nodes[ends.first]).norm());
        }
        mine[direction][found[direction]++] = place->second;
      }
    }
  }
  std::vector<ElementEdges> of_element;  ///< [elements]
  std::vector<double> lengths;           ///< [edges] m
};

/// The roles that follow when one direction of the first element is across.
class Choice {
 public:
  Choice(const Edges& edges, int first_direction) : edges_(edges), roles_(edges.lengths.size(), Role::unknown) {
    set(0, first_direction, Role::across);
    while (std::exchange(changed_, false)) {
      for (std::size_t element = 0; element < edges.of_element.size(); ++element) {
        conclude(element);
      }
    }
  }

  /// Elements without exactly one direction across.
  [[nodiscard]] std::vector<Index> contradictions() const {
    std::vector<Index> elements;
    for (std::size_t element = 0; element < edges_.of_element.size(); ++element) {
      if (!direction_of(element)) {
        elements.push_back(static_cast<Index>(element));
      }
    }
    return elements;
  }

  [[nodiscard]] std::vector<int> directions() const {
    std::vector<int> result;
    for (std::size_t element = 0; element < edges_.of_element.size(); ++element) {
      result.push_back(direction_of(element).value());
    }
    return result;
  }

  /// Of the edges across, m.
  [[nodiscard]] double mean_length() const {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t edge = 0; edge < roles_.size(); ++edge) {
      if (roles_[edge] == Role::across) {
        sum += edges_.lengths[edge];
        count += 1.0;
      }
    }
    return sum / count;
  }

 private:
  [[nodiscard]] bool all_are(std::size_t element, int direction, Role role) const {
    return std::ranges::all_of(edges_.of_element[element][direction],
                               [&](std::size_t edge) { return roles_[edge] == role; });
  }

  /// The one direction that is across, if the element has one.
  [[nodiscard]] std::optional<int> direction_of(std::size_t element) const {
    for (const int d : {0, 1, 2}) {
      if (all_are(element, d, Role::across) && all_are(element, (d + 1) % 3, Role::in_plane) &&
          all_are(element, (d + 2) % 3, Role::in_plane)) {
        return d;
      }
    }
    return std::nullopt;
  }

  /// Gives the edges a role that have none.
  void set(std::size_t element, int direction, Role role) {
    for (const std::size_t edge : edges_.of_element[element][direction]) {
      if (roles_[edge] == Role::unknown) {
        roles_[edge] = role;
        changed_ = true;
      }
    }
  }

  /// What follows in one element: parallel edges have the same role, and one direction of three is across.
  void conclude(std::size_t element) {
    std::array<Role, 3> found{};
    for (const int d : {0, 1, 2}) {
      for (const std::size_t edge : edges_.of_element[element][d]) {
        found[d] = std::max(found[d], roles_[edge], [](Role a, Role b) { return a == Role::unknown && a != b; });
      }
      if (found[d] != Role::unknown) {
        set(element, d, found[d]);
      }
    }
    for (const int d : {0, 1, 2}) {
      const Role next = found[(d + 1) % 3];
      const Role last = found[(d + 2) % 3];
      if (next == Role::in_plane && last == Role::in_plane) {
        set(element, d, Role::across);
      } else if (next == Role::across || last == Role::across) {
        set(element, d, Role::in_plane);
      }
    }
  }

  const Edges& edges_;
  std::vector<Role> roles_;  ///< [edges]
  bool changed_ = false;
};

}  // namespace

std::vector<int> thickness_directions(const scene::Body& body, const GmshMesh& geometry) {
  std::vector<int> last(geometry.element_tags.size(), 2);  // directions
  if (body.thickness) {
    return last;
  }
  const Edges edges(geometry.mesh);
  std::optional<Choice> best;
  std::vector<Index> contradictions;
  for (const int direction : {0, 1, 2}) {
    const Choice choice(edges, direction);
    const auto wrong = choice.contradictions();
    if (wrong.empty() && (!best || choice.mean_length() < best->mean_length())) {
      best.emplace(choice);
    }
    if (contradictions.empty() || wrong.size() < contradictions.size()) {
      contradictions = wrong;
    }
  }
  if (best) {
    return best->directions();
  }
  if (body.element.plane == body.element.thickness) {
    return last;
  }
  refuse_elements(body, geometry, contradictions,
                  fmt::format("has no direction through the thickness in which all elements agree, as orders {} and {} "
                              "need; give the same order for both, or mesh a surface and extrude it. Elements between "
                              "neighbours that differ",
                              body.element.plane, body.element.thickness));
}

}  // namespace idiophone::mesh
