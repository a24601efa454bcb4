#pragma once
// The ways of sound around edges, from each triangle to each receiver, while bodies move.

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/propagation/diffracting_edges.hpp"
#include "idiophone/air/propagation/folded_sight.hpp"
#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::propagation {

/// The way around one edge, with the waves of the source and of its image (radiation::Bend), or around two edges in
/// turn, with one wave (radiation::DoubleBend).
struct BentWay {
  std::array<Vector3, 2> apexes = {Vector3::Zero(), Vector3::Zero()};  ///< the first and the last, m
  std::array<double, 2> gains = {};                                    ///< 0: there is no such wave
  std::array<double, 2> numbers = {};  ///< of receivers::EdgeFilters, with fractions: of each wave, or of each edge

  [[nodiscard]] bool is_silent() const { return gains[0] == 0.0 && gains[1] == 0.0; }
};

/// Found at updates of the visibility, and crossed over in step with it.
class BentWays {
 public:
  struct Options {
    double speed = 343.0;  ///< of sound, m/s
    int rate = 44100;      ///< audio samples per second
  };
  /// @param ways  of DiffractingEdges
  BentWays(Options options, std::size_t ways, std::size_t receivers, std::size_t triangles);

  [[nodiscard]] std::size_t ways() const { return ways_; }

  /// Finds the next ways. A way exists where the edge is seen by both the triangle and the receiver, and the edges of a
  /// pair by each other, above the floor and inside the room.
  /// @param triangles  this rank's: global numbers
  /// @param receivers  positions of receivers or of their mirror images, m
  void find(const DiffractingEdges& edges, const FoldedSight& sight, std::span<const Index> triangles,
            std::span<const Vector3> receivers);
  /// Begins with the next ways, as if they had always been.
  void start();
  /// Goes on to the next ones.
  void advance();

  /// Whether any triangle is heard by a way until the next update.
  [[nodiscard]] bool is_heard(std::size_t receiver, std::size_t way) const { return heard_[receiver * ways_ + way]; }

  /// @param weight  0 to 1 from one update to the next
  [[nodiscard]] BentWay at(double weight, std::size_t receiver, std::size_t way, std::size_t triangle) const;

  /// All of a triangle.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  using Ways = std::vector<std::vector<BentWay>>;  ///< [receivers x ways][triangles]

  [[nodiscard]] BentWay around_edge(const radiation::DiffractingEdge& edge, const FoldedSight& sight, Index triangle,
                                    const Vector3& receiver, bool mirrored) const;
  [[nodiscard]] BentWay around_pair(const std::array<radiation::DiffractingEdge, 2>& pair, const FoldedSight& sight,
                                    Index triangle, const Vector3& receiver, bool mirrored) const;
  [[nodiscard]] double number_of(double delay) const;
  void note_heard();

  Options options_;
  std::size_t ways_;
  Ways from_, to_, next_;
  std::vector<bool> heard_;  ///< [receivers x ways]
};

}  // namespace idiophone::propagation
