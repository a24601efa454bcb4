#pragma once
// The ways of sound around the edges of screens, from each triangle to each receiver, while bodies move.

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/radiation/screen_edge.hpp"
#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::propagation {

/// The way around one edge: the waves of the source and of its image (radiation::Bend).
struct BentWay {
  Vector3 apex = Vector3::Zero();      ///< m
  std::array<double, 2> gains = {};    ///< of radiation::EdgeWave; 0: there is none
  std::array<double, 2> numbers = {};  ///< of receivers::EdgeFilters, with fractions

  [[nodiscard]] bool is_silent() const { return gains[0] == 0.0 && gains[1] == 0.0; }
};

/// Found at updates of the visibility, and crossed over in step with it.
class BentWays {
 public:
  struct Options {
    std::vector<radiation::ScreenEdge> edges;
    double speed = 343.0;  ///< of sound, m/s
    int rate = 44100;      ///< audio samples per second
  };
  BentWays(Options options, std::size_t receivers, std::size_t triangles);

  [[nodiscard]] std::size_t edges() const { return options_.edges.size(); }

  /// Finds the next ways. A way exists where the edge is seen by both the triangle and the receiver.
  /// @param triangles  this rank's: global numbers
  /// @param receivers  their positions, m
  void find(const radiation::Visibility& visibility, std::span<const Index> triangles,
            std::span<const Vector3> receivers);
  /// Begins with the next ways, as if they had always been.
  void start();
  /// Goes on to the next ones.
  void advance();

  /// Whether any triangle is heard by way of an edge until the next update.
  [[nodiscard]] bool is_heard(std::size_t receiver, std::size_t edge) const {
    return heard_[receiver * edges() + edge];
  }

  /// @param weight  0 to 1 from one update to the next
  [[nodiscard]] BentWay at(double weight, std::size_t receiver, std::size_t edge, std::size_t triangle) const;

  /// All of a triangle.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  using Ways = std::vector<std::vector<BentWay>>;  ///< [receivers x edges][triangles]

  void note_heard();

  Options options_;
  Ways from_, to_, next_;
  std::vector<bool> heard_;  ///< [receivers x edges]
};

}  // namespace idiophone::propagation
