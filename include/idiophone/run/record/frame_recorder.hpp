#pragma once
// The moving mesh for ParaView and films: all nodes' displacements at the frame rate.

#include <mpi.h>

#include <vector>

#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/record/recorder.hpp"
#include "idiophone/run/record/stored_body.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::record {

/// Whether a frame is due when the bodies have moved so many audio samples; the first one is due before they move.
[[nodiscard]] bool is_frame_due(const scene::Scene& scene, std::int64_t moved);

class FrameRecorder : public Recorder {
 public:
  /// Collective.
  /// @param ready, source, result  must outlive this object
  FrameRecorder(const bodies::Preparation& ready, bodies::FiniteElementSource& source, results::ResultFile& result,
                MPI_Comm communicator);

  void declare() override;
  void note(std::int64_t sample, const surface::SurfaceMotion& motion) override;
  void write() override;
  /// The result archives its lengths.
  void archive(parallel::Archive& /*archive*/) override {}

 private:
  struct Frame {
    double time = 0.0;                              ///< s
    std::vector<std::vector<double>> displacement;  ///< [bodies][3 x owned nodes], m
  };

  const bodies::Preparation& ready_;
  bodies::FiniteElementSource& source_;
  results::ResultFile& result_;
  std::vector<StoredBody> bodies_;
  std::vector<Frame> frames_;  ///< not yet written
};

}  // namespace idiophone::record
