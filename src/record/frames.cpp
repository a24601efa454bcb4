#include "idiophone/record/frames.hpp"

#include <cmath>

namespace idiophone::record {

Frames::Frames(const source::Preparation& ready, MPI_Comm communicator) : ready_(ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    bodies_.emplace_back(ready.scene.bodies[b].name, ready.part, ready.offsets, b, communicator);
  }
}

void Frames::declare(store::ResultFile& result) const {
  if (ready_.scene.output.frames_per_second == 0) {
    return;
  }
  for (const StoredBody& body : bodies_) {
    body.add_mesh(result);
  }
}

void Frames::note(std::int64_t sample, const motion::Motion& motion) {
  const double per_sample = ready_.scene.output.frames_per_second / ready_.scene.audio.rate;
  const bool due = sample == 0 || std::floor(static_cast<double>(sample) * per_sample) >
                                      std::floor(static_cast<double>(sample - 1) * per_sample);
  if (per_sample == 0 || !due) {
    return;
  }
  Frame& frame = frames_.emplace_back();
  frame.time = static_cast<double>(sample) / ready_.scene.audio.rate;
  for (const auto& body : ready_.part.bodies) {
    auto& displacement = frame.displacement.emplace_back();
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const auto& u = motion.state()[static_cast<std::size_t>(node)].displacement;
      displacement.insert(displacement.end(), u, u + 3);
    }
  }
}

void Frames::write(store::ResultFile& result) {
  for (const Frame& frame : frames_) {
    std::vector<store::BodyFrame> bodies;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      bodies.push_back({bodies_[b].name(), &bodies_[b].nodes(), frame.displacement[b]});
    }
    result.add_frame(frame.time, bodies);
  }
  frames_.clear();
}

}  // namespace idiophone::record
