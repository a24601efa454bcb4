#pragma once
// A body that moves by its modes, or as finite elements of the same mesh, for comparisons of both.

#include <memory>
#include <optional>

#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/measure.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {

/// A block by itself on this rank, which moves as finite elements or by its modes.
struct Moving {
  /// @param stretching_tolerance  see scene::ModalModel
  explicit Moving(VibratingBody block, int count, std::optional<double> stretching_tolerance = {})
      : body(std::move(block)) {
    body.scene.bodies[0].modal = scene::ModalModel{
        .up_to = {}, .count = count, .stretching_tolerance = stretching_tolerance, .where = {"deck.yaml", 3, 5}};
  }

  /// A half-sine force on the nodes of a group.
  void push(const std::string& group, const Vector3& force, double duration) {
    scene::ForcePulse pulse;
    pulse.force = force;
    pulse.signal.duration = duration;
    body.scene.pulses.push_back(pulse);
    const auto& nodes = body.mesh.groups.at(group);
    pushed.push_back({nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))});
  }

  void prepare() {
    part = support::whole_part(body.mesh);
    attachments = motion::Attachments{};
    attachments.bodies.resize(1);
    for (const auto& fixed : body.scene.bodies[0].fixed) {
      attachments.bodies[0].fixed.push_back({body.mesh.groups.at(fixed.group), {}});
    }
    attachments.pulses = pushed;
    basis[0] = modal_basis(body.scene, 0, body.mesh, pushed.empty() ? std::vector<Index>{} : pushed[0].nodes);
  }

  /// @param most_at_once  steps that a body may take at once where nothing but supports acts on it
  [[nodiscard]] std::unique_ptr<motion::Motion> begin(double step, const modal_bodies::ModalBases& bases,
                                                      int most_at_once = 1) {
    auto motion =
        std::make_unique<motion::Motion>(body.scene, part, attachments, contact_surfaces, step, 8, MPI_COMM_SELF,
                                         modal_bodies::modal_models(body.scene, bases), most_at_once);
    initial_state = motion::mass_properties(motion->dynamics(), part);
    motion->start(initial_state.centres, {});
    return motion;
  }

  /// Coordinate of a mode in the present displacements, for a body that does not turn.
  [[nodiscard]] double coordinate(motion::Motion& motion, std::size_t mode) const {
    motion.update_nodes();
    const modal_bodies::ModalBasis& by = basis.at(0);
    const std::size_t nodes = by.nodes();
    double sum = 0.0;
    for (std::size_t node = 0; node < nodes; ++node) {
      const Eigen::Map<const Vector3> shape(&by.shapes[3 * (mode * nodes + node)]);
      sum += by.masses[node] * shape.dot(Eigen::Map<const Vector3>(motion.state()[node].displacement));
    }
    return sum;
  }

  [[nodiscard]] motion::BodyMotion observe(motion::Motion& motion) const {
    return motion::body_motion(motion::measure(motion, initial_state)[0], initial_state, 0);
  }

  VibratingBody body;
  mesh::Part part;
  motion::Attachments attachments;
  std::vector<mesh::Patch> pushed;
  contact::ContactSurfaces contact_surfaces;
  motion::InitialState initial_state;
  modal_bodies::ModalBases basis;
};

/// Largest difference of a mode's coordinate between both models in a part of a second, relative to its amplitude.
/// @param step    of the finite elements, s
/// @param stride  a modal step in these
inline double difference(Moving& moving, std::size_t mode, double seconds, double step = 2e-7, int stride = 10) {
  const auto elements = moving.begin(step, {});
  const auto modal = moving.begin(step * stride, moving.basis);
  double amplitude = 0.0;
  double worst = 0.0;
  for (int n = 0; n * step * stride < seconds; ++n) {
    for (int i = 0; i < stride; ++i) {
      elements->advance();
    }
    modal->advance();
    const double expected = moving.coordinate(*elements, mode);
    amplitude = std::max(amplitude, std::abs(expected));
    worst = std::max(worst, std::abs(moving.coordinate(*modal, mode) - expected));
  }
  return worst / amplitude;
}

}  // namespace idiophone::eigenmodes
