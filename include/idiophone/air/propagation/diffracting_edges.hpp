#pragma once
// All edges that sound bends around: those of screens, and on demand those of obstacles and bodies.

#include <array>
#include <optional>
#include <vector>

#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/air/radiation/solid_edges.hpp"
#include "idiophone/air/radiation/visibility.hpp"

namespace idiophone::propagation {

/// A way around is by one edge, or by a pair of edges of one face in turn. Ways are numbered: edges, then pairs, then
/// the same of the mirror images in a floor, by which sound goes between points above it by two reflections.
class DiffractingEdges {
 public:
  struct Options {
    std::vector<radiation::DiffractingEdge> screens;       ///< their edges
    bool solids = false;                                   ///< whether obstacles and bodies have edges
    std::vector<std::array<Vector3, 3>> obstacles = {};    ///< their triangles, m
    std::optional<radiation::ReflectingPlane> floor = {};  ///< that mirrors all edges
  };

  /// @throws std::runtime_error if the solids have so many edges that the search for ways would take too long
  DiffractingEdges(const Options& options, const radiation::Visibility& bodies);

  /// Takes edges to where the bodies are.
  void follow(const radiation::Visibility& bodies);

  [[nodiscard]] std::size_t ways() const { return (floor_ ? 2 : 1) * real_ways(); }
  [[nodiscard]] bool is_pair(std::size_t way) const { return way % real_ways() >= edges_.size(); }
  [[nodiscard]] bool is_mirrored(std::size_t way) const { return way >= real_ways(); }
  [[nodiscard]] radiation::DiffractingEdge edge(std::size_t way) const;
  /// The edges of a pair, turned as radiation::find_double_bend() needs them.
  [[nodiscard]] std::array<radiation::DiffractingEdge, 2> pair(std::size_t way) const;

  /// Whether a way is around the body that a triangle belongs to: what that body does to its own sound is up to the
  /// radiation model.
  /// @param triangle  global number
  [[nodiscard]] bool is_own(std::size_t way, Index triangle) const;

 private:
  [[nodiscard]] std::size_t real_ways() const { return edges_.size() + pairs_.size(); }
  /// The pair that a way goes around.
  [[nodiscard]] const radiation::EdgePair& pair_of(std::size_t way) const {
    return pairs_[way % real_ways() - edges_.size()];
  }
  [[nodiscard]] radiation::DiffractingEdge mirrored(radiation::DiffractingEdge edge) const;

  struct Owner {
    Index first = 0, last = 0;  ///< triangles of the body; none of a screen or an obstacle
  };
  struct Moving {
    std::size_t number;  ///< of the edge
    radiation::SolidEdge edge;
  };
  void add_obstacles(const std::vector<std::array<Vector3, 3>>& obstacles);
  void add_bodies(const radiation::Visibility& bodies);
  /// Of the edges from a number on, which are one object's.
  void add_pairs(std::size_t first);

  std::vector<radiation::DiffractingEdge> edges_;
  std::vector<Owner> owners_;  ///< [edges]
  std::vector<Moving> moving_;
  std::vector<radiation::EdgePair> pairs_;
  std::optional<radiation::ReflectingPlane> floor_;
};

}  // namespace idiophone::propagation
