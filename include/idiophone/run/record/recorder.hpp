#pragma once
// What is written during a run besides the sound. Each recorder keeps what it noted until the end of the block, so that
// no rank waits for another inside a block.

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::record {

class Recorder {
 public:
  Recorder() = default;
  virtual ~Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  Recorder(Recorder&&) = delete;
  Recorder& operator=(Recorder&&) = delete;

  /// Declares what it will write in new files. Collective.
  virtual void declare() = 0;

  /// The run begins or goes on: all tables are there, and all state is restored. Collective.
  virtual void begin() {}

  /// Notes what is due after the steady motion, or after an audio sample. No communication.
  /// @param sample  audio sample that the surface's motion belongs to
  virtual void note(std::int64_t sample, const surface::SurfaceMotion& motion) = 0;

  /// Writes all that was noted since the last call. Collective, at the end of a block.
  virtual void write() = 0;

  /// Writes what is made of the whole run when everything else is written. Collective.
  virtual void finish() {}

  /// All that decides the future when everything is written; restoring takes the place of declare(). Collective.
  virtual void archive(parallel::Archive& archive) = 0;

  /// Audio samples that it can note before it has to write. The same on all ranks.
  [[nodiscard]] virtual std::int64_t longest_block() const { return std::numeric_limits<std::int64_t>::max(); }
};

using Recorders = std::vector<std::unique_ptr<Recorder>>;

}  // namespace idiophone::record
