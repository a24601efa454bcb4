#pragma once
// All edges that sound bends around: those of screens, and on demand those of obstacles and bodies.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/air/radiation/edge_sequences.hpp"
#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/air/radiation/solid_edges.hpp"
#include "idiophone/air/radiation/visibility.hpp"

namespace idiophone::propagation {

/// Where ways around edges can be: all sequences of edges, and their mirror images in planes that reflect. Copy 0 of
/// the edges are the real ones, copy 1 those in the first mirror.
class DiffractingEdges {
 public:
  struct Options {
    std::vector<radiation::DiffractingEdge> screens;       ///< their edges
    bool solids = false;                                   ///< whether obstacles and bodies have edges
    std::vector<std::array<Vector3, 3>> obstacles = {};    ///< their triangles, m
    std::vector<radiation::ReflectingPlane> mirrors = {};  ///< of the edges
  };

  /// @throws std::runtime_error if there are so many edges or sequences that the search for ways would take too long
  DiffractingEdges(const Options& options, const radiation::Visibility& bodies);

  /// Takes edges to where the bodies are.
  /// @throws as the constructor
  void follow(const radiation::Visibility& bodies);

  [[nodiscard]] const std::vector<radiation::EdgeSequence>& sequences() const { return sequences_; }

  /// The edges of a sequence.
  [[nodiscard]] radiation::EdgesInTurn placed(const radiation::EdgeSequence& sequence, std::size_t copy) const;

  /// The mirror image of a place that a copy has of the real one, and that the real one has of a copy's.
  [[nodiscard]] Vector3 mirrored(const Vector3& place, std::size_t copy) const;

  /// A number that is always the same for the same edges.
  [[nodiscard]] static std::int64_t number(const radiation::EdgeSequence& sequence, std::size_t copy);
  [[nodiscard]] static std::size_t copy_of(std::int64_t number);

  /// Whether a way is around the body that a triangle belongs to: what that body does to its own sound is up to the
  /// radiation model.
  /// @param triangle  global number
  [[nodiscard]] bool is_own(const radiation::EdgeSequence& sequence, Index triangle) const;

 private:
  struct Triangles {
    Index first = 0, last = 0;  ///< from, and one past; none of what does not sound
  };
  struct Moving {
    std::size_t number;  ///< of the edge
    radiation::SolidEdge edge;
  };
  void add_obstacles(const std::vector<std::array<Vector3, 3>>& obstacles);
  void add_bodies(const radiation::Visibility& bodies);
  void find_sequences();

  std::vector<radiation::DiffractingEdge> edges_;
  std::vector<std::size_t> objects_;  ///< [edges] 0: a screen or an obstacle; 1: the first body
  std::vector<Triangles> own_;        ///< [objects]
  std::vector<Moving> moving_;
  std::vector<radiation::EdgeSequence> sequences_;
  std::vector<radiation::ReflectingPlane> mirrors_;
};

}  // namespace idiophone::propagation
