#pragma once
// Which triangles each receiver sees while bodies move: positions go from every rank to every other, each rank traces
// the rays of its own triangles, and what it finds fades in (the delta of the paper's eq. 10).

#include <mpi.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/propagation/bent_ways.hpp"
#include "idiophone/air/propagation/diffracting_edges.hpp"
#include "idiophone/air/propagation/shared_positions.hpp"
#include "idiophone/air/radiation/paths.hpp"
#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::propagation {

/// An update at audio sample k n, n the interval, holds in full from sample (k + 2) n on: until (k + 1) n the positions
/// travel between the ranks, and then visibility goes linearly from the value before to the new one.
class LineOfSight {
 public:
  struct Options {
    std::int64_t interval = 1;  ///< between two updates, audio samples
    std::size_t receivers = 0;  ///< how many, mirror images apart
    radiation::SelfOcclusion self_occlusion = radiation::SelfOcclusion::included;
    std::vector<std::array<Vector3, 3>> screens = {};  ///< triangles that stand in the way beside the surface's, m
    DiffractingEdges::Options edges = {};              ///< the obstacles are the surface's
    BentWays::Options bends = {};                      ///< around these edges
    std::size_t paths = 1;          ///< to each receiver: the direct one, then those to mirror images of it
    scene::Radiation section = {};  ///< what paths are reflected by
  };

  /// Collective.
  /// @throws std::runtime_error when Embree fails, or as DiffractingEdges
  LineOfSight(const propagation::AudibleSurface& surface, const Options& options, MPI_Comm communicator);

  /// Begins as if all had stood where it is for ever. Waits for all ranks.
  /// @param ends  [receivers x paths] positions of receivers and of their mirror images, m
  void start(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends);

  /// Whether update() is to be called at an audio sample.
  [[nodiscard]] bool due(std::int64_t sample) const { return sample >= 0 && sample % options_.interval == 0; }

  /// Ends the update before and begins a new one: as all is at this audio sample. Waits for no more than that all ranks
  /// have begun the update before, an interval ago.
  void update(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends);

  /// Whether this is found for a path. All other paths are clear.
  [[nodiscard]] bool has(std::size_t path) const { return path < options_.paths; }

  /// Multiplies the gain of the ways along a path to a receiver by the visibility at an audio sample.
  void fade(std::int64_t sample, std::size_t receiver, std::size_t path, radiation::Paths& ways) const;

  /// This rank's.
  [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }

  /// Ways around edges along a path, in step with fade(): as BentWays::heard().
  [[nodiscard]] std::span<const std::int64_t> ways_heard(std::size_t receiver, std::size_t path) const {
    return bends_.heard(receiver, path);
  }

  /// One of them at an audio sample.
  [[nodiscard]] BentWay bend(std::int64_t sample, std::size_t receiver, std::size_t path, std::int64_t way,
                             std::size_t triangle) const {
    return bends_.at(weight(sample), receiver, path, way, triangle);
  }

  /// All that decides the future; ends the update under way, which changes nothing. Restoring takes the place of
  /// start(). Collective.
  /// @param triangles  the rows that those of this rank are
  void archive(parallel::Archive& archive, const parallel::Rows& triangles);

 private:
  using Seen = std::vector<std::vector<float>>;  ///< [receivers x paths][padded triangles] 0 or 1

  void begin(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends);
  void finish();
  /// How far it is from one update to the next, 0 to 1.
  [[nodiscard]] double weight(std::int64_t sample) const {
    return static_cast<double>(sample > 0 ? sample % options_.interval : 0) / static_cast<double>(options_.interval);
  }

  Options options_;
  std::vector<Index> triangles_;  ///< this rank's: global numbers
  SharedPositions shared_;
  radiation::Visibility visibility_;
  bool updating_ = false;      ///< an update was begun and not ended
  std::vector<Vector3> ends_;  ///< of the paths at that update, m
  Seen from_, to_, next_;      ///< at the interval's start and end, and at the next one's end
  DiffractingEdges edges_;
  BentWays bends_;
};

}  // namespace idiophone::propagation
