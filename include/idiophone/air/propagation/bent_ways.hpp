#pragma once
// The ways of sound around edges, from each triangle to each receiver, while bodies move.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/propagation/diffracting_edges.hpp"
#include "idiophone/air/propagation/folded_sight.hpp"
#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/air/receivers/edge_filters.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::propagation {

/// The way around one edge or several in turn; see radiation::Bend.
struct BentWay {
  std::array<Vector3, 2> apexes = {Vector3::Zero(), Vector3::Zero()};  ///< the first and the last, m
  double between = 0.0;                                                ///< way from the first to the last, m
  double gain = 0.0;                                                   ///< 0: there is no such way
  receivers::WavesInTurn waves = receivers::no_edges;
};

/// Found at updates of the visibility, and crossed over in step with it. Ways have the numbers of DiffractingEdges.
class BentWays {
 public:
  /// A propagation path that bends.
  struct Path {
    std::size_t number;               ///< 0: the direct one
    std::vector<std::size_t> copies;  ///< of the edges, that it bends around
  };
  struct Options {
    double speed = 343.0;     ///< of sound, m/s
    int rate = 44100;         ///< audio samples per second
    std::vector<Path> paths;  ///< to each receiver
  };
  BentWays(Options options, std::size_t receivers, std::size_t triangles);

  /// Finds the next ways. A way exists where each edge is seen by what comes before and after it, above the floor and
  /// inside the room.
  /// @param triangles  this rank's: global numbers
  /// @param ends       [receivers x paths] of receivers and of their mirror images, m
  /// @param paths      how many lead to a receiver, also those that do not bend
  void find(const DiffractingEdges& edges, const FoldedSight& sight, std::span<const Index> triangles,
            std::span<const Vector3> ends, std::size_t paths);
  /// Begins with the next ways, as if they had always been.
  void start();
  /// Goes on to the next ones.
  void advance();

  /// The ways by which any triangle is heard until the next update: ascending numbers.
  [[nodiscard]] std::span<const std::int64_t> heard(std::size_t receiver, std::size_t path) const;

  /// @param weight  0 to 1 from one update to the next
  /// @param way     one of heard()
  [[nodiscard]] BentWay at(double weight, std::size_t receiver, std::size_t path, std::int64_t way,
                           std::size_t triangle) const;

  /// All ways. Collective.
  /// @param triangles  the rows that those of this rank are
  void archive(parallel::Archive& archive, const parallel::Rows& triangles);

 private:
  using WaysToEnd = std::map<std::int64_t, std::vector<BentWay>>;  ///< by their numbers, [triangles]
  using Ways = std::vector<WaysToEnd>;                             ///< [receivers x bent paths]

  [[nodiscard]] std::optional<std::size_t> place_of(std::size_t receiver, std::size_t path) const;
  /// Finds the ways around one sequence of edges.
  void find_around(const DiffractingEdges& edges, const radiation::EdgeSequence& sequence, std::size_t copy,
                   const FoldedSight& sight, std::span<const Index> triangles, const Vector3& end,
                   WaysToEnd& found) const;
  [[nodiscard]] BentWay numbered(const radiation::Bend& bend, std::size_t count) const;
  void note_heard();

  Options options_;
  std::size_t triangles_;
  Ways from_, to_, next_;
  std::vector<std::vector<std::int64_t>> heard_;  ///< [receivers x bent paths]
};

}  // namespace idiophone::propagation
