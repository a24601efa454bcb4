#include "idiophone/run/record/frame_recorder.hpp"

#include <cmath>

namespace idiophone::record {

bool is_frame_due(const scene::Scene& scene, std::int64_t moved) {
  const double per_sample = scene.output.frames_per_second / scene.audio.rate;
  const bool is_due = moved == 0 || std::floor(static_cast<double>(moved) * per_sample) >
                                        std::floor(static_cast<double>(moved - 1) * per_sample);
  return moved >= 0 && moved <= bodies::sound_samples(scene) && is_due;
}

FrameRecorder::FrameRecorder(const bodies::Preparation& ready, bodies::FiniteElementSource& source,
                             results::ResultFile& result, MPI_Comm communicator)
    : ready_(ready), source_(source), result_(result) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    bodies_.emplace_back(ready.scene.bodies[b].name, ready.part, ready.offsets, b, communicator);
  }
}

void FrameRecorder::declare() {
  for (const StoredBody& body : bodies_) {
    body.add_mesh(result_);
  }
}

void FrameRecorder::note(std::int64_t sample, const surface::SurfaceMotion& /*motion*/) {
  // The surface's motion is that of the bodies some audio samples ago: low-passes look ahead.
  const std::int64_t moved = sample - source_.first_sample();
  if (!is_frame_due(ready_.scene, moved)) {
    return;
  }
  Frame& frame = frames_.emplace_back();
  frame.time = static_cast<double>(moved) / ready_.scene.audio.rate;
  const auto& states = source_.node_states();
  for (const auto& body : ready_.part.bodies) {
    auto& displacement = frame.displacement.emplace_back();
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const auto& u = states[node].displacement;
      displacement.insert(displacement.end(), u, u + 3);
    }
  }
}

void FrameRecorder::write() {
  for (const Frame& frame : frames_) {
    std::vector<results::BodyFrame> bodies;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      bodies.push_back({bodies_[b].name(), &bodies_[b].nodes(), frame.displacement[b]});
    }
    result_.add_frame(frame.time, bodies);
  }
  frames_.clear();
}

}  // namespace idiophone::record
