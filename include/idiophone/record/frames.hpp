#pragma once
// The moving meshes, at the frame rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/motion/motion.hpp"
#include "idiophone/record/stored_body.hpp"
#include "idiophone/source/preparation.hpp"
#include "idiophone/store/result_file.hpp"

namespace idiophone::record {

class Frames {
 public:
  Frames(const source::Preparation& ready, MPI_Comm communicator);

  /// Adds the meshes to a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// Notes a frame if one is due at an audio sample. No communication.
  void note(std::int64_t sample, const motion::Motion& motion);

  /// Writes all frames noted since the last writing. Collective.
  void write(store::ResultFile& result);

 private:
  struct Frame {
    double time = 0.0;                              ///< s
    std::vector<std::vector<double>> displacement;  ///< [bodies][3 x owned nodes], m
  };

  const source::Preparation& ready_;
  std::vector<StoredBody> bodies_;
  std::vector<Frame> frames_;  ///< not yet written
};

}  // namespace idiophone::record
