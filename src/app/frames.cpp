#include "frames.hpp"

#include <cmath>

namespace idiophone::app {

namespace {

/// Numbers within the body of what this rank owns of it.
store::Rows body_nodes(const Preparation& ready, std::size_t b, MPI_Comm communicator) {
  const auto& body = ready.part.bodies[b];
  std::vector<Index> numbers;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    numbers.push_back(ready.part.node_ids[static_cast<std::size_t>(node)] - ready.offsets.nodes[b]);
  }
  return {numbers, ready.offsets.nodes[b + 1] - ready.offsets.nodes[b], communicator};
}

store::Rows body_elements(const Preparation& ready, std::size_t b, MPI_Comm communicator) {
  const auto& body = ready.part.bodies[b];
  std::vector<Index> numbers;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    if (body.owned[e] != 0) {
      numbers.push_back(body.element_ids[e] - ready.offsets.elements[b]);
    }
  }
  return {numbers, ready.offsets.elements[b + 1] - ready.offsets.elements[b], communicator};
}

/// Node numbers within the body of its owned elements, [nodes per element x owned elements].
std::vector<Index> connectivity(const Preparation& ready, std::size_t b) {
  const auto& body = ready.part.bodies[b];
  const auto width = static_cast<std::size_t>(mesh::nodes_per_element(body.element));
  std::vector<Index> nodes;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    for (std::size_t a = 0; a < width && body.owned[e] != 0; ++a) {
      const auto local = static_cast<std::size_t>(body.elements[e * width + a]);
      nodes.push_back(ready.part.node_ids[local] - ready.offsets.nodes[b]);
    }
  }
  return nodes;
}

}  // namespace

Frames::Frames(const Preparation& ready, MPI_Comm communicator) : ready_(ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    node_rows_.push_back(body_nodes(ready, b, communicator));
    element_rows_.push_back(body_elements(ready, b, communicator));
  }
}

void Frames::declare(store::ResultFile& result) const {
  if (ready_.scene.output.frames_per_second == 0) {
    return;
  }
  for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
    const auto& body = ready_.part.bodies[b];
    std::vector<double> reference;
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const Vector3& x = ready_.part.reference[static_cast<std::size_t>(node)];
      reference.insert(reference.end(), x.begin(), x.end());
    }
    result.add_mesh(ready_.scene.bodies[b].name, node_rows_[b], reference, element_rows_[b], connectivity(ready_, b),
                    mesh::nodes_per_element(body.element));
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
    for (std::size_t b = 0; b < node_rows_.size(); ++b) {
      bodies.push_back({ready_.scene.bodies[b].name, &node_rows_[b], frame.displacement[b]});
    }
    result.add_frame(frame.time, bodies);
  }
  frames_.clear();
}

}  // namespace idiophone::app
