#pragma once
// Bodies that joints tie together, for tests of modes.

#include <algorithm>
#include <memory>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/motion/dynamics.hpp"
#include "idiophone/solids/motion/stable_step.hpp"

namespace idiophone::eigenmodes {

/// Blocks of steel, and joints between them. Add blocks and joints, then find().
struct Assembly {
  Assembly() { scene.materials = {{"steel", 2e11, 0.3, 7850, {0, 0}, {}}}; }

  void add(mesh::Mesh block, const Vector3& shift) {
    for (Vector3& node : block.nodes) {
      node += shift;
    }
    scene::Body& body = scene.bodies.emplace_back();
    body.name = "block";
    body.element = block.element;
    meshes.push_back(std::move(block));
  }

  /// The first body to the second one.
  void join(const std::string& first, const std::string& second, std::optional<scene::JointStiffness> stiffness,
            double damping = 0.0) {
    scene::Joint& joint = scene.joints.emplace_back();
    joint.name = "joint";
    joint.surfaces = {scene::JoinedSurface{0, first, {}}, scene::JoinedSurface{1, second, {}}};
    joint.stiffness = stiffness;
    joint.damping = damping;
  }

  [[nodiscard]] Modes find(int count, MPI_Comm communicator = MPI_COMM_WORLD) const {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    const motion::Attachments attachments =
        motion::broadcast(rank == 0 ? motion::attach(scene, meshes) : motion::Attachments{}, scene, communicator);
    const mesh::Part part = mesh::distribute(meshes, communicator, joints::coupled_nodes(attachments.joints));
    return find_modes(scene, part, attachments, {.count = count}, communicator);
  }

  std::vector<mesh::Mesh> meshes;
  scene::Scene scene;
};

/// The step of the bodies that is stable, s: of their models, or of the finite elements of those without one.
/// @param models  also of bodies that have modes in common, whose models know each other
[[nodiscard]] inline double stable_step(const Assembly& bodies, const mesh::Part& part,
                                        const motion::Attachments& attachments, const motion::ModelMaker& models) {
  const motion::FiniteElementDynamics elements(bodies.scene, part, attachments);
  const motion::Supports supports = motion::supports_of(part, elements);
  std::vector<std::unique_ptr<motion::BodyModel>> made;
  for (std::size_t body = 0; body < bodies.meshes.size(); ++body) {
    made.push_back(models(part, body));
  }
  double step = 1.0;
  for (std::size_t body = 0; body < made.size(); ++body) {
    const motion::BodyModel& model = made[body] ? *made[body] : elements.model(body);
    step = std::min(step, model.stable_step(supports, {}).step);
  }
  return step;
}

}  // namespace idiophone::eigenmodes
