#pragma once
// A scene of one block on one rank, for tests of motion.

#include <gtest/gtest.h>

#include <memory>

#include "block_mesh.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "memory_archive.hpp"

namespace idiophone::motion {

/// Fill in the scene, then begin().
struct Laboratory {
  explicit Laboratory(mesh::Mesh block) : mesh(std::move(block)), part(support::whole_part(mesh)) {
    scene.materials = {{"rubber", 1e6, 0.3, 1000, {0, 0}, {}}};
    scene.bodies.resize(1);
    scene.bodies[0].element = mesh.element;
    attachments.bodies.resize(1);
  }

  void fix(const std::string& group) {
    scene.bodies[0].fixed.push_back({.group = group, .axes = {true, true, true}, .hinge = false, .where = {}});
    attachments.bodies[0].fixed.push_back({mesh.groups.at(group), {}});
  }

  /// A half-sine force shared evenly by the nodes of a group.
  void push(const std::string& group, const Vector3& force, double duration) {
    scene::ForcePulse pulse;
    pulse.force = force;
    pulse.signal.duration = duration;
    scene.pulses.push_back(pulse);
    const auto& nodes = mesh.groups.at(group);
    attachments.pulses.push_back({nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))});
    Vector3& point = attachments.pulse_points.emplace_back(Vector3::Zero());
    for (const Index node : nodes) {
      point += mesh.nodes[node] / static_cast<double>(nodes.size());
    }
  }

  Motion& begin(double step, std::span<const double> displacement = {}) {
    motion = std::make_unique<Motion>(scene, part, attachments, contact_surfaces, step, 16, MPI_COMM_SELF,
                                      finite_elements_only, 1, accelerator);
    initial_state = mass_properties(motion->dynamics(), part);
    motion->balance_loads(initial_state);
    motion->start(initial_state.centres, displacement);
    return *motion;
  }

  void advance(int steps) const {
    for (int i = 0; i < steps; ++i) {
      motion->advance();
    }
  }

  /// All state of a motion that is spread over nodes and elements.
  [[nodiscard]] static std::map<std::string, std::vector<double>> saved(Motion& which) {
    support::MemoryArchive archive(MPI_COMM_SELF);
    which.archive(archive, which.step_number());
    return archive.blocks;
  }

  /// Lets a motion go on where this one is, as if it had done so many steps.
  void go_on(Motion& other, std::int64_t step_number) const {
    support::MemoryArchive archive(MPI_COMM_SELF);
    motion->archive(archive, step_number);
    archive.restore();
    other.archive(archive, step_number);
  }

  /// Begins at time 0 with these displacements, m, and velocities, m/s: [6 x nodes].
  void put(const std::vector<double>& rows) const {
    support::MemoryArchive archive(MPI_COMM_SELF);
    motion->archive(archive, 0);
    archive.blocks.at("motion/nodes") = rows;
    archive.restore();
    motion->archive(archive, 0);
  }

  [[nodiscard]] BodyMotion observe() const { return body_motion(measure(*motion, initial_state)[0], initial_state, 0); }

  [[nodiscard]] Vector3 displacement(std::size_t node) const {
    return Eigen::Map<const Vector3>(motion->state()[node].displacement);
  }

  mesh::Mesh mesh;
  mesh::Part part;
  scene::Scene scene;
  Attachments attachments;
  contact::ContactSurfaces contact_surfaces;
  accelerator::Accelerator* accelerator = nullptr;  ///< which steps the body; null: the processor does
  InitialState initial_state;
  std::unique_ptr<Motion> motion;
};

/// A motion that goes on from the state that another one has after so many steps ends in the same bits as that.
inline void expect_a_saved_state_to_go_on(Laboratory& lab, double step, int steps) {
  lab.begin(step);
  lab.advance(steps);
  Motion other(lab.scene, lab.part, lab.attachments, lab.contact_surfaces, step, 16, MPI_COMM_SELF,
               finite_elements_only, 1, lab.accelerator);
  lab.go_on(other, lab.motion->step_number());
  for (int i = 0; i < steps; ++i) {
    (void)lab.observe();  // measuring changes nothing
    lab.motion->advance();
    other.advance();
  }
  EXPECT_EQ(Laboratory::saved(*lab.motion), Laboratory::saved(other));
  EXPECT_EQ(lab.motion->work().value(), other.work().value());
}

}  // namespace idiophone::motion
